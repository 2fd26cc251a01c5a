// SPDX-License-Identifier: Apache-2.0
// Slip that comes to rest shortly before a place where nothing is left of the limit.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "law/definition/potential.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/law_tables.hpp"

namespace slipbench::law {
namespace {

using test::make_function;

/// The norm of two components, and the same as a potential of two parts.
std::array<SlipCriterion, 2> norms() {
  Potential potential;
  potential.parts = potential.leaves = 2;
  for (std::size_t k = 0; k < 2; ++k) {
    potential.leaf[k].part = static_cast<int>(k);
    potential.leaf[k].direction[k] = 1.0;
  }
  return {EuclideanPotential{}, potential};
}

/// 1000 N/mm over two components.
FrictionDefinition sheet() {
  FrictionDefinition definition;
  definition.slip = slip_space({1, 2});
  definition.contact_force = NoContactForce{};
  definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
  return definition;
}

/// Checks the update along the diagonal by `way`, where F_lim = `first` - `fall` x after the slip
/// x: k (way - x) = first - fall x, k the stiffness.
void check_diagonal(FrictionDefinition definition, double way, double first, double fall) {
  const double k = definition.stick.value;
  const double slip = (k * way - first) / (k - fall);
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.end.position[0] = increment.end.position[1] = way / std::sqrt(2.0);
  for (const SlipCriterion& criterion : norms()) {
    INFO(way << ", criterion " << criterion.index());
    definition.criterion = criterion;
    const FrictionUpdate u = update(definition, increment, {});
    CHECK(u.state.regime == Regime::kSlip);
    CHECK(u.slip_increment == Approx(slip).epsilon(1e-12));
    // 1 - x fall/first, of which little is left.
    CHECK(u.limit == Approx(first - fall * slip).epsilon(1e-8));
    CHECK(u.state.force[0] == Approx(u.limit / std::sqrt(2.0)).epsilon(1e-8));
  }
}

TEST_CASE("slip ends on the limit before the knot where wear has taken it, by either path") {
  // In mm, in km, and in pm.
  for (const double unit : {1.0, 1e-6, 1e9}) {
    FrictionDefinition definition = sheet();
    definition.stick.value /= unit;
    definition.law = ConstantCoefficient{1.0};
    definition.internal_contact_force =
        make_function({{1, 0}, {0, 0.1 * unit}, {1, 0.2 * unit}}, {test::kOverAccumulatedSlip});
    for (const double way : {0.05, 0.09, 0.096, 0.098, 0.099, 0.0999}) {
      check_diagonal(definition, way * unit, 1.0, 10.0 / unit);
    }
  }
}

TEST_CASE("slip ends on the limit before the rate at which a coefficient falls to 0") {
  FrictionDefinition definition = sheet();
  definition.internal_contact_force = 100.0;
  definition.slip_rate = SlipRateMeasure::kSlip;
  // Prolonged, it is 0 at 100 mm/s, where the table has no knot.
  definition.law = TabularCoefficient{
      make_function({{0.4, 0}, {0.2, 50}}, {test::kOverSlipRate}, 1, Extrapolation::kLinear)};
  for (const double way : {60.0, 90.0, 96.0, 98.0, 99.0, 99.9}) {
    check_diagonal(definition, way, 40.0, 0.4);
  }
}

}  // namespace
}  // namespace slipbench::law
