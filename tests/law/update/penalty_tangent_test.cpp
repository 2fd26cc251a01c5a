// SPDX-License-Identifier: Apache-2.0
#include "law/update/penalty_tangent.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "law/friction/law_list.hpp"
#include "law/update/connector_tangent.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/force_difference.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Branch of an evaluation, which must not change between the evaluations of a difference quotient.
struct Branch {
  Regime regime = Regime::kOpen;
  bool clipped = false;
  std::array<bool, 2> negative{};  ///< of the trial along the axes
  friend bool operator==(const Branch&, const Branch&) = default;
};
Branch branch_of(const FrictionUpdate& u) {
  return {u.state.regime, u.tangent.clip < 1.0, {u.trial[0] < 0.0, u.trial[1] < 0.0}};
}

struct Count {
  int compared = 0;
  int clipped = 0;
  int slipping = 0;
};

/// Compares connector_tangent() with one-sided differences from both sides in all components.
void compare(const FrictionDefinition& definition, const ConnectorIncrement& increment,
             const FrictionState& old, Count* count) {
  const FrictionUpdate here = update(definition, increment, old);
  const Branch branch = branch_of(here);
  const ConnectorTangent tangent = connector_tangent(definition, increment, here);
  const auto force_at = [&](const ConnectorIncrement& moved, int c) -> std::optional<double> {
    const FrictionUpdate u = update(definition, moved, old);
    if (!(branch_of(u) == branch)) return std::nullopt;
    return friction_force(definition, u.state)[c];
  };
  struct Pair {
    double analytic;
    Derivative difference;
  };
  std::vector<Pair> pairs;
  double scale = 0.0;
  for (int i = 0; i < kComponents; ++i) {
    for (int j = 0; j < kComponents; ++j) {
      for (const double side : {1.0, -1.0}) {
        const auto by_motion = force_by_motion(force_at, increment, i, j, side * 1e-5);
        const auto by_force = force_by_force(force_at, increment, i, j, side * 1e-3);
        if (!by_motion || !by_force) return;
        pairs.push_back({tangent.to_motion(i, j), *by_motion});
        pairs.push_back({tangent.to_force(i, j), *by_force});
        scale = std::max({scale, std::abs(tangent.to_motion(i, j))});
      }
    }
  }
  for (const Pair& pair : pairs) {
    // Rounding of a force of 20 over a step of 1e-5, and the estimate of the quotient's own error.
    const double tolerance =
        3e-8 * std::max(scale, std::abs(pair.analytic)) + 2e-8 + 2.0 * pair.difference.error;
    REQUIRE(std::abs(pair.analytic - pair.difference.value) <= tolerance);
  }
  ++count->compared;
  count->clipped += branch.clipped ? 1 : 0;
  count->slipping += branch.regime == Regime::kSlip ? 1 : 0;
}

std::vector<std::pair<std::string, FrictionLaw>> laws() {
  GeneralizedViscous polynomial;
  polynomial.fric = 0.12;
  polynomial.c1 = 2e-4;
  polynomial.c2 = 0.01;
  polynomial.c3 = 1e-5;
  polynomial.c5 = 2e-3;
  polynomial.area = 2.0;
  return {{"constant", ConstantCoefficient{0.2}},
          {"decay", ExponentialDecay{0.3, 0.15, 0.4}},
          {"polynomial", polynomial}};
}

std::vector<std::pair<std::string, std::variant<ViscousPenalty, StiffnessPenalty>>> penalties() {
  ViscousPenalty number;
  number.coefficient = 4.0;
  ViscousPenalty table;
  table.visf = 1.7;
  table.mass = 0.1;
  table.stiffness = make_function({{50, 0, -1}, {90, 200, -1}, {70, 0, 1}, {60, 200, 1}},
                                  {kOverContactForce, over_position(4)});
  return {{"C", number}, {"K over force and position", table}, {"K_t", StiffnessPenalty{200.0}}};
}

std::vector<std::pair<std::string, Filter>> filters() {
  return {{"none", {}},
          {"simple", {Filter::Kind::kSimple, 0.3, false}},
          {"clipped", {Filter::Kind::kSimple, 0.3, true}}};
}

