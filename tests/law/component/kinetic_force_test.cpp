// SPDX-License-Identifier: Apache-2.0
// Springs and dampers of free components as what presses: forces, energies, slopes, and the points
// of a straight piece of history.
#include "law/component/kinetic_force.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "law/exact/continuous_update.hpp"
#include "law/exact/path_segment.hpp"
#include "law/update/connector_tangent.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// K of the components 1 and 3.
CoupledStiffness coupled(double k11, double k13, double k33) {
  CoupledStiffness springs;
  springs.components = ComponentSet::of(1, 3);
  springs.stiffness[0][0] = k11;
  springs.stiffness[0][2] = springs.stiffness[2][0] = k13;
  springs.stiffness[2][2] = k33;
  return springs;
}

ConnectorIncrement increment_to(const std::array<double, kComponents>& end, double duration = 0.5) {
  ConnectorIncrement increment;
  increment.duration = duration;
  increment.end.position.values = end;
  increment.end.motion.values = end;
  return increment;
}

TEST_CASE("coupled springs give K u, their rows, and u K u/2 over all components") {
  KineticBehavior behavior;
  behavior.coupled = coupled(100, 30, 50);
  behavior.elasticity[1].emplace(7.0);
  const Ambient at = increment_to({0.2, 3.0, -0.1, 0, 0, 0}).end;
  const ElasticForce first = elastic_force(behavior, 0, at);
  CHECK(first.force == Approx(100 * 0.2 - 30 * 0.1).epsilon(1e-15));
  CHECK(first.slope == std::array<double, kComponents>{100, 0, 30, 0, 0, 0});
  CHECK(elastic_force(behavior, 1, at).force == 21.0);
  CHECK(elastic_force(behavior, 3, at).force == 0.0);
  double energy = 0.0;
  for (int c = 0; c < kComponents; ++c) energy += elastic_energy(behavior, c, at);
  CHECK(energy == Approx(50 * 0.04 - 30 * 0.02 + 25 * 0.01 + 3.5 * 9).epsilon(1e-15));
}

TEST_CASE("a component without a spring or damper has no kinetic force") {
  KineticBehavior behavior;
  behavior.damping[2].emplace(4.0);
  behavior.elasticity[2].emplace(10.0);
  const ConnectorIncrement increment = increment_to({1, 1, 0.3, 1, 1, 1});
  CHECK(kinetic_force(behavior, 0, 5.0, increment.end) == 0.0);
  CHECK(kinetic_force(behavior, 2, mean_velocity(increment, 2), increment.end) ==
        Approx(10 * 0.3 + 4 * 0.6).epsilon(1e-15));
  CHECK(mean_velocity(increment_to({1, 0, 0, 0, 0, 0}, 0.0), 0) == 0.0);
}

TEST_CASE("the components of a contact force are those it depends on") {
  CHECK(components_of(NoContactForce{}).empty());
  CHECK(components_of(ComponentContactForce{2}) == ComponentSet::of(3));
  CHECK(components_of(DerivedComponent{norm_term({2, 3}, 1.0), norm_term({6}, 2.0)}) ==
        ComponentSet::of(2, 3, 6));
  CHECK(components_of(UniversalJointContact{}) == ComponentSet::of(1, 2, 3, 5));
}

/// Springs of all kinds and dampers, some of which press.
KineticBehavior random_behavior(Dice& dice) {
  KineticBehavior behavior;
  behavior.coupled = coupled(dice.between(50, 400), dice.between(-40, 40), dice.between(50, 400));
  behavior.elasticity[1].emplace(make_function(
      {{-dice.between(50, 300), -2}, {0, 0}, {dice.between(20, 200), 2}}, {over_motion(2)}));
  behavior.damping[2].emplace(dice.between(0.5, 5));
  behavior.damping[1].emplace(make_function(
      {{-dice.between(10, 40), -9}, {0, 0}, {dice.between(10, 40), 9}}, {kOverSlipRate}));
  behavior.pressing = ComponentSet::of(2, 3);
  return behavior;
}

TEST_CASE("an increment without duration has the slopes of its springs, not of its dampers") {
  KineticBehavior behavior;
  behavior.elasticity[2].emplace(40.0);
  behavior.damping[2].emplace(3.0);
  behavior.pressing = ComponentSet::of(3);
  ConnectorIncrement increment = increment_to({0, 0, 0.2, 0, 0, 0}, 0.0);
  CHECK(kinetic_slopes(behavior, increment)(2, 2) == Approx(40.0));
  increment.duration = 0.5;
  CHECK(kinetic_slopes(behavior, increment)(2, 2) == Approx(40.0 + 3.0 / 0.5));
}

