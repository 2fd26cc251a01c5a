// SPDX-License-Identifier: Apache-2.0
// The bounds that tell beforehand whether a constant stick stiffness has one answer.
#include "law/uniqueness.hpp"

#include <catch2/catch.hpp>
#include <vector>

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

TEST_CASE("several roots coexist below N (mu_s - mu_k) d / k") {
  const FrictionLaw law = ExponentialDecay{0.3, 0.2, 0.05};
  CHECK(uniqueness_threshold(law, 100.0, 1000.0) == Approx(5e-4).epsilon(1e-14));  // K3's data
}

TEST_CASE("signed components and sums may turn the contact force, norms may not") {
  CHECK_FALSE(may_be_negative(NoContactForce{}));
  CHECK_FALSE(may_be_negative(DerivedComponent{norm_term({2, 3}, 1.0)}));
  CHECK(may_be_negative(ComponentContactForce{1}));
  DerivedTerm sum = norm_term({2}, 1.0);
  sum.combine = TermOperator::kSum;
  CHECK(may_be_negative(DerivedComponent{sum}));
}

}  // namespace
}  // namespace slipbench::law
