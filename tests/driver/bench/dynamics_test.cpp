// SPDX-License-Identifier: Apache-2.0
// A mass on a belt: events, energies, and what must not depend on the increments.
#include "driver/bench/dynamics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

// Integrated to 1e-13 of the motion's size; some tens of events.
constexpr double kIntegration = 1e-11;

/// Reference case K6: m = 1, k = 100, N = 10, mu_s = 0.4, mu_k = 0.3, v = 0.05.
cases::Case belt_case(std::vector<cases::Step> steps) {
  cases::Case problem = slider_case(std::move(steps));
  problem.definitions[0].law.internal_contact_force = 10.0;
  problem.definitions[0].law.law = law::ConstantCoefficient{0.3};
  problem.kinetic.elasticity[0].emplace(100.0);
  problem.dynamics = cases::DynamicsData{0, 1.0, 0.05, 0.05, 0.4};
  return problem;
}

cases::Step rest(std::string name, int increments, double duration) {
  return {std::move(name), duration, increments, 1, {}};
}

double motion(const Row& row) { return row.quantities[0]; }

/// External work minus what it became.
double energy_gap(const Row& first, const Row& row) {
  const ConnectorForces& f = row.forces;
  double gap = f.external_work - (f.kinetic_energy - first.forces.kinetic_energy) -
               (f.elastic_energy - first.forces.elastic_energy) - f.viscous_dissipation;
  for (const DefinitionRow& d : row.definitions) gap -= d.dissipation;
  return gap;
}

TEST_CASE("the limit cycle of reference case K6 is met at its events") {
  const double slip_time = 0.406888787159141, period = 0.806888787159141;
  const std::vector<Row> rows = rows_of(belt_case({rest("all", 1, 0.8 + 6.6 * period)}));
  REQUIRE(rows.size() == 2);
  const law::RegimeChanges& changes = rows[1].definitions[0].changes;
  REQUIRE(changes.count == 8);
  CHECK(changes.overflow);
  const double duration = rows[1].duration;
  for (int i = 0; i < 8; ++i) {
    const law::RegimeChange& change = changes.at[static_cast<std::size_t>(i)];
    const double time = 0.8 + period * (i / 2) + (i % 2 == 0 ? 0.0 : slip_time);
    CHECK(change.fraction * duration == Approx(time).margin(kIntegration));
    CHECK(change.to == (i % 2 == 0 ? law::Regime::kSlip : law::Regime::kStick));
    // Breaks loose at mu_s N, is caught at x = 0.02.
    CHECK(change.force == Approx(i % 2 == 0 ? -4.0 : -2.0).margin(1e-9));
    CHECK(change.limit == Approx(4.0));
  }
  // After 6.6 cycles the seventh slip is over.
  CHECK(rows[1].definitions[0].dissipation == Approx(7.0 * 0.121033318073871).margin(kIntegration));
}

TEST_CASE("motion and heat do not depend on the increments") {
  const auto end = [](int increments) {
    return rows_of(belt_case({rest("all", increments, 7.3)})).back();
  };
  const Row coarse = end(1);
  for (const int increments : {7, 100, 3001}) {
    const Row row = end(increments);
    CHECK(motion(row) == Approx(motion(coarse)).margin(kIntegration));
    CHECK(row.forces.velocity == Approx(coarse.forces.velocity).margin(10 * kIntegration));
    CHECK(row.definitions[0].dissipation ==
          Approx(coarse.definitions[0].dissipation).margin(kIntegration));
  }
}

TEST_CASE("work of belt and load goes into heat, spring, damper and motion") {
  cases::Case problem = belt_case({rest("free", 10, 1.0)});
  problem.kinetic.damping[0].emplace(0.7);
  problem.definitions[0].law.law = law::ExponentialDecay{0.4, 0.25, 8.0};
  problem.dynamics->static_coefficient.reset();
  cases::Step loaded = rest("loaded", 60, 3.0);
  loaded.drives = {
      {cases::kFirstForce, history::Wave{history::WaveShape::kTriangle, 6.0, 1.3, 0.0, 0.0}}};
  cases::Step unpressed = rest("pressed", 60, 3.0);
  unpressed.drives = {{cases::kFirstForce, history::LinearTo{0.0}}};
  problem.steps.push_back(loaded);
  problem.steps.push_back(unpressed);
  const std::vector<Row> rows = rows_of(problem);
  int stick = 0, slip = 0;
  for (const Row& row : rows) {
    CHECK(std::abs(energy_gap(rows.front(), row)) < kIntegration);
    const law::FrictionUpdate& update = row.definitions[0].update;
    CHECK(std::abs(update.state.force[0]) <= update.limit * (1 + 1e-12));
    (update.state.regime == law::Regime::kSlip ? slip : stick) += 1;
  }
  CHECK(stick > 5);
  CHECK(slip > 5);
}

