// SPDX-License-Identifier: Apache-2.0
// Components driven by force: the motion that a load makes, and loads that nothing can hold.
#include "driver/bench/equilibrium.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

// The equilibrium is solved to 1e-12 of the forces; positions to that over the softest slope.
constexpr double kForceError = 1e-10;

/// The slider of the examples (limit 20 N, k = 1000 N/mm), driven by force, with a spring.
cases::Case loaded_case(std::vector<cases::Step> steps, double spring = 0.0) {
  cases::Case problem = slider_case(std::move(steps));
  problem.force_driven.insert(0);
  if (spring > 0.0) problem.kinetic.elasticity[0].emplace(spring);
  return problem;
}

double motion(const Row& row) { return row.quantities[0]; }
double friction(const Row& row) { return row.definitions[0].update.state.force[0]; }

std::string failure_of(const cases::Case& problem) {
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  while (true) {
    const auto more = simulation->advance();
    if (!more) {
      CHECK(more.error().kind == SimulationFailure::Kind::kNumerical);
      return more.error().message;
    }
    if (!*more) return {};
  }
}

TEST_CASE("a load below the limit is held by elastic stick, one above it by nothing") {
  const auto up_to = [](double load) {
    return loaded_case({step("pull", 8, cases::kFirstForce, history::LinearTo{load})});
  };
  const std::vector<Row> rows = rows_of(up_to(19.5));
  REQUIRE(rows.size() == 9);
  for (const Row& row : rows) {
    CHECK(motion(row) == Approx(19.5e-3 * row.time).margin(1e-15));
    CHECK(friction(row) == Approx(row.forces.component[0].applied).margin(kForceError));
  }
  // At the limit itself it still holds.
  CHECK(failure_of(up_to(20.0)).empty());
  const std::string message = failure_of(up_to(30.0));
  CHECK(message.find("step 'pull', t = 0.66") == 0);
  CHECK(message.find("no static solution: component 1 is loaded with f1 = 20.0") !=
        std::string::npos);
  CHECK(message.find("but only 20 can hold against it") != std::string::npos);
  CHECK(message.find("friction 'sleeve' has the limit 20") != std::string::npos);
}

TEST_CASE("a load that comes back to the rounding of 0 is held") {
  // The end of a sine of whole periods: friction of 12 N is taken back to 1e-14, where its own
  // rounding is as large.
  const double left = GENERATE(-7.3e-15, 0.0, 1e-17, 2e-16);
  const auto mode =
      GENERATE(law::StickStiffness::Mode::kStiffness, law::StickStiffness::Mode::kElasticSlip);
  cases::Case problem =
      loaded_case({step("pull", 3, cases::kFirstForce, history::LinearTo{12.99038105676658}),
                   step("back", 1, cases::kFirstForce, history::LinearTo{left})});
  problem.definitions[0].law.stick = {
      mode, mode == law::StickStiffness::Mode::kStiffness ? 1000.0 : 0.02};
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 5);
  CHECK(friction(rows.back()) == Approx(left).margin(1e-13));
}

TEST_CASE("slip within an increment that had to be cut begins where its piece began to slip") {
  // 18 to 40 N with the spring behind: the limit of 20 N is met at 2/22 of the increment, within
  // the softness of the parallel spring; a cut only moves the pieces.
  const cases::Case problem =
      loaded_case({step("pull", 1, cases::kFirstForce, history::LinearTo{18.0}),
                   step("on", 1, cases::kFirstForce, history::LinearTo{40.0})},
                  50.0);
  const std::vector<Row> rows = rows_of(problem);
  const law::FrictionUpdate& update = rows.back().definitions[0].update;
  REQUIRE(update.state.regime == law::Regime::kSlip);
  CHECK(update.onset > 0.0);
  CHECK(update.onset < 0.1);
}

