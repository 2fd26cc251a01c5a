// SPDX-License-Identifier: Apache-2.0
// Exponents at which a share (X/F_lim)^(b-1) says little of X, or X little of its share.
#include <catch2/catch.hpp>
#include <cmath>

#include "law/definition/potential_terms.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/potential_return.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
namespace test = slipbench::test;

FrictionDefinition sliding(std::vector<PotentialContribution> terms, double exponent,
                           double limit) {
  const BuiltPotential built = build_potential(terms, PotentialOperator::kSum, exponent);
  REQUIRE(built.violations.empty());
  FrictionDefinition definition;
  definition.slip = built.slip;
  definition.criterion = built.criterion;
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force = limit;
  definition.law = ConstantCoefficient{1.0};
  definition.stick = {StickStiffness::Mode::kStiffness, 1.0};
  return definition;
}

TEST_CASE("near the exponent 1 a part comes back to its dead zone and no further") {
  // X_1 = |f1|, X_2 = <|f2| - 4>; at b = 1 the force returns to f1 = 10, f2 = 4.
  const DerivedComponent second = {norm_term({2}, 1.0)};
  PotentialContribution shifted;
  shifted.of = second;
  shifted.function = ContributionFunction::kMacauley;
  shifted.shift = 4.0;
  for (const double b : {1.0, 1.0001, 1.001}) {
    const FrictionDefinition definition = sliding({PotentialContribution{}, shifted}, b, 10.0);
    ConnectorIncrement increment;
    increment.duration = 1.0;
    increment.end.position[0] = 50.0;
    increment.end.position[1] = 5.0;  // 1 beyond the dead zone, pulled on by 40
    const FrictionUpdate u = update(definition, increment, {});
    CHECK(u.converged);
    CHECK(u.state.regime == Regime::kSlip);
    CHECK(u.state.force[0] == Approx(10.0).epsilon(1e-12));
    CHECK(u.state.force[1] == Approx(4.0).epsilon(1e-12));
  }
}

TEST_CASE(
    "after many elastic slips a sum keeps its last part beside one that is far in its dead zone") {
  // X_1 = |f1| is pulled on for 1e17 up to 0, X_2 = <|f2| - dead> for half of that.
  PotentialContribution shifted;
  shifted.of = DerivedComponent{norm_term({2}, 1.0)};
  shifted.function = ContributionFunction::kMacauley;
  for (int i = 1; i < 20; ++i) {
    const double reach = 1e17 * std::sqrt(i);
    shifted.shift = reach;
    const FrictionDefinition definition = sliding({PotentialContribution{}, shifted}, 1.0, 2.0);
    ConnectorIncrement increment;
    increment.duration = 1.0;
    increment.end.position[0] = reach;
    increment.end.position[1] = 1.5 * reach;
    const FrictionUpdate u = update(definition, increment, {});
    CHECK(u.state.force[0] == Approx(2.0).epsilon(1e-14));
    CHECK(u.state.force[1] == Approx(reach).epsilon(1e-14));
  }
}

TEST_CASE("a large exponent finds the corner of the maximum") {
  // One part of several terms next to another: what is left of a term is t - c q.
  PotentialContribution two;
  two.of = DerivedComponent{norm_term({2}, 1.0), norm_term({3}, 1.0)};
  const double limit = 1.0;
  for (const double b : {100.0, 1e4, 1e6, 1e8}) {
    const FrictionDefinition definition = sliding({PotentialContribution{}, two}, b, limit);
    for (const double reach : {3.0, 30.0, 300.0}) {
      ConnectorIncrement increment;
      increment.duration = 1.0;
      increment.end.position[0] = reach;
      increment.end.position[1] = 0.5 * reach + 0.3;
      increment.end.position[2] = 0.5 * reach;
      const FrictionUpdate u = update(definition, increment, {});
      INFO("b = " << b << ", reach " << reach);
      CHECK(u.converged);
      CHECK(u.state.regime == Regime::kSlip);
      CHECK(std::abs(u.phi) <= 1e-12 * limit);
      // max(|y1|, |y2| + |y3|) = 1, to a few ln(2)/b: y2 - y3 keeps its 0.3.
      const double near = 3.0 * std::log(reach + 2.0) / b + 1e-12 * reach;
      CHECK(u.state.force[0] == Approx(1.0).margin(near));
      CHECK(u.state.force[1] == Approx(0.65).margin(near));
      CHECK(u.state.force[2] == Approx(0.35).margin(near));
    }
  }
}

