// SPDX-License-Identifier: Apache-2.0
#include "driver/check/golden.hpp"

#include <stdlib.h>

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/check/check.hpp"
#include "tests/driver/bench/example_cases.hpp"
#include "tests/driver/read/read_for_test.hpp"
#include "tests/driver/support/environment_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::check {
namespace {

/// The sound case with these checks, in a folder.
cases::Case with_checks(const TemporaryFolder& folder, const std::string& checks) {
  const std::string base = read::kSoundCase.substr(0, read::kSoundCase.find("  - name: limit"));
  return read::sound(base + checks, {.curves_may_be_missing = true}, folder.path().string());
}

std::string check(const std::string& name, const std::string& quantity, const std::string& against,
                  const std::string& more = "") {
  return "  - {name: " + name + ", quantity: " + quantity + ", against: {" + against + "}, " +
         more + "tolerance: {absolute: 1, why: x}}\n";
}

std::vector<std::string> names_of(const GoldenCurve& curve) {
  std::vector<std::string> names;
  for (const GoldenColumn& column : curve.columns) names.push_back(column.name);
  return names;
}

TEST_CASE("checks that name one golden curve share it, each with its columns") {
  const TemporaryFolder folder;
  const cases::Case problem =
      with_checks(folder, check("a", "FLIM", "curve: g.csv") +
                              check("b", "CSF1", "curve: g.csv",
                                    "abscissa: "
                                    "CU1, ") +
                              check("c", "\"= 2*FN\"", "curve: h.csv, column: twice"));
  const auto curves = golden_curves(problem);
  REQUIRE(curves);
  REQUIRE(curves->size() == 2);
  CHECK(names_of((*curves)[0]) == std::vector<std::string>{"time", "FLIM", "CU1", "CSF1"});
  CHECK((*curves)[0].checks == std::vector<std::size_t>{0, 1});
  CHECK((*curves)[0].columns[2].unit == "mm");
  CHECK(names_of((*curves)[1]) == std::vector<std::string>{"time", "twice"});
}

TEST_CASE("one column cannot stand for two things") {
  const TemporaryFolder folder;
  const auto curves =
      golden_curves(with_checks(folder, check("a", "FLIM", "curve: g.csv, column: x") +
                                            check("b", "FN", "curve: g.csv, column: x")));
  REQUIRE_FALSE(curves);
  CHECK(curves.error() ==
        "g.csv: its column 'x' is 'FLIM' for one check and 'FN' for another; give them other "
        "columns");
}

TEST_CASE("a curve of somebody else is no golden curve; where there are others, it is passed by") {
  const TemporaryFolder folder;
  folder.write("rig.csv", "time,FLIM\n0,1\n");
  const std::string foreign = check("a", "FLIM", "curve: rig.csv");
  const auto alone = golden_curves(with_checks(folder, foreign));
  REQUIRE_FALSE(alone);
  CHECK(alone.error() ==
        "rig.csv is no golden curve but somebody's reference: it is not overwritten");
  const auto both = golden_curves(with_checks(folder, foreign + check("b", "FN", "curve: g.csv")));
  REQUIRE(both);
  CHECK(both->size() == 1);
  CHECK_FALSE(golden_curves(with_checks(folder, check("a", "FLIM", "expression: = 1"))));
  CHECK_FALSE(golden_curves(
      with_checks(folder, check("a", "FLIM", "curve: dahl_loop", "abscissa: CU1, "))));
}

TEST_CASE("the golden curve of another case is left to it") {
  const TemporaryFolder folder;
  folder.write("g.csv",
               "# slipbench golden curve\n# case: other.yaml\n# blessed: x\ntime,FN\n0,1\n");
  const auto curves = golden_curves(with_checks(folder, check("a", "FN", "curve: g.csv")));
  REQUIRE_FALSE(curves);
  CHECK(curves.error() ==
        "g.csv is the golden curve of other.yaml; give this case one of its own, or remove it");
}

TEST_CASE("a header keeps the reasons of earlier blessings, the latest first, twenty at most") {
  const TemporaryFolder folder;
  const cases::Case problem = with_checks(folder, check("a", "FN", "curve: g.csv"));
  const GoldenCurve curve = golden_curves(problem)->front();
  const Environment none("SOURCE_DATE_EPOCH", "");
  GoldenHeader header = golden_header(problem, curve, "first\nline", {});
  CHECK(header.blessings == std::vector<std::string>{"# blessed: first line"});
  folder.write("g.csv", to_text(header) + names_row(curve) + "0,1\n");
  const GoldenHeader before = read_golden_header(folder.path() / "g.csv");
  CHECK(before.origin == header.origin);
  CHECK(before.blessings == header.blessings);
  // The same reason again is the same blessing.
  CHECK(golden_header(problem, curve, "first line", before).blessings == before.blessings);
  for (int i = 0; i < 30; ++i) {
    header = golden_header(problem, curve, "number " + std::to_string(i), header);
  }
  REQUIRE(header.blessings.size() == 20);
  CHECK(header.blessings.front() == "# blessed: number 29");
  CHECK(header.blessings.back() == "# blessed: number 10");
}

TEST_CASE("a blessing has a date only if the environment gives one") {
  const TemporaryFolder folder;
  const cases::Case problem = with_checks(folder, check("a", "FN", "curve: g.csv"));
  const GoldenCurve curve = golden_curves(problem)->front();
  const Environment day("SOURCE_DATE_EPOCH", "1700000000");
  CHECK(golden_header(problem, curve, "x", {}).blessings[0] == "# blessed 2023-11-14: x");
}

TEST_CASE("every row of a run is in its golden curve, to the last digit") {
  const TemporaryFolder folder;
  const cases::Case problem =
      with_checks(folder, check("a", "FLIM", "curve: g.csv, column: {column: F, unit: kN}"));
  GoldenCurve curve = golden_curves(problem)->front();
  std::string text = names_row(curve);
  const std::vector<bench::Row> rows = bench::rows_of(problem);
  for (const bench::Row& row : rows) REQUIRE(append_golden_row(curve, row, text));
  folder.write("g.csv", to_text(golden_header(problem, curve, "x", {})) + text);
  cases::Check exact = problem.checks[0];
  // There and back between newton and kilonewton: two roundings of numbers up to 105 N.
  exact.tolerance = {1e-13, {}, ""};
  std::get<cases::CurveReference>(exact.against).data.reset();
  CheckProgress progress(problem, exact);
  for (const bench::Row& row : rows) progress.add(row);
  const Verdict verdict = progress.verdict();
  INFO(verdict.message);
  CHECK(verdict.passed);
  CHECK(verdict.compared == 11);
}

TEST_CASE("a column without a value is told with its time") {
  const TemporaryFolder folder;
  const cases::Case problem =
      with_checks(folder, check("a", "\"= FLIM/T\"", "curve: g.csv, column: rate"));
  GoldenCurve curve = golden_curves(problem)->front();
  std::string text;
  const auto appended = append_golden_row(curve, bench::rows_of(problem).front(), text);
  REQUIRE_FALSE(appended);
  INFO(appended.error());
  CHECK(appended.error().find(
            "the column 'rate' of g.csv has no value at t = 0.0: FLIM/T divides by zero") == 0);
}

}  // namespace
}  // namespace slipbench::driver::check
