// SPDX-License-Identifier: Apache-2.0
#include "driver/case/curve_file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::cases {
namespace {

using Names = std::vector<std::string>;

TEST_CASE("a curve gives the columns that were asked for, and how finely they were printed") {
  const TemporaryFolder folder;
  CurveFile file(
      {folder.write("a.csv", "# rig 7\ntime;note;load\n0;start;1.25\n0.5;end;-12.50\n"), "a.csv"});
  file.want(Names{"t", "time"});
  file.want(Names{"load"});
  const auto time = file.column(Names{"t", "time"});
  const auto load = file.column(Names{"load"});
  REQUIRE(time);
  REQUIRE(load);
  CHECK((*time)->values == std::vector<double>{0.0, 0.5});
  CHECK((*load)->values == std::vector<double>{1.25, -12.5});
  CHECK((*load)->resolution.value() == Approx(0.005));
}

TEST_CASE("a column that is not there is told with those that are; the others can be had") {
  const TemporaryFolder folder;
  CurveFile file({folder.write("a.csv", "time,load\n0,1\n"), "a.csv"});
  file.want(Names{"time"});
  file.want(Names{"loads"});
  CHECK(file.column(Names{"time"}));
  const auto missing = file.column(Names{"loads"});
  REQUIRE_FALSE(missing);
  CHECK(missing.error() ==
        "a.csv: no column 'loads'; the columns are time and load; did you mean 'load'?");
  const auto either = file.column(Names{"t", "T"});
  REQUIRE_FALSE(either);
  CHECK(either.error() == "a.csv: no column 't' or 'T'; the columns are time and load");
}

TEST_CASE("what is wrong in a curve is told with its place") {
  const TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) {
    CurveFile file({folder.write("a.csv", bytes), "a.csv"});
    file.want(Names{"time"});
    const auto column = file.column(Names{"time"});
    REQUIRE_FALSE(column);
    return column.error();
  };
  CHECK(fault("").find("a.csv:1:1: the file is empty") == 0);
  CHECK(fault("time\n").find("a.csv:1:1: no rows follow the header") == 0);
  CHECK(fault("time,x\n0,1\nnan,2\n").find("a.csv:3:1: column 'time' holds 'nan'") == 0);
  CHECK(fault("time,x\n0,1\n1\n").find("a.csv:3:1: 1 field where the header has 2 columns") == 0);
}

TEST_CASE("a curve that is gone is told when it is asked for") {
  const TemporaryFolder folder;
  CurveFile file({folder.path() / "a.csv", "a.csv"});
  file.want(Names{"time"});
  const auto column = file.column(Names{"time"});
  REQUIRE_FALSE(column);
  CHECK(column.error().find("a.csv: cannot be opened") == 0);
}

TEST_CASE("a golden curve is known by its first line, and has all digits of its numbers") {
  const TemporaryFolder folder;
  CHECK(is_golden_curve(folder.write("a.csv", "# slipbench golden curve\ntime\n1\n")));
  CHECK(is_golden_curve(folder.write("b.csv", "# slipbench golden curve\r\ntime\r\n1\r\n")));
  CHECK_FALSE(is_golden_curve(folder.write("c.csv", "# slipbench golden curves\ntime\n1\n")));
  CHECK_FALSE(is_golden_curve(folder.write("d.csv", "time\n1\n")));
  CHECK_FALSE(is_golden_curve(folder.path() / "none.csv"));

  CurveFile golden({folder.path() / "a.csv", "a.csv"});
  golden.want(Names{"time"});
  CHECK_FALSE((*golden.column(Names{"time"}))->resolution);
  // What was read once is known: the file is not looked at again.
  std::filesystem::remove(folder.path() / "a.csv");
  CHECK(golden.golden());
}

}  // namespace
}  // namespace slipbench::driver::cases
