// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "driver/results/columns.hpp"
#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::results {
namespace {

// Positions near 0.1 carry rounding of 1e-17; differences of 1e-5 keep eleven digits of it.
constexpr double kDifference = 1e-11;

double value(const cases::Case& problem, const bench::Row& row, const std::string& name) {
  const auto column = find_column(problem, result_columns(problem), name);
  REQUIRE(column);
  return column_value(*column, problem, row);
}

/// A step of one increment that moves the puck in its plane.
cases::Step go_to(std::string name, double u2, double u3, double duration) {
  cases::Step one = bench::step(std::move(name), 1, 1, history::LinearTo{u2}, duration);
  one.drives.push_back({2, history::LinearTo{u3}});
  return one;
}

TEST_CASE("the slip velocity is signed: negative while the force still points the other way") {
  // Out by 0.1 along (0.6, 0.8), back by 2e-5 within the elastic slip of 1e-4, then all the way.
  const cases::Case problem =
      bench::puck_case({go_to("out", 0.06, 0.08, 2.0), go_to("unload", 0.059988, 0.079984, 0.5),
                        go_to("back", 0.0, 0.0, 0.25), go_to("rest", 0.0, 0.0, 1.0)});
  const std::vector<bench::Row> rows = bench::rows_of(problem);
  REQUIRE(rows.size() == 5);
  CHECK(value(problem, rows[0], "CIVC") == 0.0);
  CHECK(value(problem, rows[1], "CIVC") == Approx(0.05).epsilon(kDifference));
  CHECK(value(problem, rows[2], "STATUS.sliding") == 1.0);
  CHECK(value(problem, rows[2], "CSF2") > 0.0);
  CHECK(value(problem, rows[2], "CIVC") == Approx(-4e-5).epsilon(kDifference));
  CHECK(value(problem, rows[3], "STATUS.sliding") == 2.0);
  CHECK(value(problem, rows[3], "CSF2") < 0.0);
  // 0.09998 in 0.25: the motion is along the slip again.
  CHECK(value(problem, rows[3], "CIVC") == Approx(0.39992).epsilon(kDifference));
  CHECK(value(problem, rows[4], "CIVC") == 0.0);
}

TEST_CASE("the slip velocity of a shaft adds the turning at its radius") {
  cases::Case problem = bench::slider_case({});
  problem.connection = law::find_connection("CYLINDRICAL").value();
  problem.definitions[0].coupled = true;
  problem.definitions[0].law.slip = law::slip_space({1, 4});
  problem.definitions[0].law.slip.scale[1] = 0.5;
  // Slip space (3, 0.5 * 8) = (3, 4) in 2 s: all of its 5 along the slip.
  problem.steps = {bench::step("slide", 1, 0, history::LinearTo{3.0}, 2.0)};
  problem.steps[0].drives.push_back({3, history::LinearTo{8.0}});
  const bench::Row last = bench::rows_of(problem).back();
  CHECK(value(problem, last, "CIVC") == Approx(2.5).epsilon(1e-14));
  CHECK(value(problem, last, "CASUC") == Approx(4.98).epsilon(1e-14));
}

TEST_CASE("the elastic slip is the length of the vector, in stick and in slip") {
  const cases::Case problem =
      bench::puck_case({go_to("stick", 3e-5, -4e-5, 1.0), go_to("slip", 0.06, -0.08, 1.0)});
  const std::vector<bench::Row> rows = bench::rows_of(problem);
  REQUIRE(rows.size() == 3);
  CHECK(value(problem, rows[1], "STATUS.sliding") == 1.0);
  // One norm of one motion: rounding only.
  CHECK(value(problem, rows[1], "SEL.sliding") == Approx(5e-5).epsilon(1e-14));
  CHECK(value(problem, rows[2], "STATUS.sliding") == 2.0);
  CHECK(value(problem, rows[2], "SEL.sliding") == Approx(1e-4).epsilon(1e-14));
}

TEST_CASE("the elastic slip of one component is a magnitude too") {
  const cases::Case problem =
      bench::slider_case({bench::step("slide", 1, 0, history::LinearTo{-0.01})});
  const bench::Row last = bench::rows_of(problem).back();
  CHECK(value(problem, last, "CSF1") == Approx(-10.0).epsilon(1e-14));
  CHECK(value(problem, last, "SEL") == Approx(0.01).epsilon(1e-14));
}

}  // namespace
}  // namespace slipbench::driver::results
