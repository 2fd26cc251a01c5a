// SPDX-License-Identifier: Apache-2.0
// Friction that changes in the course of a step (docs/theory, section 9.2).
#include "driver/bench/friction_change.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

/// A change of the sleeve's coefficient alone.
cases::FrictionChange change_to(law::FrictionLaw law,
                                history::Profile amplitude = history::LinearTo{1.0}) {
  cases::FrictionChange change;
  change.amplitude = std::move(amplitude);
  change.law = std::move(law);
  change.stick = {law::StickStiffness::Mode::kStiffness, 1000.0};
  return change;
}

/// Slides on at 1 mm per step from the first increment on, mu 0.2 at first.
cases::Case sliding_case(std::vector<cases::FrictionChange> in_second, int repeat = 1) {
  cases::Case problem = slider_case({step("before", 4, 0, history::LinearTo{1.0}),
                                     step("change", 4, 0, history::LinearTo{2}, 1.0, repeat),
                                     step("after", 4, 0, history::LinearTo{3.0})});
  problem.steps[1].friction_changes = std::move(in_second);
  return problem;
}

double mu(const Row& row) { return row.definitions[0].update.mu; }

TEST_CASE("the coefficient goes over linearly and stays") {
  const auto rows = rows_of(sliding_case({change_to(law::ConstantCoefficient{0.12})}));
  REQUIRE(rows.size() == 13);
  CHECK(mu(rows[4]) == 0.2);
  CHECK(mu(rows[5]) == Approx(0.18).epsilon(1e-15));
  CHECK(mu(rows[7]) == Approx(0.14).epsilon(1e-15));
  CHECK(mu(rows[8]) == 0.12);
  CHECK(mu(rows[12]) == 0.12);
}

TEST_CASE("a smooth change has gone a tenth of the way after a quarter of the step") {
  const auto rows =
      rows_of(sliding_case({change_to(law::ConstantCoefficient{0.12}, history::SmoothTo{1.0})}));
  // 10/64 - 15/256 + 6/1024 = 0.103515625.
  CHECK(mu(rows[5]) == Approx(0.2 - 0.08 * 0.103515625).epsilon(1e-15));
  CHECK(mu(rows[6]) == Approx(0.16).epsilon(1e-15));
}

TEST_CASE("the corners of an amplitude have increments of their own") {
  const auto rows = rows_of(sliding_case({change_to(
      law::ConstantCoefficient{0.12}, history::Tabular{{0.0, 0.6, 1.0}, {0.0, 0.9, 1.0}})}));
  REQUIRE(rows.size() == 14);
  CHECK(rows[7].step_time == 0.6);
  CHECK(mu(rows[7]) == Approx(0.2 - 0.9 * 0.08).epsilon(1e-15));
  CHECK(mu(rows[13]) == 0.12);
}

TEST_CASE("a change sets out from the coefficient in force, whatever law gave it") {
  cases::Case problem = sliding_case({change_to(law::ConstantCoefficient{0.1})});
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.5};
  problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip, 1e-3};
  problem.steps[1].friction_changes[0].stick = problem.definitions[0].law.stick;
  const auto rows = rows_of(problem);
  const double start = mu(rows[4]);
  CHECK(start == Approx(0.2 + 0.1 * std::exp(-0.5)).epsilon(1e-12));
  CHECK(mu(rows[6]) == Approx(0.5 * (start + 0.1)).epsilon(1e-14));
}

TEST_CASE("in the first step a change sets out from nothing") {
  cases::Case problem = sliding_case({});
  problem.steps[0].friction_changes = {change_to(law::ConstantCoefficient{0.4})};
  const auto rows = rows_of(problem);
  CHECK(mu(rows[0]) == 0.0);
  CHECK(rows[0].definitions[0].update.state.regime == law::Regime::kOpen);
  CHECK(mu(rows[1]) == Approx(0.1).epsilon(1e-15));
  CHECK(mu(rows[4]) == 0.4);
  CHECK(mu(rows[8]) == 0.4);
}

