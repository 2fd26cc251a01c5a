// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/exact_integration.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "driver/results/events.hpp"
#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

cases::Case exactly(cases::Case problem) {
  problem.integration = {cases::IntegrationMethod::kExact, 1e-12};
  return problem;
}

/// Pressed by |f2|: 100 N at first, 25 N at the end of the second step.
cases::Case unloading_case(int increments) {
  cases::Case problem =
      slider_case({step("load", increments, 0, history::LinearTo{0.015}),
                   step("unload", increments, cases::kFirstForce + 1, history::LinearTo{25.0}),
                   step("reload", increments, cases::kFirstForce + 1, history::LinearTo{150.0})});
  problem.steps[0].drives.push_back({cases::kFirstForce + 1, history::Constant{100.0}});
  problem.definitions[0].law.internal_contact_force = 0.0;
  problem.definitions[0].law.contact_force = law::DerivedComponent{law::norm_term({2}, 1.0)};
  return problem;
}

TEST_CASE("the increment begins with the forces of its begin") {
  for (const int increments : {1, 3, 40}) {
    const auto rows = rows_of(exactly(unloading_case(increments)));
    const DefinitionRow& end = rows.back().definitions[0];
    CHECK(end.update.state.force[0] == Approx(5.0).epsilon(1e-13));
    CHECK(end.update.state.accumulated_slip == Approx(0.010).epsilon(1e-12));
    CHECK(end.dissipation == Approx(0.1).epsilon(1e-12));
  }
}

TEST_CASE("located changes become events") {
  const cases::Case problem = exactly(unloading_case(1));
  const auto rows = rows_of(problem);
  results::EventDetector detector(problem);
  std::vector<results::Event> events;
  for (const Row& row : rows) {
    for (const results::Event& event : detector.take(row)) events.push_back(event);
  }
  REQUIRE(events.size() == 2);
  // mu N = 15 N at a third of the second step; reloading sticks at once.
  CHECK(events[0].time == Approx(1.0 + 1.0 / 3.0).epsilon(1e-12));
  CHECK(events[0].force == Approx(15.0).epsilon(1e-12));
  CHECK(events[0].to == law::Regime::kSlip);
  CHECK(events[1].time == Approx(2.0).epsilon(1e-12));
  CHECK(events[1].to == law::Regime::kStick);
}

TEST_CASE("a normal force that jumps between steps does so before the increment") {
  cases::Case problem = unloading_case(1);
  problem.steps[1].drives = {{cases::kFirstForce + 1, history::Constant{25.0}}};
  const auto rows = rows_of(exactly(std::move(problem)));
  CHECK(rows[2].definitions[0].update.state.force[0] == Approx(5.0).epsilon(1e-14));
  // The spring relaxes as under a fast fall of N: (15^2 - 5^2)/(2 k).
  CHECK(rows[2].definitions[0].dissipation == Approx(0.1).epsilon(1e-13));
}

TEST_CASE("a changing coefficient goes over within the increment") {
  const auto end = [](int increments) {
    cases::Case problem = slider_case({step("hold", 1, 0, history::LinearTo{0.019}),
                                       step("change", increments, 0, history::LinearTo{0.019}),
                                       step("back", increments, 0, history::LinearTo{-0.1})});
    cases::FrictionChange change;
    change.law = law::ConstantCoefficient{0.05};
    change.stick = {law::StickStiffness::Mode::kStiffness, 1000.0};
    problem.steps[1].friction_changes = {change};
    return rows_of(exactly(std::move(problem))).back();
  };
  for (const int increments : {1, 7}) {
    const DefinitionRow row = end(increments).definitions[0];
    CHECK(row.update.state.force[0] == Approx(-5.0).epsilon(1e-13));
    // At rest the force falls from 19 N to 5 N: 0.014 mm; then from 5 N to -5 N and on.
    CHECK(row.update.state.accumulated_slip == Approx(0.014 + 0.119 - 0.010).epsilon(1e-12));
    CHECK(row.dissipation == Approx((19.0 * 19.0 - 25.0) / 2000.0 + 5.0 * 0.109).epsilon(1e-12));
  }
}