TEST_CASE("the motion a load makes gives the friction force back when it is prescribed") {
  // A random walk of loads; the motion found is fed to the same slider as a prescribed one.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> load(-60.0, 60.0);
  std::vector<cases::Step> steps;
  for (int i = 0; i < 40; ++i) {
    steps.push_back(
        step("s" + std::to_string(i), 3, cases::kFirstForce, history::LinearTo{load(random)}));
  }
  const std::vector<Row> driven = rows_of(loaded_case(steps, 30.0));
  std::vector<cases::Step> again;
  for (std::size_t i = 1; i < driven.size(); ++i) {
    again.push_back(
        step("m" + std::to_string(i), 1, 0, history::LinearTo{motion(driven[i])}, 1.0 / 3.0));
  }
  const std::vector<Row> led = rows_of(slider_case(again));
  REQUIRE(led.size() == driven.size());
  for (std::size_t i = 1; i < led.size(); ++i) {
    CHECK(friction(led[i]) == Approx(friction(driven[i])).margin(kForceError));
    CHECK(led[i].definitions[0].dissipation ==
          Approx(driven[i].definitions[0].dissipation).margin(1e-9));
    CHECK(30.0 * motion(driven[i]) + friction(driven[i]) ==
          Approx(driven[i].forces.component[0].applied).margin(kForceError));
  }
}

TEST_CASE("a load that a falling coefficient lets go jumps to where the spring holds it") {
  cases::Case problem =
      loaded_case({step("pull", 100, cases::kFirstForce, history::LinearTo{50.0})}, 50.0);
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 5.0};
  double largest = 0.0;
  for (const Row& row : rows_of(problem)) {
    const double total = 50.0 * motion(row) + friction(row);
    CHECK(total == Approx(row.forces.component[0].applied).margin(kForceError));
    largest = std::max(largest, motion(row) - row.begin[0]);
  }
  // From 30 N of friction to about 20 N: 10 N in the spring of 50 N/mm.
  CHECK(largest == Approx(0.21).epsilon(0.05));
}

TEST_CASE("a stop holds what friction and spring do not") {
  cases::Case problem = loaded_case({step("out", 10, cases::kFirstForce, history::LinearTo{50.0}),
                                     step("in", 10, cases::kFirstForce, history::LinearTo{-50.0})});
  problem.stop[0] = law::Stop{-0.1, 0.25};
  for (const Row& row : rows_of(problem)) {
    const ComponentForces& forces = row.forces.component[0];
    CHECK(motion(row) <= 0.25);
    CHECK(motion(row) >= -0.1);
    if (row.index == 0) continue;
    CHECK(friction(row) + forces.reaction == Approx(forces.applied).margin(kForceError));
    if (motion(row) < 0.25 && motion(row) > -0.1) CHECK(forces.reaction == 0.0);
    if (motion(row) == 0.25) CHECK(forces.reaction >= 0.0);
    if (motion(row) == -0.1) CHECK(forces.reaction <= 0.0);
  }
}

TEST_CASE("a prescribed motion beyond a stop is an error that names it") {
  cases::Case problem = slider_case({step("out", 10, 0, history::LinearTo{0.3})});
  problem.stop[0] = law::Stop{-0.1, 0.25};
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  for (int i = 0; i < 8; ++i) REQUIRE(simulation->advance());
  const auto beyond = simulation->advance();
  REQUIRE_FALSE(beyond);
  CHECK(beyond.error().kind == SimulationFailure::Kind::kInput);
  CHECK(beyond.error().message ==
        "step 'out', t = 0.9 (total time 0.9): CP1 = 0.27 is beyond the upper stop of component 1 "
        "at 0.25");
}

