// SPDX-License-Identifier: Apache-2.0
#include "driver/results/summary.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "tests/driver/bench/example_cases.hpp"
#include "tests/support/dice.hpp"

namespace slipbench::driver::results {
namespace {

Summary summary_of(const cases::Case& problem) {
  Summary summary(problem);
  for (const bench::Row& row : bench::rows_of(problem)) summary.add(row);
  return summary;
}

TEST_CASE("the summary says what happened, in the case's units") {
  // 0.1 mm out and back in 20 increments each; slip from 0.02 mm on, and 0.04 mm after the turn.
  const cases::Case problem =
      bench::slider_case({bench::step("out", 20, 0, history::LinearTo{0.1}),
                          bench::step("back", 20, 0, history::LinearTo{0.0})});
  const Summary summary = summary_of(problem);
  // s = 0.08 + 0.06 mm at 20 N; stored lim^2/(2 k) = 0.2 mJ. Slip in 16 and in 12 increments of 40.
  CHECK(summary.definitions()[0].accumulated_slip == Approx(0.14));
  CHECK(summary.definitions()[0].dissipation == Approx(2.8));
  CHECK(summary.definitions()[0].energy_gap() == Approx(0.0).margin(1e-14));
  const std::string text = summary.text();
  CHECK(text.find("  slips 70 % of the time, 2 stick-slip events and 1 reversal, first slip at "
                  "t = 0.2 s (CP1 = 0.02 mm) at 20.0 N\n  friction force -20.0 .. 20.0 N, "
                  "dissipated 2.8 mJ, "
                  "stored 200.0 uJ, energy balance ") == 0);
}

TEST_CASE("the summary tells the elastic displacement while sticking, and the energy of a cycle") {
  // One increment a half cycle: the stick on the way back is within it.
  const int increments = GENERATE(4, 400);
  const history::Wave triangle{history::WaveShape::kTriangle, 0.1, 1.0, 0.0, 0.0};
  const cases::Case problem =
      bench::slider_case({bench::step("cycle", increments, 0, triangle, 2.0)});
  const Summary summary = summary_of(problem);
  const DefinitionSummary& sum = summary.definitions()[0];
  // From -0.02 to 0.02 mm of elastic slip.
  CHECK(sum.largest_creep == Approx(0.04).epsilon(1e-12));
  CHECK(sum.reversals == 4);
  if (increments == 400) {
    CHECK(sum.largest_elastic_slip == Approx(0.02).epsilon(0.05));
  }
  CHECK(
      summary.text().find("  elastic displacement while sticking up to 0.04 mm, dissipates 6.4 mJ "
                          "in the last of 2 cycles\n") != std::string::npos);
  const std::string json = summary.to_json().dump();
  CHECK(json.find("\"reversals\": 4") != std::string::npos);
  CHECK(json.find("\"found_by\": \"period of the waves\", \"count\": 2") != std::string::npos);
}

TEST_CASE("in one dimension at a constant limit nothing of the external work is lost") {
  // Random paths, increments that fit nothing; what is left is the rounding of their sums.
  test::Dice dice(20240917);
  for (int path = 0; path < 40; ++path) {
    std::vector<cases::Step> steps;
    for (int s = 0; s < 6; ++s) {
      steps.push_back(
          bench::step(std::to_string(s), 1 + dice.pick(60), 0,
                      s % 2 == 0 ? history::Profile(history::LinearTo{dice.between(-0.3, 0.3)})
                                 : history::Profile(history::SmoothTo{dice.between(-0.3, 0.3)})));
    }
    cases::Case problem = bench::slider_case(std::move(steps));
    if (path % 2 == 0) {
      problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip,
                                          dice.between(0.001, 0.1)};
    } else {
      problem.definitions[0].law.stick.value = dice.between(100.0, 1e5);
    }
    const Summary summary = summary_of(problem);
    INFO("path " << path);
    CHECK(std::abs(summary.definitions()[0].energy_gap()) <= 1e-10);
  }
}

TEST_CASE("a slider that never slips says so") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 4, 0, history::LinearTo{0.01})});
  CHECK(summary_of(problem).text().find("  never slips\n") == 0);
}