TEST_CASE("the tangent of a contact penalty meets one-sided differences") {
  Dice dice(41);
  int clipped = 0;
  for (const auto& [law_name, law] : laws()) {
    for (const auto& [penalty_name, penalty] : penalties()) {
      for (const auto& [filter_name, filter] : filters()) {
        for (const Convention convention : {Convention::kDocumented, Convention::kAsCoded}) {
          for (const int axes : {0, 1, 2}) {
            INFO(law_name << ", " << penalty_name << ", filter " << filter_name << ", as coded "
                          << (convention == Convention::kAsCoded) << ", orthotropic " << axes);
            FrictionDefinition definition;
            definition.slip = slip_space({2, 3}, 1.3);
            definition.contact_force = ComponentContactForce{0};
            definition.internal_contact_force =
                make_function({{20, -1, 0}, {30, 1, 0}, {18, -1, 5}, {25, 1, 5}},
                              {over_position(5), kOverAccumulatedSlip});
            definition.law = law;
            Formulation& formulation = definition.formulation.emplace();
            formulation.penalty = penalty;
            formulation.filter = filter;
            formulation.convention = convention;
            if (axes > 0) {
              formulation.orthotropy = Orthotropy{
                  .second = ExponentialDecay{0.15, 0.05, 0.3},
                  .first = {0.8, -0.6},
                  .speed = axes == 1 ? Orthotropy::Speed::kComponent : Orthotropy::Speed::kTotal};
            } else {
              definition.slip = slip_space({1, 2, 3}, 1.3);
              definition.contact_force = ComponentContactForce{5};
            }
            Count count;
            for (int trial = 0; trial < 20; ++trial) {
              FrictionRun run(definition);
              run.duration = 0.1;
              const auto move = [&](double stride, double force) {
                for (int c = 0; c < kComponents; ++c) {
                  run.position[c] +=
                      c < 3 ? dice.between(-stride, stride) : dice.between(-0.02, 0.02);
                }
                run.force[0] = run.force[5] = force;
              };
              move(1.0, dice.between(60.0, 100.0));
              run.step();
              move(1.0, dice.between(60.0, 100.0));
              run.step();
              move(dice.chance(0.5) ? 0.1 : 1.0,
                   trial % 2 == 0 ? dice.between(20.0, 50.0) : -dice.between(50.0, 90.0));
              compare(definition, run.increment(), run.state, &count);
            }
            CHECK(count.compared > 8);
            CHECK(count.slipping > 0);
            clipped += count.clipped;
          }
        }
      }
    }
  }
  CHECK(clipped > 70);
}

TEST_CASE("the tangent of a clipped force is in proportion to the unit of force") {
  const auto slopes = [](double unit) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1.0), {2, 3});
    definition.contact_force = ComponentContactForce{0};
    definition.law = ExponentialDecay{0.3, 0.15, 0.4};
    Formulation& formulation = definition.formulation.emplace();
    formulation.penalty = StiffnessPenalty{200.0 * unit};
    formulation.filter = {Filter::Kind::kSimple, 0.3, true};
    formulation.orthotropy = Orthotropy{.second = ConstantCoefficient{0.15}, .first = {0.8, -0.6}};
    FrictionRun run(definition);
    run.duration = 0.1;
    run.force[0] = 100.0 * unit;
    run.position[1] = 1.0;
    run.position[2] = 0.4;
    run.step();
    run.force[0] = 20.0 * unit;
    run.position[1] = 1.3;
    const ConnectorIncrement increment = run.increment();
    const FrictionUpdate u = run.step();
    CHECK(u.tangent.clip < 1.0);
    return connector_tangent(definition, increment, u);
  };
  const ConnectorTangent large = slopes(1.0);
  const ConnectorTangent small = slopes(1e-6);
  for (int i = 1; i < 3; ++i) {
    CHECK(small.to_force(i, 0) == Approx(large.to_force(i, 0)).epsilon(1e-9));
    for (int j = 1; j < 3; ++j) {
      CHECK(small.to_motion(i, j) == Approx(1e-6 * large.to_motion(i, j)).epsilon(1e-9));
    }
  }
}

TEST_CASE("without a contact nothing follows") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1.0), {2, 3});
  definition.formulation.emplace().penalty = StiffnessPenalty{100.0};
  FrictionRun run(definition);
  run.position[1] = 1.0;
  const ConnectorIncrement increment = run.increment();
  CHECK(connector_tangent(definition, increment, run.step()).to_motion.isZero(0.0));
}