TEST_CASE("control changes hands without a jump") {
  const cases::Case problem =
      loaded_case({step("pull", 4, cases::kFirstForce, history::LinearTo{15.0}),
                   step("slide", 4, 0, history::LinearTo{0.1}),
                   step("let go", 4, cases::kFirstForce, history::LinearTo{0.0})});
  const std::vector<Row> rows = rows_of(problem);
  CHECK(motion(rows[4]) == Approx(0.015).epsilon(1e-12));
  CHECK(motion(rows[5]) == Approx(0.015 + 0.085 / 4).epsilon(1e-12));
  CHECK(rows[5].forces.component[0].applied == 0.0);
  // The load starts with the 20 N that the motion had come to.
  CHECK(rows[9].forces.component[0].applied == Approx(15.0).margin(kForceError));
  CHECK(motion(rows[12]) == Approx(0.08).epsilon(1e-12));
}

TEST_CASE("a run of a loaded connector that is cut and resumed gives the same bytes") {
  const cases::Case problem =
      loaded_case({step("pull", 7, cases::kFirstForce, history::LinearTo{35.0}),
                   step("slide", 3, 0, history::LinearTo{0.1}),
                   step("let go", 5, cases::kFirstForce, history::LinearTo{-25.0})},
                  100.0);
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int cut = 0; cut < 14; ++cut) {
    auto resumed = Simulation::resume(problem, whole->state());
    REQUIRE(resumed);
    REQUIRE(resumed->advance());
    REQUIRE(whole->advance());
    CHECK(motion(resumed->row()) == motion(whole->row()));
    CHECK(friction(resumed->row()) == friction(whole->row()));
    CHECK(resumed->row().forces.component[0].applied == whole->row().forces.component[0].applied);
  }
}

TEST_CASE("components that friction couples are solved together") {
  // SLIDE-PLANE, limit 20 N, springs of 40 and 90 N/mm.
  cases::Case problem = slider_case({});
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions[0].law.slip = law::slip_space({2, 3});
  problem.definitions[0].coupled = true;
  problem.force_driven = law::ComponentSet::of(2, 3);
  problem.kinetic.elasticity[1].emplace(40.0);
  problem.kinetic.elasticity[2].emplace(90.0);
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.7 * i;
    cases::Step one = step("s" + std::to_string(i), 5, cases::kFirstForce + 1,
                           history::LinearTo{50 * std::cos(angle)});
    one.drives.push_back({cases::kFirstForce + 2, history::LinearTo{50 * std::sin(angle)}});
    problem.steps.push_back(one);
  }
  int slips = 0;
  for (const Row& row : rows_of(problem)) {
    if (row.index == 0) continue;
    const auto& y = row.definitions[0].update.state.force;
    slips += row.definitions[0].update.state.regime == law::Regime::kSlip ? 1 : 0;
    CHECK(std::hypot(y[0], y[1]) <= 20.0 * (1 + 1e-12));
    CHECK(40.0 * row.quantities[1] + y[0] ==
          Approx(row.quantities[cases::kFirstForce + 1]).margin(kForceError));
    CHECK(90.0 * row.quantities[2] + y[1] ==
          Approx(row.quantities[cases::kFirstForce + 2]).margin(kForceError));
  }
  CHECK(slips > 30);
}

TEST_CASE("loads in a plane beyond the limit have no static solution") {
  cases::Case problem = slider_case({});
  problem.connection = law::find_connection("SLIDE-PLANE").value();
  problem.definitions[0].law.slip = law::slip_space({2, 3});
  problem.force_driven = law::ComponentSet::of(2, 3);
  cases::Step one = step("pull", 10, cases::kFirstForce + 1, history::LinearTo{18.0});
  one.drives.push_back({cases::kFirstForce + 2, history::LinearTo{18.0}});
  problem.steps = {one};
  const std::string message = failure_of(problem);
  CHECK(message.find("step 'pull', t = 0.78") == 0);  // 20/(18 sqrt 2) = 0.7857
  CHECK(message.find("the loads f2 = 14.1") != std::string::npos);
  CHECK(message.find("cannot be held together (friction 'sleeve' has the limit 20)") !=
        std::string::npos);
}

}  // namespace
}  // namespace slipbench::driver::bench