TEST_CASE("time without contact ends and begins with its events") {
  // Pressed less and less, not at all for 1 s, and more again.
  cases::Case problem = bench::slider_case(
      {bench::step("less", 4, cases::kFirstForce + 1, history::LinearTo{0.0}),
       bench::step("nothing", 3, cases::kFirstForce + 1, history::Constant{0.0}),
       bench::step("more", 4, cases::kFirstForce + 1, history::LinearTo{100.0})});
  problem.steps.insert(problem.steps.begin(),
                       bench::step("press", 1, cases::kFirstForce + 1, history::Constant{100.0}));
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{1};
  problem.integration.method =
      GENERATE(cases::IntegrationMethod::kBackwardEuler, cases::IntegrationMethod::kExact);
  CHECK(summary_of(problem).definitions()[0].open_time == Approx(1.0).epsilon(1e-12));
  problem.steps = {bench::step("nothing", 10, cases::kFirstForce + 1, history::Constant{0.0})};
  CHECK(summary_of(problem).text().find("  never in contact\n") == 0);
}

TEST_CASE("an instant without contact is no time") {
  // Pressed from 0 on: exact integration leaves the open begin 1e-11 of the increment behind it.
  cases::Case problem =
      bench::slider_case({bench::step("press", 1, cases::kFirstForce + 1, history::LinearTo{100.0}),
                          bench::step("out", 4, 0, history::LinearTo{0.1})});
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::ComponentContactForce{1};
  const law::BuiltPotential built = bench::both_axes(law::PotentialOperator::kMax, 1.0);
  problem.definitions[0].law.slip = built.slip;
  problem.definitions[0].law.criterion = built.criterion;
  problem.integration.method = cases::IntegrationMethod::kExact;
  const Summary summary = summary_of(problem);
  CHECK(summary.definitions()[0].open_time < 1e-10);
  CHECK(summary.text().find(" at 20.0 N\n  friction force") != std::string::npos);
  // A thousandth of the time is time.
  problem.steps.insert(problem.steps.begin(), bench::step("nothing", 1, cases::kFirstForce + 1,
                                                          history::Constant{0.0}, 2e-3));
  CHECK(summary_of(problem).text().find(" at 20.0 N, open 0.1 % of the time\n") !=
        std::string::npos);
}

TEST_CASE("without a coefficient there is no friction, but contact there is") {
  cases::Case problem = bench::slider_case({bench::step("out", 4, 0, history::LinearTo{1.0})});
  problem.definitions[0].law.law = law::ConstantCoefficient{0.0};
  CHECK(summary_of(problem).text().find(
            "  no friction all along: its coefficient is 0 (pressed by up to 100.0 N)\n") == 0);
}

TEST_CASE("time at a limit of 0 is not called open where something presses") {
  // The coefficient fades to 0 in the second step; the third is run without.
  cases::Case problem = bench::slider_case({bench::step("in", 10, 0, history::LinearTo{0.5}),
                                            bench::step("fade", 10, 0, history::LinearTo{1.0}),
                                            bench::step("out", 10, 0, history::LinearTo{2.0})});
  cases::FrictionChange change;
  change.law = law::ConstantCoefficient{0.0};
  change.stick = problem.definitions[0].law.stick;
  problem.steps[1].friction_changes = {change};
  const std::string text = summary_of(problem).text();
  CHECK(text.find(", with a limit of 0 for 33 % of the time\n") != std::string::npos);
}

TEST_CASE("an elastic loop that ends where it began loses nothing") {
  const cases::Case problem = bench::slider_case(
      {bench::step("cycle", 40, 0, history::Wave{history::WaveShape::kSine, 0.01, 1.0, 0.0, 0.0})});
  const Summary summary = summary_of(problem);
  REQUIRE(summary.definitions()[0].largest_energy == Approx(0.05));
  // What is left of the work at the end is rounding: it is no measure of itself.
  CHECK(std::abs(summary.definitions()[0].energy_gap()) < 1e-12);
}