TEST_CASE("a change of friction under a potential does not see the number of increments") {
  // Two axes, of which the stronger one slips, and their sum; slipping while the coefficient falls.
  const auto op = GENERATE(law::PotentialOperator::kMax, law::PotentialOperator::kSum);
  const auto mode =
      GENERATE(law::StickStiffness::Mode::kStiffness, law::StickStiffness::Mode::kElasticSlip);
  const bool elastic = mode == law::StickStiffness::Mode::kElasticSlip;
  CAPTURE(op == law::PotentialOperator::kMax, elastic);
  const auto end = [&](cases::IntegrationMethod method, int increments) {
    cases::Case problem = slider_case({step("press", increments, 0, history::LinearTo{0.025}),
                                       step("change", increments, 0, history::LinearTo{0.06}),
                                       step("back", increments, 0, history::LinearTo{-0.01})});
    problem.steps[0].drives.push_back({1, history::LinearTo{0.01}});
    problem.steps[1].drives.push_back({1, history::LinearTo{0.05}});
    problem.steps[2].drives.push_back({1, history::LinearTo{0.06}});
    const law::BuiltPotential built = both_axes(op, elastic ? 3.0 : 1.0);
    law::FrictionDefinition& definition = problem.definitions[0].law;
    definition.slip = built.slip;
    definition.criterion = built.criterion;
    definition.stick = {mode, elastic ? 0.02 : 1000.0};
    cases::FrictionChange change;
    change.law = law::ConstantCoefficient{0.05};
    change.stick = definition.stick;
    problem.steps[1].friction_changes = {change};
    problem.integration = {method, 1e-12};
    const DefinitionRow row = rows_of(problem).back().definitions[0];
    const law::FrictionState& state = row.update.state;
    return std::array{state.force[0], state.force[1], double{state.accumulated_slip},
                      double{row.dissipation}};
  };
  const auto one = end(cases::IntegrationMethod::kExact, 1);
  for (const int increments : {3, 50}) {
    const auto more = end(cases::IntegrationMethod::kExact, increments);
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(more[i] == Approx(one[i]).epsilon(1e-9));
  }
  const auto coarse = end(cases::IntegrationMethod::kBackwardEuler, 1000);
  const auto fine = end(cases::IntegrationMethod::kBackwardEuler, 2000);
  for (std::size_t i = 0; i < one.size(); ++i) {
    CAPTURE(i, one[i], coarse[i], fine[i]);
    // The error of the first power of the increment taken out, what is left is of the second.
    CHECK(2.0 * fine[i] - coarse[i] == Approx(one[i]).epsilon(2e-5));
    CHECK(std::abs(fine[i] - one[i]) <= 0.6 * std::abs(coarse[i] - one[i]) + 1e-9);
  }
}

TEST_CASE("a run that is cut goes on with the same bytes") {
  const cases::Case problem = exactly(unloading_case(7));
  auto whole = Simulation::start(problem);
  REQUIRE(whole);
  for (int i = 0; i < 9; ++i) REQUIRE(whole->advance().value());
  auto rest = Simulation::resume(problem, whole->state());
  REQUIRE(rest);
  while (whole->advance().value()) {
    REQUIRE(rest->advance().value());
    CHECK(rest->row().definitions[0].update.state == whole->row().definitions[0].update.state);
    CHECK(rest->row().definitions[0].dissipation == whole->row().definitions[0].dissipation);
  }
}

TEST_CASE("cases that have no exact path are refused with a reason") {
  const cases::Case plain = exactly(unloading_case(1));
  CHECK_FALSE(refuse_exact(plain));
  cases::Case falling = plain;
  falling.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 1.0};
  REQUIRE(refuse_exact(falling));
  CHECK(refuse_exact(falling)->message.find("friction 'sleeve'") == 0);
  cases::Case later = plain;
  cases::FrictionChange change;
  change.law = law::ExponentialDecay{0.3, 0.2, 1.0};
  change.stick = {law::StickStiffness::Mode::kStiffness, 1000.0};
  later.steps[1].friction_changes = {change};
  CHECK(refuse_exact(later));
  cases::Case driven = plain;
  driven.force_driven.insert(0);
  CHECK(refuse_exact(driven));
}

}  // namespace
}  // namespace slipbench::driver::bench
