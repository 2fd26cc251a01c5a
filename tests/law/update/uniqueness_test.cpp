// SPDX-License-Identifier: Apache-2.0
// The bounds that tell beforehand whether a constant stick stiffness has one answer.
#include "law/update/uniqueness.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "law/friction/law_list.hpp"

namespace slipbench::law {
namespace {

FrictionDefinition wearing() {
  Table table;
  TableError error;
  REQUIRE(Table::build(std::vector<std::vector<double>>{{100, 0}, {50, 1}}, 1, 1,
                       Extrapolation::kConstant, &table, &error));
  FrictionDefinition definition;
  definition.law = ConstantCoefficient{0.2};
  definition.internal_contact_force =
      TableFunction(table, {{IndependentKind::kAccumulatedSlip, 0}});
  definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
  return definition;
}

TEST_CASE("the snap-back ratio is beta = mu c / k of linear wear") {
  const SnapBack snap = snap_back(wearing());
  CHECK(snap.growth == 0.2);
  CHECK(snap.fall == 50.0);
  CHECK(snap.ratio == Approx(0.01).epsilon(1e-15));  // reference case W1
  CHECK(snap.slip.begin == 0.0);
  CHECK(snap.slip.end == 1.0);
  CHECK_FALSE(snap.contact);
}

TEST_CASE(
    "a change of law and stiffness changes the snap-back ratio as if it had been there before") {
  const std::vector<std::vector<double>> rows{{0.1, 1}, {0.3, 2}, {0.2, 4}};
  TabularCoefficient over_force;
  TableError error;
  Table table;
  REQUIRE(Table::build(rows, 1, 1, Extrapolation::kConstant, &table, &error));
  over_force.table = TableFunction(table, {{IndependentKind::kContactForce, 0}});
  Potential potential;
  potential.parts = 2;
  potential.combine = PotentialOperator::kMax;
  // Without a bound over all forces there is no ratio, before the change or after it.
  GeneralizedViscous unbounded;
  unbounded.c1 = 1.0;
  for (const FrictionLaw& first : {FrictionLaw(ConstantCoefficient{0.2}), FrictionLaw(unbounded)}) {
    for (const FrictionLaw& second :
         {FrictionLaw(over_force), FrictionLaw(ConstantCoefficient{7.0}), FrictionLaw(unbounded)}) {
      FrictionDefinition definition = wearing();
      definition.criterion = potential;
      definition.law = first;
      const SnapBack changed = changed_snap_back(snap_back(definition), second, 30.0);
      definition.law = second;
      definition.stick.value = 30.0;
      const SnapBack wanted = snap_back(definition);
      CHECK(changed.growth == wanted.growth);
      CHECK(changed.fall == wanted.fall);
      CHECK(changed.along == wanted.along);
      CHECK(changed.ratio == wanted.ratio);
      CHECK(changed.slip.end == wanted.slip.end);
      REQUIRE(changed.contact.has_value() == wanted.contact.has_value());
      if (wanted.contact) CHECK(changed.contact->begin == wanted.contact->begin);
    }
  }
}

TEST_CASE("a potential whose terms slip together has a softer spring along its normal") {
  // P = (y1^b + y2^b)^(1/b) at y1 = y2: |dP/dy|^2 = 2^(2/b - 1); of the maximum the mean normal.
  FrictionDefinition definition = wearing();
  Potential potential;
  potential.parts = 2;
  potential.exponent = 4.0;
  definition.criterion = potential;
  CHECK(snap_back(definition).ratio == Approx(0.01 * std::sqrt(2.0)).epsilon(1e-14));
  potential.exponent = 1.5;
  definition.criterion = potential;
  CHECK(snap_back(definition).ratio == Approx(0.01).epsilon(1e-14));
  potential.combine = PotentialOperator::kMax;
  definition.criterion = potential;
  CHECK(snap_back(definition).ratio == Approx(0.02).epsilon(1e-14));
}

TEST_CASE("without wear, or with a stiffness that follows the limit, nothing snaps back") {
  FrictionDefinition definition = wearing();
  definition.stick = {StickStiffness::Mode::kElasticSlip, 0.02};
  CHECK(snap_back(definition).ratio == 0.0);
  CHECK(stick_stiffness(definition, 20.0) == 1000.0);
  definition = wearing();
  definition.internal_contact_force = 100.0;
  CHECK(snap_back(definition).ratio == 0.0);
  CHECK(stick_stiffness(definition, 20.0) == 1000.0);
}

/// The data of reference case K3: N 100, k 1000, 0.3 to 0.2 with d = 0.05.
FrictionDefinition falling() {
  FrictionDefinition definition;
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
  return definition;
}

TEST_CASE("several roots coexist below N (mu_s - mu_k) d / k, at whatever rate") {
  for (const double rate : {0.0, 1.0, 100.0}) {
    const IncrementThresholds t = increment_thresholds(falling(), Ambient{}, 100.0, rate);
    CHECK(t.unique == Approx(5e-4).epsilon(1e-14));
  }
}

TEST_CASE("backward Euler is smooth in increments above 2 N |mu'(v)| / k") {
  const IncrementThresholds t = increment_thresholds(falling(), Ambient{}, 100.0, 1.0);
  CHECK(t.smooth == Approx(9.51229424500714e-4).epsilon(1e-14));  // reference case K3
  CHECK(t.unique == Approx(5e-4).epsilon(1e-14));
  CHECK(t.normal_force == 100.0);
  CHECK(t.weakening == Approx(0.00475614712250357).epsilon(1e-14));
}

TEST_CASE("half of a change of friction has half of the new law's thresholds") {
  FrictionDefinition definition = falling();
  definition.blend = {0.1, 0.5};
  const IncrementThresholds t = increment_thresholds(definition, Ambient{}, 100.0, 1.0);
  CHECK(t.smooth == Approx(0.5 * 9.51229424500714e-4).epsilon(1e-14));
  CHECK(t.unique == Approx(2.5e-4).epsilon(1e-14));
}

TEST_CASE("a coefficient that falls ever faster is bounded up to the rate of the motion") {
  FrictionDefinition definition = falling();
  GeneralizedViscous law;
  law.fric = 0.5;
  law.c5 = -0.01;
  definition.law = law;
  const IncrementThresholds t = increment_thresholds(definition, Ambient{}, 100.0, 2.0);
  // mu = 0.5 - 0.01 V^2 falls fastest at V = 2, by 0.04.
  CHECK(t.weakening == Approx(0.04).epsilon(1e-14));
  CHECK(t.unique == Approx(100.0 * 0.04 / 1000.0).epsilon(1e-14));
}

TEST_CASE("the increment does not matter where the limit does not follow the slip") {
  const auto none = [](const FrictionDefinition& definition, double normal_force = 100.0) {
    const IncrementThresholds t = increment_thresholds(definition, Ambient{}, normal_force, 1.0);
    return t.smooth == 0.0 && t.unique == 0.0;
  };
  CHECK_FALSE(none(falling()));
  CHECK(none(falling(), 0.0));
  FrictionDefinition definition = falling();
  definition.stick = {StickStiffness::Mode::kElasticSlip, 0.02};
  CHECK(none(definition));
  definition = falling();
  definition.slip_rate = SlipRateMeasure::kRelativeMotion;
  CHECK(none(definition));
  definition = falling();
  definition.law = ConstantCoefficient{0.3};
  CHECK(none(definition));
  definition = falling();
  definition.force_limit = 15.0;  // below 100 mu everywhere
  CHECK(none(definition));
}

TEST_CASE("a belt's thresholds are those of its larger limit") {
  FrictionDefinition definition = falling();
  definition.criterion = Capstan{1.5};
  const IncrementThresholds t = increment_thresholds(definition, Ambient{}, 100.0, 1.0);
  // d(T (exp(mu alpha) - 1))/dmu = T alpha exp(mu alpha), mu(1) = 0.295122942450071.
  CHECK(t.smooth == Approx(9.51229424500714e-4 * 1.5 * std::exp(1.5 * 0.295122942450071)));
}

}  // namespace
}  // namespace slipbench::law