TEST_CASE("a mass that moves against its belt slips from the start, without an event") {
  // mass 1 at 1 mm/s on a fixed track, 20 N: it stops after 0.05 s; 0.1 s are run.
  cases::Case problem =
      bench::slider_case({bench::step("run", 3, cases::kFirstForce, history::LinearTo{0.0}, 0.1)});
  problem.dynamics = cases::DynamicsData{0, 1.0, 0.0, 1.0, std::nullopt};
  const Summary summary = summary_of(problem);
  const DefinitionSummary& sum = summary.definitions()[0];
  REQUIRE(sum.first_slip);
  CHECK(sum.first_slip->time == 0.0);
  CHECK(sum.first_slip->force == Approx(20.0));
  CHECK(sum.first_place.at(0) == 0.0);
  CHECK(sum.events == 0);
  // Integrated to 1e-13 of the motion's size.
  CHECK(sum.slip_time == Approx(0.05).epsilon(1e-11));
  CHECK(summary.text().find(
            "  slips 50 % of the time, 0 stick-slip events, first slip at t = 0.0") == 0);
}

TEST_CASE("a mass that turns slips all the time, up to and beyond its turn") {
  // Spring 1000 N/mm, 20 N, mass 1 thrown with 3 mm/s: it turns far beyond where it could stick.
  cases::Case problem =
      bench::slider_case({bench::step("run", 1, cases::kFirstForce, history::LinearTo{0.0}, 0.06)});
  problem.kinetic.elasticity[0].emplace(1000.0);
  problem.dynamics = cases::DynamicsData{0, 1.0, 0.0, 3.0, std::nullopt};
  const Summary summary = summary_of(problem);
  const DefinitionSummary& sum = summary.definitions()[0];
  CHECK(sum.reversals == 1);
  CHECK(sum.events == 0);
  CHECK(sum.slip_time == Approx(0.06).epsilon(1e-11));
}

TEST_CASE("a coefficient that falls too fast is warned of, with the increment that would do") {
  cases::Case problem =
      bench::slider_case({bench::step("out", 100, 0, history::LinearTo{1.0}, 0.01)});
  // By hand: 2 N (mu_s - mu_k) d/k/2 = N 0.1 0.05/k = 5e-4 s.
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  const Summary summary = summary_of(problem);
  REQUIRE(summary.definitions()[0].multiple_roots > 0);
  const auto warnings = summary.warnings({});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("friction 'sleeve': ") == 0);
  CHECK(warnings[0].find("with increments longer than 0.0005 s there is one only") !=
        std::string::npos);
}

/// Reference case K3: 1 mm/s over increments of the given length; mu 0.3 to 0.2 with d = 0.05.
cases::Case falling_case(double increment, int count) {
  const double end = increment * count;
  cases::Case problem =
      bench::slider_case({bench::step("drag", count, 0, history::LinearTo{end}, end)});
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  return problem;
}

TEST_CASE("increments below the smooth threshold are warned of, with both thresholds (K3)") {
  const cases::Case problem = falling_case(1e-5, 4000);
  const Summary summary = summary_of(problem);
  const DefinitionSummary& sum = summary.definitions()[0];
  CHECK(sum.short_increments == 4000);
  CHECK(sum.worst.smooth == Approx(9.51229424500714e-4).epsilon(1e-12));
  CHECK(sum.worst.unique == Approx(5e-4).epsilon(1e-12));
  CHECK(sum.worst_duration == Approx(1e-5).epsilon(1e-10));
  const auto warnings = summary.warnings({});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("friction 'sleeve': 4000 of 4000 increments are shorter than 2 F_N "
                         "|dmu/dv| / k, at worst 1e-05 s against 0.000951229 s (t = 1e-05, F_N = "
                         "100.0 N): there backward Euler may not settle on F_N mu(v)") == 0);
  CHECK(warnings[0].find("; below F_N max|dmu/dv| / k = 0.0005 s an increment may have more than "
                         "one solution") != std::string::npos);
  CHECK(warnings[0].find("take longer increments, 'slip_rate: relative_motion'") !=
        std::string::npos);
}

TEST_CASE("between the thresholds there is one solution, and still no smooth answer (K3)") {
  const auto warnings = summary_of(falling_case(9.5e-4, 100)).warnings({});
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("at worst 0.00095 s against 0.000951229 s") != std::string::npos);
  CHECK(warnings[0].find("more than one solution") == std::string::npos);
}

