// SPDX-License-Identifier: Apache-2.0
#include "driver/results/summary.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/simulation/example_cases.hpp"

namespace slipbench::driver {
namespace {

Summary summary_of(const Case& problem) {
  Summary summary(problem);
  for (const Row& row : rows_of(problem)) summary.add(row);
  return summary;
}

TEST_CASE("the summary says what happened, in the case's units") {
  // 0.1 mm out and back in 20 increments each; slip from 0.02 mm on, and 0.04 mm after the turn.
  const Case problem =
      slider_case({step("out", 20, 0, LinearTo{0.1}), step("back", 20, 0, LinearTo{0.0})});
  const Summary summary = summary_of(problem);
  // s = 0.08 + 0.06 mm at 20 N; stored lim^2/(2 k) = 0.2 mJ. Slip in 16 and in 12 increments of 40.
  CHECK(summary.definitions()[0].accumulated_slip == Approx(0.14));
  CHECK(summary.definitions()[0].dissipation == Approx(2.8));
  CHECK(summary.definitions()[0].energy_gap() == Approx(0.0).margin(1e-14));
  const std::string text = summary.text();
  CHECK(
      text.find("  slips 70 % of the time, 2 stick-slip events, first slip at t = 0.25 s "
                "(CP1 = 0.025 mm) at 20.0 N\n  friction force -20.0 .. 20.0 N, dissipated 2.8 mJ, "
                "stored 0.2 mJ, energy balance ") == 0);
}

TEST_CASE("a slider that never slips says so") {
  const Case problem = slider_case({step("out", 4, 0, LinearTo{0.01})});
  CHECK(summary_of(problem).text().find("  never slips\n") == 0);
}

TEST_CASE("a coefficient that falls too fast is warned of, with the increment that would do") {
  Case problem = slider_case({step("out", 100, 0, LinearTo{1.0}, 0.01)});
  // Reference cases, section 6: 2 N (mu_s - mu_k) d/k/2 = N 0.1 0.05/k = 5e-4 s.
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  const Summary summary = summary_of(problem);
  REQUIRE(summary.definitions()[0].multiple_roots > 0);
  const auto warnings = summary.warnings({});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("friction 'sleeve': ") == 0);
  CHECK(warnings[0].find("with increments longer than 0.0005 s there is one only") !=
        std::string::npos);
}

TEST_CASE("a motion that jumps is warned of") {
  const Case problem = slider_case({step("out", 4, 0, LinearTo{0.01})});
  const MotionJump jump{0, 0.5, 0.0, "out"};
  const auto warnings = summary_of(problem).warnings(std::span(&jump, 1));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] ==
        "CP1 jumps by 0.5 mm at the start of step 'out' (t = 0.0): the jump is made in the first "
        "increment; 'initial:' gives the position before it");
}

TEST_CASE("numbers for people have few digits and show that they were measured") {
  CHECK(rounded(105.0) == "105.0");
  CHECK(rounded(0.01425) == "0.01425");
  CHECK(rounded(-20.000000001) == "-20.0");
  CHECK(rounded(1.23456e6) == "1.235e+06");
  CHECK(energy_unit({"mm", "N", "s", ""}) == "mJ");
  CHECK(energy_unit({"", "", "", ""}).empty());
}

}  // namespace
}  // namespace slipbench::driver
