// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "law/definition/potential_terms.hpp"
#include "law/update/potential_return.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/random_definition.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
using Rule = PotentialViolation::Rule;
using Function = ContributionFunction;

DerivedTerm term(TermOperator combine, const std::vector<std::pair<int, double>>& entries,
                 double sign = 1.0) {
  DerivedTerm result;
  result.combine = combine;
  result.sign = sign;
  for (const auto& [number, weight] : entries) {
    const auto j = static_cast<std::size_t>(result.count++);
    result.component[j] = number - 1;
    result.weight[j] = weight;
  }
  return result;
}

PotentialContribution of_component(int number, double scale = 1.0) {
  PotentialContribution contribution;
  contribution.of = number - 1;
  contribution.scale = scale;
  return contribution;
}
PotentialContribution of_derived(DerivedComponent derived, double scale = 1.0) {
  PotentialContribution contribution;
  contribution.of = std::move(derived);
  contribution.scale = scale;
  return contribution;
}

BuiltPotential sum(const std::vector<PotentialContribution>& contributions, double exponent) {
  return build_potential(contributions, PotentialOperator::kSum, exponent);
}
BuiltPotential largest(const std::vector<PotentialContribution>& contributions) {
  return build_potential(contributions, PotentialOperator::kMax, 2.0);
}

/// P of forces given by component number.
double value_of(const BuiltPotential& built, const std::vector<std::pair<int, double>>& forces) {
  SlipVector y{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(built.slip.dimension); ++k) {
    for (const auto& [number, force] : forces) {
      if (built.slip.component[k] == number - 1) y[k] = force / built.slip.scale[k];
    }
  }
  return value(std::get<Potential>(built.criterion), y);
}

DerivedComponent tension() {
  return {term(TermOperator::kMacauleySum, {{3, 1.0}}),
          term(TermOperator::kNorm, {{4, 0.5}, {5, 0.5}})};
}
DerivedComponent shear() {
  return {term(TermOperator::kNorm, {{1, 1.0}, {2, 1.0}}), term(TermOperator::kNorm, {{6, 0.4}})};
}

TEST_CASE("a spot weld's two derived components meet the number of the example") {
  const BuiltPotential built = sum({of_derived(tension(), 0.02), of_derived(shear(), 0.05)}, 1.5);
  REQUIRE(built.violations.empty());
  CHECK(built.slip.dimension == 6);
  // 3.56561 of pull 3 and bending 0.56561, 2.31606 of shear 1.2 and twist 1.11606.
  const double p = value_of(built, {{3, 3.0},
                                    {4, 0.56561 / 0.5 * 0.6},
                                    {5, 0.56561 / 0.5 * 0.8},
                                    {1, -0.72},
                                    {2, 0.96},
                                    {6, -1.11606 / 0.4}});
  // The example prints six digits.
  CHECK(p == Approx(193.693).epsilon(3e-6));
  // A push does not count.
  CHECK(value_of(built, {{3, -100.0}}) == 0.0);
}

TEST_CASE("a unit along each entry of the slip space has the magnitude one") {
  Dice dice(3);
  for (int run = 0; run < 200; ++run) {
    DefinitionDescription d;
    add_potential(&dice, &d);
    Potential potential = *d.potential;
    potential.offset = {};
    for (PotentialLeaf& leaf : potential.leaf) leaf.center = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d.slip.dimension); ++k) {
      SlipVector up{}, down{};
      up[k] = 1.0;
      down[k] = -1.0;
      CHECK(std::max(value(potential, up), value(potential, down)) == Approx(1.0).epsilon(1e-14));
    }
  }
}