TEST_CASE("sticking follows with the penalty, filtered in the share of the filter") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1.0), {2, 3});
  Formulation& formulation = definition.formulation.emplace();
  formulation.penalty = StiffnessPenalty{100.0};
  const auto slope = [&] {
    FrictionRun run(definition);
    run.duration = 0.01;
    run.position[1] = 1e-3;
    const ConnectorIncrement increment = run.increment();
    return connector_tangent(definition, increment, run.step()).to_motion(1, 1);
  };
  CHECK(slope() == Approx(100.0));
  formulation.filter = {Filter::Kind::kSimple, 0.25, false};
  CHECK(slope() == Approx(25.0));
  formulation.convention = Convention::kAsCoded;
  CHECK(slope() == Approx(25.0));
  formulation.filter = {};
  ViscousPenalty viscous;
  viscous.coefficient = 3.0;
  formulation.penalty = viscous;
  CHECK(slope() == Approx(300.0));
}

TEST_CASE("under the total speed a slow orthotropic slip follows the slope of its law") {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1.0), {2, 3});
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  Formulation& formulation = definition.formulation.emplace();
  formulation.penalty = StiffnessPenalty{1e9};
  formulation.orthotropy =
      Orthotropy{.second = definition.law, .first = {1.0, 0.0}, .speed = Orthotropy::Speed::kTotal};
  FrictionRun run(definition);
  run.duration = 1e-4;
  run.position[1] = 1e-4;
  const ConnectorIncrement increment = run.increment();
  const ConnectorTangent tangent = connector_tangent(definition, increment, run.step());
  // 100 dmu/dv at v = 1, over the duration.
  CHECK(tangent.to_motion(1, 1) == Approx(-100.0 * 0.1 * 0.05 * std::exp(-0.05) / 1e-4));
}

TEST_CASE("under the speed along its axis a slip of any size follows the slope of its law") {
  for (const double v : {5e-4, -5e-4, 5.0, -5.0}) {
    FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1.0), {2, 3});
    definition.law = ExponentialDecay{0.3, 0.2, 0.5 / std::abs(v)};
    Formulation& formulation = definition.formulation.emplace();
    formulation.penalty = StiffnessPenalty{1e9};
    formulation.orthotropy = Orthotropy{
        .second = definition.law, .first = {1.0, 0.0}, .speed = Orthotropy::Speed::kComponent};
    FrictionRun run(definition);
    run.position[1] = v;
    const ConnectorIncrement increment = run.increment();
    const ConnectorTangent tangent = connector_tangent(definition, increment, run.step());
    CHECK(tangent.to_motion(1, 1) ==
          Approx(-100.0 * 0.1 * 0.5 / std::abs(v) * std::exp(-0.5)).epsilon(1e-9));
  }
}

TEST_CASE("the viscous force of a light contact follows the root of its stiffness") {
  // C = sqrt(2 K m) = sqrt(N) with K = N and m = 1/2; where K begins at N = 1 a quarter has none.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1.0), {2, 3});
  definition.contact_force = ComponentContactForce{0};
  Formulation& formulation = definition.formulation.emplace();
  for (const bool orthotropic : {false, true}) {
    if (orthotropic) formulation.orthotropy = Orthotropy{.second = ConstantCoefficient{0.2}};
    for (const double from : {0.0, 1.0}) {
      ViscousPenalty penalty;
      penalty.visf = 1.0;
      penalty.mass = 0.5;
      penalty.stiffness = make_function({{0, from}, {100, from + 100}}, {kOverContactForce});
      formulation.penalty = penalty;
      FrictionRun run(definition);
      run.position[1] = 0.01;
      run.force[0] = 0.25;
      const ConnectorIncrement increment = run.increment();
      const ConnectorTangent tangent = connector_tangent(definition, increment, run.step());
      INFO("stiffness from " << from << ", orthotropic " << orthotropic);
      CHECK(tangent.to_motion(1, 1) == Approx(from > 0.0 ? 0.0 : 0.5));
      CHECK(tangent.to_force(1, 0) == Approx(from > 0.0 ? 0.0 : 0.01 * 0.5 / 0.5));
    }
  }
}

}  // namespace
