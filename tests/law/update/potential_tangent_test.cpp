// SPDX-License-Identifier: Apache-2.0
// Tangents of potentials in closed form, where differences see nothing: at corners, and at forces
// that are small numbers.
#include <catch2/catch.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "law/definition/potential_terms.hpp"
#include "law/update/connector_tangent.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

PotentialContribution of(std::variant<int, DerivedComponent> what) {
  PotentialContribution contribution;
  contribution.of = std::move(what);
  return contribution;
}

/// A slider of the coefficient 1.
FrictionDefinition sliding(const std::vector<PotentialContribution>& terms,
                           PotentialOperator combine, double exponent, InternalContactForce limit,
                           double stiffness) {
  const BuiltPotential built = build_potential(terms, combine, exponent);
  REQUIRE(built.violations.empty());
  FrictionDefinition definition = slider(1.0, 0.0, fixed_stiffness(stiffness));
  definition.slip = built.slip;
  definition.criterion = built.criterion;
  definition.internal_contact_force = std::move(limit);
  return definition;
}

/// df/du after an increment from rest; the entries of `motion` are those of component 1 on.
ConnectorTangent tangent_after(const FrictionDefinition& definition,
                               const std::vector<double>& motion) {
  FrictionRun run(definition);
  for (std::size_t i = 0; i < motion.size(); ++i) run.position[static_cast<int>(i)] = motion[i];
  const ConnectorIncrement increment = run.increment();
  REQUIRE(run.step().state.regime == Regime::kSlip);
  return connector_tangent(definition, increment, run.last);
}

TEST_CASE("a component without load beside one that slips follows by the exponent alone") {
  const auto slope = [](double exponent) {
    // The third makes it no norm of the slip space at b = 2, either.
    DerivedTerm across = norm_term({3, 4}, 1.0);
    across.combine = TermOperator::kSum;
    const std::vector<PotentialContribution> terms{of(0), of(1), of(DerivedComponent{across})};
    return tangent_after(sliding(terms, PotentialOperator::kSum, exponent, 20.0, 100.0), {0.5})
        .to_motion(1, 1);
  };
  // (y_1^b + y_2^b)^(1/b) = T at small y_2, which comes back by x (y_2/T)^(b-1) from the trial.
  CHECK(slope(1.0) == 0.0);
  CHECK(slope(1.5) == 0.0);
  CHECK(slope(2.0) == Approx(100.0 * 20.0 / 50.0).epsilon(1e-14));
  CHECK(slope(3.0) == 100.0);
}

TEST_CASE("a term without load in a contribution that slips stays without") {
  const DerivedComponent sum{norm_term({1, 2}, 1.0), norm_term({3}, 1.0)};
  const FrictionDefinition definition =
      sliding({of(sum), of(3)}, PotentialOperator::kSum, 2.0, 20.0, 100.0);
  CHECK(tangent_after(definition, {0.0, 0.0, 0.5}).to_motion.topLeftCorner(3, 3).isZero(1e-12));
}

TEST_CASE("directions that are clipped each for itself follow a limit that runs in") {
  // c |f_i| = T = a + b L with L = sum (t_i - T/c)/(c k): with a c and b c^2 the same for all c.
  for (const double c : {1.0, 0.01}) {
    const double a = 1e-4 * c, b = 0.1 * c * c;
    FrictionDefinition definition =
        sliding({of(0), of(1)}, PotentialOperator::kMax, 2.0,
                make_function({{a, 0}, {a + b, 1}}, {kOverAccumulatedSlip}), 1.0);
    for (PotentialLeaf& leaf : std::get<Potential>(definition.criterion).leaf) leaf.factor = c;
    const ConnectorTangent tangent = tangent_after(definition, {3e-4, 2e-4});
    for (const int i : {0, 1}) {
      for (const int j : {0, 1}) {
        CHECK(tangent.to_motion(i, j) == Approx(0.1 / (1.0 + 2.0 * 0.1)).epsilon(1e-10));
      }
    }
  }
}

}  // namespace