TEST_CASE("in a repeated step the friction changes in the first pass") {
  cases::Case problem = sliding_case({change_to(law::ConstantCoefficient{0.12})}, 3);
  const auto rows = rows_of(problem);
  CHECK(mu(rows[6]) == Approx(0.16).epsilon(1e-15));
  for (const std::size_t i : {8U, 9U, 12U, 13U, 16U}) CHECK(mu(rows[i]) == 0.12);
}

TEST_CASE("the force limit switches with the step, the elastic slip follows the amplitude") {
  cases::Case problem = sliding_case({change_to(law::ConstantCoefficient{0.2})});
  problem.definitions[0].law.stick = {law::StickStiffness::Mode::kElasticSlip, 0.02};
  cases::FrictionChange& change = problem.steps[1].friction_changes[0];
  change.force_limit = 15.0;
  change.stick = {law::StickStiffness::Mode::kElasticSlip, 0.04};
  change.blends_elastic_slip = true;
  auto rows = rows_of(problem);
  CHECK(rows[4].definitions[0].update.limit == 20.0);
  CHECK(rows[5].definitions[0].update.limit == 15.0);
  // s_el is g_c in slip: 0.025, 0.03, .. 0.04.
  CHECK(rows[5].definitions[0].update.state.elastic_slip[0] == Approx(0.025).epsilon(1e-14));
  CHECK(rows[6].definitions[0].update.state.elastic_slip[0] == Approx(0.03).epsilon(1e-14));
  CHECK(rows[8].definitions[0].update.state.elastic_slip[0] == 0.04);
  CHECK(rows[12].definitions[0].update.state.elastic_slip[0] == 0.04);
  change.blends_elastic_slip = false;
  rows = rows_of(problem);
  CHECK(rows[5].definitions[0].update.state.elastic_slip[0] == 0.04);
}

TEST_CASE("the simulation tells the definition in force") {
  const cases::Case problem = sliding_case({change_to(law::ConstantCoefficient{0.12})});
  auto simulation = Simulation::start(problem);
  REQUIRE(simulation);
  for (int i = 0; i < 5; ++i) REQUIRE(simulation->advance().value());
  CHECK(simulation->definition(0).blend.start == 0.2);
  CHECK(simulation->definition(0).blend.weight == 0.25);
  for (int i = 0; i < 3; ++i) REQUIRE(simulation->advance().value());
  CHECK(simulation->definition(0).blend.weight == 1.0);
}

TEST_CASE("a run cut before, within or after a change gives the same rows, to the last bit") {
  cases::Case problem = sliding_case({change_to(law::ExponentialDecay{0.35, 0.2, 0.3},
                                                history::Tabular{{0, 0.6, 1}, {0, 0.9, 1}})},
                                     2);
  problem.steps[2].friction_changes = {
      change_to(law::ConstantCoefficient{0.1}, history::SmoothTo{1.0})};
  // A start value that no law gives as it stands: the decay at the rate of the slip.
  problem.definitions[0].law.law = law::ExponentialDecay{0.3, 0.2, 0.7};
  const std::vector<Row> whole = rows_of(problem);
  REQUIRE(whole.size() == 1 + 4 + 5 + 4 + 4);
  for (std::size_t cut = 0; cut + 1 < whole.size(); ++cut) {
    auto first = Simulation::start(problem);
    REQUIRE(first);
    for (std::size_t i = 0; i < cut; ++i) REQUIRE(first->advance().value());
    auto second = Simulation::resume(problem, first->state());
    REQUIRE(second);
    for (std::size_t i = cut + 1; i < whole.size(); ++i) {
      REQUIRE(second->advance().value());
      const law::FrictionUpdate& update = second->row().definitions[0].update;
      INFO("cut after " << cut << ", row " << i);
      CHECK(update.state == whole[i].definitions[0].update.state);
      CHECK(update.mu == mu(whole[i]));
      CHECK(update.limit == whole[i].definitions[0].update.limit);
    }
  }
}

TEST_CASE("a case without changes has none to pay for") {
  FrictionChanges changes;
  std::vector<law::FrictionDefinition> definitions(1);
  REQUIRE(changes.begin_step(cases::Step{}, true, 0.0, {}, definitions));
  CHECK_FALSE(changes.active());
  CHECK(changes.next_breakpoint(0.0) == history::kNoBreakpoint);
}

}  // namespace
}  // namespace slipbench::driver::bench