TEST_CASE(
    "increments above the thresholds, or that see the rate of the motion, are not warned of") {
  CHECK(summary_of(falling_case(9.6e-4, 100)).warnings({}).empty());
  cases::Case problem = falling_case(1e-5, 4000);
  problem.definitions[0].law.slip_rate = law::SlipRateMeasure::kRelativeMotion;
  CHECK(summary_of(problem).warnings({}).empty());
  problem = falling_case(1e-5, 4000);
  problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip, 0.02};
  CHECK(summary_of(problem).warnings({}).empty());
}

TEST_CASE("who never slips has no smooth answer to miss") {
  const auto warnings = summary_of(falling_case(1e-5, 100)).warnings({});
  REQUIRE(warnings.size() == 2);  // the first: its motion is within the elastic slip
  CHECK(warnings[1].find("100 increments may have more than one solution") != std::string::npos);
  CHECK(warnings[1].find("take longer increments") == std::string::npos);
}

TEST_CASE("a coefficient that begins to fall in a change of friction is warned of") {
  cases::Case problem = falling_case(1e-4, 1000);
  problem.definitions[0].law.law = law::ConstantCoefficient{0.2};
  problem.steps.push_back(bench::step("on", 1000, 0, history::LinearTo{0.2}, 0.1));
  cases::FrictionChange change;
  change.law = law::ExponentialDecay{0.3, 0.2, 0.05};
  change.stick = problem.definitions[0].law.stick;
  problem.steps[1].friction_changes = {change};
  const DefinitionSummary sum = summary_of(problem).definitions()[0];
  // 2 A N |mu'|/k > 1e-4 s from A = 0.1051 on: from the 106th of 1000 increments.
  CHECK(sum.short_increments == 895);
  CHECK(sum.worst.smooth == Approx(9.51229424500714e-4).epsilon(1e-12));
}

TEST_CASE("a motion that jumps is warned of") {
  const cases::Case problem =
      bench::slider_case({bench::step("out", 4, 0, history::LinearTo{0.1})});
  const bench::MotionJump jump{0, 0.5, 0.0, "out"};
  const auto warnings = summary_of(problem).warnings(std::span(&jump, 1));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] ==
        "CP1 jumps by 0.5 mm at the start of step 'out' (t = 0.0): the jump is made in the first "
        "increment; 'initial:' gives the position before it");
}

TEST_CASE("numbers for people have few digits and show that they were measured") {
  CHECK(base::rounded(105.0) == "105.0");
  CHECK(base::rounded(0.01425) == "0.01425");
  CHECK(base::rounded(-20.000000001) == "-20.0");
  CHECK(base::rounded(1.23456e6) == "1.235e+06");
  CHECK(base::energy_unit({"mm", "N", "s", ""}) == "mJ");
  CHECK(base::energy_unit({"", "", "", ""}).empty());
}

TEST_CASE("energies are told in the joules that make them readable") {
  const base::UnitSystem mm_n{"mm", "N", "s", ""};
  CHECK(base::energy_text(9020.0, mm_n) == "9.02 J");
  CHECK(base::energy_text(12.4, mm_n) == "12.4 mJ");
  CHECK(base::energy_text(-0.0004, mm_n) == "-400.0 nJ");
  CHECK(base::energy_text(999.4, mm_n) == "999.0 mJ");
  CHECK(base::energy_text(999.7, mm_n) == "1.0 J");
  CHECK(base::energy_text(0.0, mm_n) == "0.0 mJ");
  CHECK(base::energy_text(2.5e6, {"m", "N", "s", ""}) == "2.5 MJ");
  CHECK(base::energy_text(1.5, {"mm", "kN", "ms", ""}) == "1.5 J");
  CHECK(base::energy_text(1.5, {"cm", "N", "s", ""}) == "15.0 mJ");
  CHECK(base::energy_text(12345.0, {"in", "lbf", "s", ""}) == "1.23e+04 lbf in");
  CHECK(base::energy_text(1.5, {}) == "1.5");
}

}  // namespace
}  // namespace slipbench::driver::results
