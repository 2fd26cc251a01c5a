// SPDX-License-Identifier: Apache-2.0
// Slip that comes to rest shortly before a place where wear has taken all of the limit.
#include <catch2/catch.hpp>
#include <cmath>

#include "law/definition/potential.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/law_tables.hpp"

namespace slipbench::law {
namespace {

using test::kOverAccumulatedSlip;
using test::make_function;

TEST_CASE("slip ends on the limit before the knot where wear has taken it, by either path") {
  // 1000 N/mm; the limit falls from 1 N to 0 over 0.1 mm, and grows again behind.
  FrictionDefinition definition;
  definition.slip = slip_space({1, 2});
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force =
      make_function({{1, 0}, {0, 0.1}, {1, 0.2}}, {kOverAccumulatedSlip});
  definition.law = ConstantCoefficient{1.0};
  definition.stick = {StickStiffness::Mode::kStiffness, 1000.0};
  Potential potential;
  potential.parts = potential.leaves = 2;
  for (std::size_t k = 0; k < 2; ++k) {
    potential.leaf[k].part = static_cast<int>(k);
    potential.leaf[k].direction[k] = 1.0;
  }
  for (const double way : {0.05, 0.09, 0.096, 0.098, 0.099, 0.0999}) {
    // T - 1000 x = 1 - 10 x, along the diagonal.
    const double slip = (1000.0 * way - 1.0) / 990.0;
    for (const SlipCriterion& criterion :
         {SlipCriterion{EuclideanPotential{}}, SlipCriterion{potential}}) {
      INFO(way << ", criterion " << criterion.index());
      definition.criterion = criterion;
      ConnectorIncrement increment;
      increment.duration = 1.0;
      increment.end.position[0] = increment.end.position[1] = way / std::sqrt(2.0);
      const FrictionUpdate u = update(definition, increment, {});
      CHECK(u.state.regime == Regime::kSlip);
      CHECK(u.slip_increment == Approx(slip).epsilon(1e-12));
      CHECK(u.limit == Approx(1.0 - 10.0 * slip).epsilon(1e-9));
      CHECK(u.state.force[0] == Approx(u.limit / std::sqrt(2.0)).epsilon(1e-9));
    }
  }
}

}  // namespace
}  // namespace slipbench::law
