// SPDX-License-Identifier: Apache-2.0
#include "driver/history/measured_history.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::history {
namespace {

/// Reads to the end; the error that stops it, if any.
tl::expected<long, base::HistoryError> rows_of(const std::string& bytes,
                                               base::UnitConversion time = {},
                                               base::UnitConversion value = {}) {
  const TemporaryFolder folder;
  auto history = MeasuredHistory::open(
      {{folder.write("rig.csv", bytes), "rig.csv"}, "t", time, {{0, "x", value}}, false});
  if (!history) return tl::unexpected(history.error());
  long rows = 0;
  for (;; ++rows) {
    const auto row = history->advance();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return rows;
  }
}

TEST_CASE("a measured history yields its rows in the case's units") {
  const TemporaryFolder folder;
  const auto file = folder.write("rig.csv", "ms,load,note,disp\n-100,2,a,1\n0,4,b,2\n500,6,c,3\n");
  auto history = MeasuredHistory::open(
      {{file}, "ms", {0.001, 0.0}, {{7, "disp", {25.4, 0.0}}, {3, "load", {1.0, -273.15}}}, true});
  REQUIRE(history);
  CHECK(history->source().hold);
  CHECK(history->source().columns[0].quantity == 7);
  for (int pass = 0; pass < 2; ++pass) {
    REQUIRE(history->advance().value());
    CHECK(history->time() == -0.1);
    REQUIRE(history->values().size() == 2);
    CHECK(history->values()[0] == 25.4);
    CHECK(history->values()[1] == 2.0 - 273.15);
    REQUIRE(history->advance().value());
    CHECK(history->time() == 0.0);
    CHECK(history->line() == 3);
    REQUIRE(history->advance().value());
    CHECK(history->time() == 0.5);
    CHECK(history->values()[0] == 3.0 * 25.4);
    CHECK_FALSE(history->advance().value());
    REQUIRE(history->rewind());
  }
}

TEST_CASE("a history is taken again from the two rows before its start") {
  const TemporaryFolder folder;
  const std::string rows = "t,x\n-3,1\n# note\n-2,2\n-1,3\n0,4\n1,5\n1,6\n";
  const auto file = folder.write("rig.csv", rows);
  for (const auto missing :
       {base::MissingSample::kError, base::MissingSample::kSkip, base::MissingSample::kHold}) {
    auto history = MeasuredHistory::open(
        {{file, "rig.csv", {.missing = missing}}, "t", {}, {{0, "x", {}}}, false});
    REQUIRE(history);
    for (int pass = 0; pass < 3; ++pass) {
      for (double time = pass == 0 ? -3.0 : -1.0; time < 2.0; time += 1.0) {
        REQUIRE(history->advance().value());
        CHECK(history->time() == time);
        CHECK(history->values()[0] == time + 4.0);
        CHECK(history->line() == (time < -2.0 ? 2 : static_cast<long>(time) + 6));
      }
      CHECK(history->advance().error().message.starts_with(
          "the time 't' does not increase: 1 after 1 in line 7"));
      REQUIRE(history->rewind());
    }
  }
}

TEST_CASE("what is missing behind the place where a history is taken again is held as before") {
  const TemporaryFolder folder;
  const auto file = folder.write("rig.csv", "t,x,y\n-3,1,7\n-2,2,\n-1,,\n0,,5\n1,,\n");
  auto history = MeasuredHistory::open({{file, "rig.csv", {.missing = base::MissingSample::kHold}},
                                        "t",
                                        {},
                                        {{0, "x", {}}, {1, "y", {}}},
                                        false});
  REQUIRE(history);
  for (int pass = 0; pass < 3; ++pass) {
    for (double time = pass == 0 ? -3.0 : -1.0; time < 2.0; time += 1.0) {
      REQUIRE(history->advance().value());
      CHECK(history->time() == time);
      CHECK(history->values()[0] == (time < -2.0 ? 1.0 : 2.0));
      CHECK(history->values()[1] == (time < 0.0 ? 7.0 : 5.0));
    }
    CHECK_FALSE(history->advance().value());
    REQUIRE(history->rewind());
  }
}

TEST_CASE("times that do not increase are refused with both of them and their lines") {
  const auto equal = rows_of("t,x\n0,1\n0.5,1\n# note\n0.5,2\n");
  REQUIRE_FALSE(equal);
  CHECK(equal.error().kind == base::HistoryError::Kind::kInput);
  CHECK(equal.error().file == "rig.csv");
  CHECK(equal.error().line == 5);
  CHECK(equal.error().message == "the time 't' does not increase: 0.5 after 0.5 in line 3");
  const auto back = rows_of("t,x\n2,1\n1,1\n");
  REQUIRE_FALSE(back);
  CHECK(back.error().line == 3);
  CHECK(back.error().message == "the time 't' does not increase: 1 after 2 in line 2");
}

TEST_CASE("a history of one point or none is refused") {
  const auto one = rows_of("t,x\n0,1\n");
  REQUIRE_FALSE(one);
  CHECK(one.error().message == "there is one row; a history needs two or more");
  CHECK(one.error().line == 2);
  CHECK(rows_of("t,x\n").error().message == "no rows follow the header");
  CHECK(rows_of("").error().message.find("the file is empty") == 0);
  CHECK(rows_of("t,x\n0,1\n1,2\n").value() == 2);
}

TEST_CASE("a faulty row is refused where it stands, the rows before it are yielded") {
  const auto faulty = rows_of("t,x\n0,1\n1,2\n2,nan\n");
  REQUIRE_FALSE(faulty);
  CHECK(faulty.error().line == 4);
}

TEST_CASE("a number that its unit makes infinite is refused") {
  const auto infinite = rows_of("t,x\n0,1\n1,1e308\n", {}, {1e3, 0.0});
  REQUIRE_FALSE(infinite);
  CHECK(infinite.error().line == 3);
  CHECK(rows_of("t,x\n0,1\n1e308,1\n", {1e3, 0.0}, {}).error().line == 3);
}

TEST_CASE("times that only the change of unit makes equal are refused") {
  const auto same = rows_of("t,x\n1,1\n1.0000000000000002,1\n", {1e-300, 1.0}, {});
  REQUIRE_FALSE(same);
  CHECK(same.error().message.find("are the same in the case's unit") != std::string::npos);
}

TEST_CASE("between two rows a quantity is linear, or held until the later row") {
  CHECK(between_rows(1.0, 10.0, 3.0, 20.0, 1.5, false) == 12.5);
  CHECK(between_rows(1.0, 10.0, 3.0, 20.0, 1.0, false) == 10.0);
  CHECK(between_rows(1.0, 10.0, 3.0, 20.0, 3.0, false) == 20.0);
  CHECK(between_rows(1.0, 10.0, 3.0, 20.0, 2.999, true) == 10.0);
  CHECK(between_rows(1.0, 10.0, 3.0, 20.0, 3.0, true) == 20.0);
}

}  // namespace
}  // namespace slipbench::driver::history