TEST_CASE("the gradient is that of differences, and P = y . dP/dy without shifts") {
  Dice dice(11);
  int compared = 0;
  for (int run = 0; run < 500; ++run) {
    DefinitionDescription d;
    add_potential(&dice, &d);
    const Potential& potential = *d.potential;
    SlipVector y{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(d.slip.dimension); ++k) {
      y[k] = dice.between(-10.0, 10.0);
    }
    const double p = value(potential, y);
    const SlipVector m = gradient(potential, y);
    if (potential.homogeneous) CHECK(dot(y, m) == Approx(p).epsilon(1e-12).margin(1e-12));
    for (std::size_t k = 0; k < static_cast<std::size_t>(d.slip.dimension); ++k) {
      SlipVector ahead = y, behind = y;
      ahead[k] += 1e-6;
      behind[k] -= 1e-6;
      const double right = (value(potential, ahead) - p) / 1e-6;
      const double left = (p - value(potential, behind)) / 1e-6;
      if (std::abs(right - left) > 1e-4) continue;  // a corner, or strongly curved
      ++compared;
      CHECK(m[k] == Approx(0.5 * (right + left)).margin(1e-4));
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("large exponents neither overflow nor vanish") {
  const BuiltPotential built = sum({of_component(2), of_component(3)}, 500.0);
  CHECK(value_of(built, {{2, 1e200}, {3, 1e190}}) == Approx(1e200).epsilon(1e-12));
  CHECK(value_of(built, {{2, 1e-200}, {3, 1e-200}}) ==
        Approx(1e-200 * std::pow(2.0, 1.0 / 500.0)).epsilon(1e-12));
}

TEST_CASE("a norm whose squares underflow keeps its length and direction") {
  PotentialLeaf norm;
  norm.kind = PotentialLeaf::Kind::kNorm;
  norm.direction = {1.0, 0.0, 1.0};
  for (const double unit : {1.0, 1e-150, 1e-200, 1e-300}) {
    INFO("unit " << unit);
    CHECK(length(norm, {3.0 * unit, 7.0, -4.0 * unit}) ==
          Approx(5.0 * unit).epsilon(1e-14).margin(0));
  }
  CHECK(length(norm, {0.0, 7.0, 0.0}) == 0.0);
}

TEST_CASE("potentials that are the norm of their slip space take the Euclidean path") {
  const auto euclidean = [](const BuiltPotential& built) {
    REQUIRE(built.violations.empty());
    return std::holds_alternative<EuclideanPotential>(built.criterion);
  };
  CHECK(euclidean(sum({of_component(1), of_component(4, 0.24)}, 2.0)));
  CHECK(euclidean(sum({of_component(1)}, 3.0)));
  CHECK(euclidean(largest({of_component(1)})));
  CHECK(euclidean(sum({of_derived({term(TermOperator::kNorm, {{2, 1.0}, {3, 2.0}})})}, 1.0)));
  CHECK_FALSE(euclidean(sum({of_component(1), of_component(4)}, 2.1)));
  CHECK_FALSE(euclidean(largest({of_component(1), of_component(4)})));
  CHECK_FALSE(euclidean(sum({of_derived(shear())}, 2.0)));
  PotentialContribution shifted = of_component(1);
  shifted.shift = 1.0;
  CHECK_FALSE(euclidean(sum({shifted}, 2.0)));
  PotentialContribution half = of_component(1);
  half.function = Function::kMacauley;
  CHECK_FALSE(euclidean(sum({half}, 2.0)));
}

TEST_CASE("each rule on the terms is told apart") {
  const auto rules = [](const BuiltPotential& built) {
    std::vector<std::pair<Rule, int>> found;
    for (const auto& v : built.violations) found.emplace_back(v.rule, v.contribution);
    return found;
  };
  using Found = std::vector<std::pair<Rule, int>>;
  PotentialContribution c = of_component(4);
  c.sign = -1.0;
  CHECK(rules(sum({of_component(1), c}, 2.0)) == Found{{Rule::kSign, 1}});
  c = of_component(4);
  c.exponent = 3.0;
  CHECK(rules(sum({of_component(1), c}, 2.0)) == Found{{Rule::kExponent, 1}});
  CHECK(rules(sum({c}, 3.0)).empty());
  CHECK(rules(largest({of_component(1), c})).empty());
  c = of_component(4);
  c.function = Function::kIdentity;
  CHECK(rules(sum({c}, 1.0)) == Found{{Rule::kOneSided, 0}});
  const DerivedTerm norm = term(TermOperator::kNorm, {{1, 1.0}, {2, 1.0}});
  c = of_derived({norm});
  c.function = Function::kIdentity;
  CHECK(rules(sum({c}, 1.0)).empty());
  CHECK(rules(sum({c}, 2.0)) == Found{{Rule::kIdentityExponent, 0}});
  c.shift = -1.0;
  CHECK(rules(sum({c}, 1.0)) == Found{{Rule::kIdentityShift, 0}});
  c.function = Function::kAbs;
  CHECK(rules(sum({c}, 2.0)).empty());
  c.shift = 1.0;
  CHECK(rules(sum({c}, 2.0)) == Found{{Rule::kConcave, 0}});
  c.function = Function::kMacauley;
  CHECK(rules(sum({c}, 2.0)).empty());
  CHECK(rules(sum({of_derived({norm, term(TermOperator::kSum, {{3, 1.0}})})}, 2.0)) ==
        Found{{Rule::kMixedTerms, 0}});
  CHECK(rules(sum({of_derived({norm, term(TermOperator::kMacauleySum, {{3, 1.0}}, -1.0)})}, 2.0)) ==
        Found{{Rule::kTermSign, 0}});
  CHECK(rules(sum({of_derived({term(TermOperator::kSum, {{1, 1.0}, {3, 0.0}})})}, 2.0)) ==
        Found{{Rule::kNoWeight, 0}});
  CHECK(rules(sum({of_component(2), of_derived({norm})}, 2.0)) == Found{{Rule::kTwice, 1}});
  CHECK(sum({of_component(2), of_derived({norm})}, 2.0).violations[0].component == 1);
}

/// A slider of limit 20 in the components of a potential.
FrictionRun run_of(const BuiltPotential& built, StickStiffness stick) {
  REQUIRE(built.violations.empty());
  FrictionDefinition definition = slider(0.2, 100.0, stick);
  definition.slip = built.slip;
  definition.criterion = built.criterion;
  return FrictionRun(definition);
}

TEST_CASE("with the exponent 1 a force below the threshold of the others is used up") {
  FrictionRun run = run_of(sum({of_component(2), of_component(3)}, 1.0), fixed_stiffness(100.0));
  run.position[1] = 0.5;
  run.position[2] = 0.1;
  const FrictionUpdate& u = run.step();
  // y_tr = (50, 10): both back by 10, then the first alone by 20.
  CHECK(run.friction(2) == Approx(20.0).epsilon(1e-15));
  CHECK(run.friction(3) == 0.0);
  CHECK(u.slip_increment == Approx(0.3).epsilon(1e-14));
  CHECK(u.dissipation == Approx(6.0).epsilon(1e-14));
}

TEST_CASE("with operator max the directions are clipped each for itself, their slips added") {
  FrictionRun run = run_of(largest({of_component(2), of_component(3)}), fixed_stiffness(100.0));
  run.position[1] = 0.5;
  run.position[2] = -0.3;
  const FrictionUpdate& u = run.step();
  CHECK(run.friction(2) == Approx(20.0).epsilon(1e-15));
  CHECK(run.friction(3) == Approx(-20.0).epsilon(1e-15));
  CHECK(u.slip_increment == Approx(0.3 + 0.1).epsilon(1e-14));
  CHECK(u.dissipation == Approx(20.0 * 0.4).epsilon(1e-14));
}

TEST_CASE("forces of which the sum is limited come back together") {
  const BuiltPotential built =
      sum({of_derived({term(TermOperator::kSum, {{2, 1.0}, {3, 1.0}})})}, 2.0);
  FrictionRun run = run_of(built, fixed_stiffness(100.0));
  run.position[1] = 0.3;
  run.position[2] = 0.1;
  const FrictionUpdate& u = run.step();
  // y_tr = (30, 10): each back by half of what the sum is beyond 20.
  CHECK(u.converged);
  CHECK(run.friction(2) == Approx(20.0).epsilon(1e-14));
  CHECK(run.friction(3) == Approx(0.0).margin(1e-14));
  CHECK(u.slip_increment == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("a Macauley contribution holds without limit against the other direction") {
  PotentialContribution half = of_component(1);
  half.function = Function::kMacauley;
  FrictionRun run = run_of(sum({half}, 2.0), allowable_slip(0.01));
  CHECK(run.move_to(1, 1.0).state.regime == Regime::kSlip);
  CHECK(run.friction(1) == Approx(20.0).epsilon(1e-15));
  CHECK(run.move_to(1, -1.0).state.regime == Regime::kStick);
  CHECK(run.friction(1) == Approx(20.0 - 2.0 * 2000.0).epsilon(1e-14));
}

TEST_CASE("a shift moves the band, dissipates its work, and opens where 0 is outside") {
  PotentialContribution shifted = of_component(1);
  shifted.shift = 5.0;
  for (const StickStiffness stick : {fixed_stiffness(100.0), allowable_slip(0.2)}) {
    FrictionRun run = run_of(sum({shifted}, 2.0), stick);
    run.move_to(1, 1.0);
    CHECK(run.friction(1) == Approx(25.0).epsilon(1e-14));
    CHECK(run.last.dissipation == Approx(25.0 * 0.75).epsilon(1e-14));
    run.move_to(1, -1.0);
    CHECK(run.friction(1) == Approx(-15.0).epsilon(1e-14));
    CHECK(run.last.dissipation == Approx(15.0 * (2.0 - 0.4)).epsilon(1e-14));
    // A limit of 4 admits 1 to 9: no force at all is outside.
    run.definition.internal_contact_force = 20.0;
    CHECK(run.step().state.regime == Regime::kOpen);
    CHECK(run.friction(1) == 0.0);
    CHECK(run.last.dissipation == 0.0);
  }
}

TEST_CASE("the equivalent elastic slip is measured without the shifts of the forces") {
  PotentialContribution dead_zone = of_derived({term(TermOperator::kNorm, {{1, 1.0}, {2, 1.0}})});
  dead_zone.function = Function::kMacauley;
  dead_zone.shift = 5.0;
  PotentialContribution moved = of_component(3);
  moved.shift = -2.0;
  const FrictionRun run = run_of(sum({dead_zone, moved}, 2.0), fixed_stiffness(100.0));
  FrictionState state;
  state.elastic_slip = {0.3, -0.4, 1.2};
  CHECK(equivalent_elastic_slip(run.definition, state) == Approx(1.3).epsilon(1e-14));
}

// With b = 2 the contributions X_i come back in proportion to what they are of the trial force,
// up to their shifts. The difference of trial force and pull alone had an error of 1e9 roundings.
TEST_CASE("after 1e9 elastic slips a force is known as well as after one") {
  const StickStiffness stick = fixed_stiffness(2e10);
  const auto norm_of = [](int number) { return term(TermOperator::kNorm, {{number, 1.0}}); };
  std::vector<PotentialContribution> shifted{of_derived({norm_of(2)}), of_derived({norm_of(3)})};
  for (PotentialContribution& one : shifted) {
    one.function = Function::kMacauley;
    one.shift = 5.0;
  }
  FrictionRun run = run_of(sum(shifted, 2.0), stick);
  run.position[1] = 0.7;
  run.position[2] = 0.3;
  CHECK(run.step().state.regime == Regime::kSlip);
  const double t2 = 0.7 * 2e10 - 5.0, t3 = 0.3 * 2e10 - 5.0;
  CHECK(run.friction(2) == Approx(5.0 + 20.0 * t2 / std::hypot(t2, t3)).epsilon(1e-14));
  CHECK(run.friction(3) == Approx(5.0 + 20.0 * t3 / std::hypot(t2, t3)).epsilon(1e-14));

  // The second of two terms of one contribution is used up: nothing but the first holds it.
  run = run_of(sum({of_derived({norm_of(1), norm_of(2)}), of_component(3)}, 2.0), stick);
  run.position[0] = 0.7;
  run.position[1] = 0.1;
  run.position[2] = 0.3;
  run.step();
  CHECK(run.friction(1) == Approx(20.0 * 0.7 / std::hypot(0.7, 0.3)).epsilon(1e-14));
  CHECK(run.friction(2) == 0.0);
  CHECK(run.friction(3) == Approx(20.0 * 0.3 / std::hypot(0.7, 0.3)).epsilon(1e-14));
}

TEST_CASE("both stick modes agree under a constant limit for every exponent") {
  for (const double b : {1.0, 1.2, 1.5, 2.0, 4.0, 30.0}) {
    const BuiltPotential built = sum({of_component(2), of_component(3, 0.5), of_component(4)}, b);
    FrictionRun stiff = run_of(built, fixed_stiffness(20.0 / 0.01));
    FrictionRun slip = run_of(built, allowable_slip(0.01));
    Dice dice(17);
    for (int i = 0; i < 50; ++i) {
      for (const int c : {1, 2, 3}) {
        stiff.position[c] += dice.between(-0.02, 0.02);
        slip.position[c] = stiff.position[c];
      }
      stiff.step();
      slip.step();
      REQUIRE(stiff.last.converged);
      REQUIRE(slip.last.converged);
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(stiff.state.force[k] == Approx(slip.state.force[k]).margin(1e-10));
      }
      CHECK(stiff.state.accumulated_slip == Approx(slip.state.accumulated_slip).epsilon(1e-12));
    }
  }
}

TEST_CASE("a number that is none is reported as no solution") {
  FrictionRun run = run_of(sum({of_component(2), of_component(3)}, 3.0), fixed_stiffness(100.0));
  run.position[1] = std::numeric_limits<double>::quiet_NaN();
  const FrictionUpdate& u = run.step();
  CHECK((!u.converged || !std::isfinite(u.phi) || !std::isfinite(u.work)));
}

TEST_CASE("a potential has no room for more contributions than components, nor for empty ones") {
  std::vector<PotentialContribution> many(9);
  for (std::size_t i = 0; i < many.size(); ++i) many[i].of = static_cast<int>(i % 6);
  CHECK_FALSE(build_potential(many, PotentialOperator::kSum, 3.0).violations.empty());
  std::vector<PotentialContribution> empty(9);
  for (PotentialContribution& contribution : empty) contribution.of = DerivedComponent{};
  const auto violations = build_potential(empty, PotentialOperator::kMax, 2.0).violations;
  REQUIRE(violations.size() == 9);
  CHECK(violations[0].rule == PotentialViolation::Rule::kNoWeight);
}

}  // namespace