TEST_CASE("after any number of elastic slips a sum of powers leaves the force in its direction") {
  PotentialContribution second, third;
  second.of = DerivedComponent{norm_term({2}, 1.0)};
  third.of = DerivedComponent{norm_term({3}, 1.0)};
  for (const double b : {1.5, 2.0, 20.0}) {
    const FrictionDefinition definition = sliding({PotentialContribution{}, second, third}, b, 1.0);
    for (const double reach : {1e6, 1e12, 1e18, 1e24}) {
      ConnectorIncrement increment;
      increment.duration = 1.0;
      increment.end.position[0] = reach;
      increment.end.position[1] = -0.5 * reach;
      increment.end.position[2] = 0.25 * reach;
      const FrictionUpdate u = update(definition, increment, {});
      INFO("b = " << b << ", reach " << reach);
      CHECK(u.converged);
      // |y_i|^(b-1) goes with the motion; the way turns by a few elastic slips.
      const double turned = 10.0 / reach + 1e-13;
      CHECK(u.state.force[1] / u.state.force[0] ==
            Approx(-std::pow(0.5, 1.0 / (b - 1.0))).epsilon(turned));
      CHECK(u.state.force[2] / u.state.force[0] ==
            Approx(std::pow(0.25, 1.0 / (b - 1.0))).epsilon(turned));
      double sum = 0.0;
      for (const double y : u.state.force) sum += std::pow(std::abs(y), b);
      CHECK(std::pow(sum, 1.0 / b) == Approx(1.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("after any number of elastic slips a sum keeps its last part, and follows its limit") {
  PotentialContribution plane;
  plane.of = DerivedComponent{norm_term({2, 3}, 1.0)};
  for (const double b : {1.0, 3.0}) {
    const FrictionDefinition definition = sliding({PotentialContribution{}, plane}, b, 2.0);
    for (const double reach : {1e6, 1e12, 1e17, 1e20}) {
      ConnectorIncrement increment;
      increment.duration = 1.0;
      increment.end.position[0] = reach;
      increment.end.position[1] = 0.5 * reach;
      increment.end.position[2] = 0.25 * reach;
      const FrictionUpdate u = update(definition, increment, {});
      INFO("b = " << b << ", reach " << reach);
      if (b == 1.0) {
        CHECK(u.state.force[0] == Approx(2.0).epsilon(1e-14));
        CHECK(u.state.force[1] == 0.0);
        CHECK(u.state.force[2] == 0.0);
        continue;
      }
      // In steady slip the force is in proportion to its limit.
      const PotentialTangent tangent = potential_tangent(definition, u);
      for (int i = 0; i < 3; ++i) {
        const double force = u.state.force[static_cast<std::size_t>(i)];
        CHECK(tangent.to_contact[i] == Approx(0.5 * force).epsilon(1e-13 + 10.0 / reach));
      }
    }
  }
}

TEST_CASE("a shifted potential lets go where its limit falls to what it holds without force") {
  // X = <|f1| + |f2| + 1>: P(0) = 1. Slip comes by that limit before it is on the cap of 5.
  PotentialContribution two;
  two.of = DerivedComponent{norm_term({1}, 1.0), norm_term({2}, 1.0)};
  two.function = ContributionFunction::kMacauley;
  two.shift = -1.0;
  FrictionDefinition definition = sliding({two}, 1.0, 1.0);
  definition.internal_contact_force =
      test::make_function({{8, 0}, {0.5, 0.1}, {8, 0.2}, {8, 10}}, {test::kOverAccumulatedSlip});
  definition.stick.value = 10.0;
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.end.position[0] = 2.0;
  for (const double cap : {5.0, 1000.0}) {
    definition.force_limit = cap;
    const FrictionUpdate u = update(definition, increment, {});
    CHECK(u.state.regime == Regime::kOpen);
    CHECK(u.slip_increment == Approx(0.1 * 7.0 / 7.5).epsilon(1e-9));
  }
}

TEST_CASE("an equilibrium in a dip is found in any unit of length") {
  // F = 100 mu(x) turns down from 50 N at x = 1; the spring's 82.06 - 30 x dips below it for less
  // than a sixteenth of its way.
  Renard law;
  law.c1 = 0.1, law.c2 = 0.2, law.c3 = 0.5, law.c4 = 0.1;
  PotentialContribution second;
  second.of = DerivedComponent{norm_term({2}, 1.0)};
  for (const double unit : {1.0, 1e6, 1e-6}) {
    law.c5 = unit, law.c6 = 2.0 * unit;
    FrictionDefinition definition = sliding({PotentialContribution{}, second}, 3.0, 100.0);
    definition.law = law;
    definition.stick.value = 30.0 / unit;
    ConnectorIncrement increment;
    increment.duration = 1.0;
    increment.end.position[0] = 82.06 / 30.0 * unit;
    const FrictionUpdate u = update(definition, increment, {});
    CHECK(u.converged);
    const double y = u.slip_increment / unit - 1.0;
    CHECK(y > 0.0);
    CHECK(y < 0.1464);
    CHECK(50.0 - 40.0 * y * y * (3.0 - 2.0 * y) == Approx(82.06 - 30.0 * (1.0 + y)).epsilon(1e-12));
  }
}

}  // namespace