TEST_CASE("the tangent under springs that press meets differences") {
  Dice dice(20);
  int slips = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const KineticBehavior behavior = random_behavior(dice);
    FrictionDefinition definition;
    definition.slip = slip_space({1, 4});
    definition.slip.scale[1] = 0.3;
    definition.contact_force = DerivedComponent{norm_term({2, 3}, dice.between(0.5, 2))};
    definition.law = ConstantCoefficient{dice.between(0.1, 0.5)};
    definition.stick = {StickStiffness::Mode::kStiffness, dice.between(100, 3000)};
    ConnectorIncrement increment =
        increment_to({dice.between(-0.3, 0.3), dice.between(0.05, 0.4), dice.between(-0.4, -0.05),
                      dice.between(-1, 1), 0, 0},
                     dice.between(0.1, 2));
    const FrictionState old;
    const auto forces = [&](ConnectorIncrement at) {
      set_kinetic_forces(behavior, behavior.pressing, &at);
      const FrictionUpdate u = update(definition, at, old);
      return std::pair{friction_force(definition, u.state), u.state.regime};
    };
    set_kinetic_forces(behavior, behavior.pressing, &increment);
    const FrictionUpdate here = update(definition, increment, old);
    const ConnectorTangent tangent = connector_tangent(definition, increment, here);
    const auto whole =
        (tangent.to_motion + tangent.to_force * kinetic_slopes(behavior, increment)).eval();
    for (int j = 0; j < kComponents; ++j) {
      constexpr double kStep = 1e-6;
      ConnectorIncrement ahead = increment;
      ConnectorIncrement behind = increment;
      for (const auto& [at, h] : {std::pair{&ahead, kStep}, std::pair{&behind, -kStep}}) {
        at->end.position[j] += h;
        at->end.motion[j] += h;
      }
      const auto [f, regime_ahead] = forces(ahead);
      const auto [g, regime_behind] = forces(behind);
      if (regime_ahead != here.state.regime || regime_behind != here.state.regime) continue;
      for (int i = 0; i < kComponents; ++i) {
        INFO("trial " << trial << ", df" << i << "/du" << j);
        CHECK(whole(i, j) ==
              Approx((f[i] - g[i]) / (2 * kStep)).margin(1e-5 * whole.cwiseAbs().maxCoeff()));
      }
    }
    slips += here.state.regime == Regime::kSlip ? 1 : 0;
  }
  CHECK(slips > 50);
  CHECK(slips < 200);
}

TEST_CASE("a point of a segment sees the spring at its own place and the velocity of the whole") {
  KineticBehavior behavior;
  // 100 N at 0.1, back to 20 N at 0.3: the forces at the ends do not tell.
  behavior.elasticity[2].emplace(make_function({{0, 0}, {100, 0.1}, {20, 0.3}}, {over_motion(3)}));
  behavior.damping[2].emplace(5.0);
  behavior.pressing = ComponentSet::of(3);
  FrictionDefinition definition;
  definition.contact_force = ComponentContactForce{2};
  definition.law = ConstantCoefficient{0.1};
  ConnectorIncrement increment = increment_to({0, 0, 0.3, 0, 0, 0}, 1.0);
  set_kinetic_forces(behavior, behavior.pressing, &increment);
  CHECK(increment.force[2] == Approx(20 + 1.5).epsilon(1e-15));
  PathSegment segment = path_segment(definition, increment, {}, {});
  segment.kinetic = &behavior;
  SegmentPoints points(definition, segment, 0.0);
  CHECK(points.increment(0.0).force[2] == Approx(1.5).epsilon(1e-15));
  CHECK(points.increment(1.0 / 3.0).force[2] == Approx(101.5).epsilon(1e-14));
  CHECK(points.increment(2.0 / 3.0).force[2] == Approx(61.5).epsilon(1e-14));
  CHECK(points.limit(1.0 / 3.0, 0, 0, 1).force == Approx(10.15).epsilon(1e-14));
}

TEST_CASE("a mean velocity is the motion over the time and 0 without any") {
  for (const double duration : {1e-9, 1e-3, 1.0, 1e9}) {
    CHECK(mean_velocity(increment_to({0, 0, 3.0, 0, 0, 0}, duration), 2) == 3.0 / duration);
  }
  CHECK(mean_velocity(increment_to({0, 0, 3.0, 0, 0, 0}, 0.0), 2) == 0.0);
}

}  // namespace
