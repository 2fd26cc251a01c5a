// SPDX-License-Identifier: Apache-2.0
#include "law/exact/smooth_piece.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
using std::numbers::pi;

TEST_CASE("a dip of the limit between any two looks at it is seen, in a table or under the cap") {
  const auto after_warming = [](const FrictionDefinition& definition, Waypoint point, double motion,
                                double temperature) {
    ExactRun run(definition, point);
    point.position[0] = motion;
    run.go(point);
    point.temperature = temperature;
    for (double& field : point.fields) field = 1.0;
    run.go(point);
    return run.friction(1);
  };
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force =
      make_function({{100, 0}, {100, 59}, {20, 60}, {100, 61}, {100, 100}}, {kOverTemperature});
  CHECK(after_warming(definition, at(0.0), 0.05, 100.0) == Approx(4.0).epsilon(1e-10));

  // mu = 0.19 + 0.7 (t - 0.625)^2 along the diagonal of temperature and a field.
  const double at_begin = 0.19 + 0.7 * 0.625 * 0.625;
  const double aside = at_begin - 0.5 * 1.4 * 0.625;
  definition.law = TabularCoefficient{
      make_function({{at_begin, 0, 0}, {aside, 1, 0}, {aside, 0, 1}, {at_begin - 0.175, 1, 1}},
                    {kOverTemperature, over_field(0)})};
  Waypoint begin = at(0.0);
  begin.fields = {0.0};
  begin.force[0] = 100.0;
  definition.internal_contact_force = 0.0;
  definition.contact_force = ComponentContactForce{0};
  definition.force_limit = 20.0;
  CHECK(after_warming(definition, begin, 1.0, 1.0) == Approx(19.0).epsilon(1e-12));

  // Of a belt on either side of its band.
  definition.criterion = Capstan{pi};
  definition.force_limit = 85.0;
  const double forward = 100.0 * std::expm1(0.19 * pi);
  CHECK(after_warming(definition, begin, 1.0, 1.0) == Approx(forward).epsilon(1e-12));
  definition.force_limit = 46.0;
  const double backward = 100.0 * std::expm1(-0.19 * pi);
  CHECK(after_warming(definition, begin, -1.0, 1.0) == Approx(backward).epsilon(1e-12));
}

TEST_CASE("a dip is found in any part of a way, and none where there is none") {
  for (const double place : {0.063, 0.1, 0.5, 0.93}) {
    const auto f = [&](double x) { return std::abs(x - place) - 1e-3; };
    const double found = first_dip(f, 0.0, 1.0, 16, 0.0);
    CHECK(found == Approx(place).margin(1e-3));
    CHECK(f(found) < 0.0);
    CHECK(first_dip(f, 0.0, 1.0, 16, -1e-2) == 1.0);
  }
}

TEST_CASE("what the cap cuts off of a slip between any two looks at it is seen") {
  // mu = 0.2 + 0.35 (half^2 - (t - 0.625)^2) along the diagonal of temperature and a field, held at
  // 0.2: the cap is met for 2 half of the time.
  Potential line;
  line.parts = line.leaves = 1;
  line.leaf[0].direction[0] = 1.0;
  for (const SlipCriterion& criterion :
       {SlipCriterion{EuclideanPotential{}}, SlipCriterion{line}}) {
    for (const double half : {0.08, 0.005}) {
      CAPTURE(criterion.index(), half);
      const auto mu = [&](double t) {
        return 0.2 + 0.35 * (half * half - (t - 0.625) * (t - 0.625));
      };
      const double aside = mu(0.0) + 0.35 * 0.625;
      FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0));
      definition.criterion = criterion;
      definition.law = TabularCoefficient{
          make_function({{mu(0.0), 0, 0}, {aside, 1, 0}, {aside, 0, 1}, {mu(1.0), 1, 1}},
                        {kOverTemperature, over_field(0)})};
      definition.force_limit = 20.0;
      Waypoint point = at(0.0);
      point.fields = {0.0};
      ExactRun run(definition, point);
      point.position[0] = 1.0;
      run.go(point);
      point.position[0] = 2.0;
      point.temperature = point.fields[0] = 1.0;
      run.go(point);
      const double uncapped =
          100.0 * mu(0.625) - 35.0 * (std::pow(0.375, 3) + std::pow(0.625, 3)) / 3.0;
      const double above = 35.0 * std::pow(half, 3) * 4.0 / 3.0;
      CHECK(run.last.work == Approx(uncapped - above).epsilon(1e-11));
    }
  }
}

/// Returns a slider that has gone to a point under F_C = 100 + <100 w>, w over the temperature, and
/// puts the second force into the point.
ExactRun weighted_and_slipping(const std::vector<std::vector<double>>& weights, Waypoint* point) {
  DerivedTerm term = norm_term({3, 2}, 1.0);
  term.combine = TermOperator::kMacauleySum;
  term.weight_table = make_function(weights, {kOverTemperature}, 2);
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = DerivedComponent{term};
  point->force[1] = 100.0;
  Waypoint begin = *point;
  begin.position[0] = 0.0;
  ExactRun run(definition, begin);
  run.go(*point);
  return run;
}

TEST_CASE("a weight that passes 0 is a corner of the contact force, whichever of its term it is") {
  // F_C = 100 + <100 w>, w from -1 to 1: the limit is 20, from the middle on 20 to 40.
  Waypoint point = at(0.05, 100.0);
  ExactRun run = weighted_and_slipping({{1, -1, 0}, {1, 1, 100}}, &point);
  run.dissipation = 0.0;
  point.position[0] = 0.15;
  point.temperature = 100.0;
  run.go(point);
  CHECK(run.friction(1) == Approx(40.0).epsilon(1e-12));
  // Slip of 0.05 under 20 N, then of 0.03 under 20 to 40 N.
  CHECK(run.dissipation == Approx(20.0 * 0.05 + 30.0 * 0.03).epsilon(1e-11));
}

TEST_CASE("a weight that moves in a part of a segment only has its corners there") {
  // F_C = 100 + <100 w>, w = -1 but for a peak of 2 between the temperatures 60 and 90: the limit
  // is 20, and 4 more on average.
  Waypoint point = at(0.05, 100.0);
  ExactRun run = weighted_and_slipping(
      {{1, -1, 0}, {1, -1, 60}, {1, 2, 75}, {1, -1, 90}, {1, -1, 100}}, &point);
  point.position[0] = 1.15;
  point.temperature = 100.0;
  run.go(point);
  CHECK(run.last.work == Approx(24.0 * 1.1).epsilon(1e-13));
}

}  // namespace