TEST_CASE("where the mass turns and slips on, that instant is a change of its own") {
  // m = 1, k = 100, limit 3 on a fixed track, x = 0, v = 1: x = -0.03 + 0.03 cos 10t + 0.1 sin 10t
  // stands still where tan 10t = 1/0.3.
  cases::Case problem = belt_case({rest("all", 1, 0.2)});
  problem.dynamics = cases::DynamicsData{0, 1.0, 0.0, 1.0, std::nullopt};
  const std::vector<Row> rows = rows_of(problem);
  const law::RegimeChanges& changes = rows[1].definitions[0].changes;
  REQUIRE(changes.count == 1);
  CHECK(changes.at[0].to == law::Regime::kSlip);
  CHECK(changes.at[0].fraction * rows[1].duration ==
        Approx(0.1 * std::atan2(1.0, 0.3)).margin(kIntegration));
  // The spring pulls with more than the limit; friction holds against it with the limit.
  CHECK(changes.at[0].force == Approx(-3.0));
  CHECK(changes.at[0].accumulated_slip ==
        Approx(-0.03 + std::hypot(0.03, 0.1)).margin(kIntegration));
}

TEST_CASE("a damped mass without friction swings like the textbook's") {
  // m = 2, k = 50, c = 3 from x = 1 at rest: x = e^(-d t) (cos w t + d/w sin w t).
  cases::Case problem = slider_case({rest("swing", 40, 4.0)});
  problem.definitions.clear();
  problem.initial[0] = 1.0;
  problem.kinetic.elasticity[0].emplace(50.0);
  problem.kinetic.damping[0].emplace(3.0);
  problem.dynamics = cases::DynamicsData{0, 2.0, 0.0, 0.0, {}};
  const double d = 3.0 / 4.0, w = std::sqrt(25.0 - d * d);
  const std::vector<Row> rows = rows_of(problem);
  for (const Row& row : rows) {
    const double t = row.time;
    const double x = std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t));
    CHECK(motion(row) == Approx(x).margin(kIntegration));
    CHECK(std::abs(energy_gap(rows.front(), row)) < kIntegration * 25.0);
  }
}

TEST_CASE("a resting mass breaks loose when the load or the lost grip says so, at that instant") {
  // No spring: the mass rests until f1 = 4 t exceeds mu_s N = 4, at t = 1.
  cases::Case problem = belt_case({});
  problem.kinetic.elasticity[0].reset();
  problem.dynamics->belt_velocity = problem.dynamics->initial_velocity = 0.0;
  problem.steps = {step("pull", 7, cases::kFirstForce, history::LinearTo{12.0}, 3.0)};
  const std::vector<Row> rows = rows_of(problem);
  for (const Row& row : rows) {
    // x'' = 4 t - 3 from t = 1.
    const double t = row.time;
    const double x =
        t < 1.0 ? 0.0
                : (4.0 * (t * t * t - 1.0) / 6.0 - 2.0 * (t - 1.0)) - 1.5 * (t - 1.0) * (t - 1.0);
    CHECK(motion(row) == Approx(x).margin(kIntegration));
  }
  CHECK(rows[3].definitions[0].changes.count == 1);
  CHECK(rows[2].time + rows[3].definitions[0].changes.at[0].fraction * rows[3].duration ==
        Approx(1.0).margin(1e-12));
}

TEST_CASE("a mass on its belt with equal coefficients slides on smoothly at the limit") {
  cases::Case problem = belt_case({rest("all", 50, 6.0)});
  problem.dynamics->static_coefficient.reset();
  for (const Row& row : rows_of(problem)) {
    // Rides to mu N/k = 0.03, then overshoots by nothing but its velocity: |x - 0.03| <= v/w.
    CHECK(std::abs(motion(row) - 0.03) <= 0.03 + 1e-12);
    if (row.time > 0.7) CHECK(std::abs(motion(row) - 0.03) <= 0.005 + 1e-12);
  }
}

TEST_CASE("a dynamic run that is cut and resumed gives the same bytes") {
  const cases::Case problem = belt_case({rest("all", 12, 4.0)});
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int cut = 0; cut < 12; ++cut) {
    auto resumed = Simulation::resume(problem, whole->state());
    REQUIRE(resumed);
    REQUIRE(resumed->advance());
    REQUIRE(whole->advance());
    CHECK(motion(resumed->row()) == motion(whole->row()));
    CHECK(resumed->row().definitions[0].dissipation == whole->row().definitions[0].dissipation);
  }
}

}  // namespace
}  // namespace slipbench::driver::bench
