// SPDX-License-Identifier: Apache-2.0
// Work and onset where the limit has fallen below the force at the beginning of the increment.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "law/definition/potential.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
namespace test = slipbench::test;

/// A slider under a constant limit, k = 10.
FrictionDefinition limited(double limit, const SlipSpace& space = slip_space({1})) {
  FrictionDefinition definition;
  definition.slip = space;
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force = limit;
  definition.law = ConstantCoefficient{1.0};
  definition.stick = {StickStiffness::Mode::kStiffness, 10.0};
  return definition;
}

/// An increment of the components 1 and 2 from a force that they hold.
FrictionUpdate moved(const FrictionDefinition& definition, std::array<double, 2> force,
                     std::array<double, 2> motion) {
  FrictionState old;
  ConnectorIncrement increment;
  increment.duration = 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    old.force[i] = force[i];
    old.elastic_slip[i] = force[i] / 10.0;
    increment.end.position.values[i] = motion[i];
  }
  return update(definition, increment, old);
}

FrictionUpdate turned_back(const SlipCriterion& criterion, double motion) {
  FrictionDefinition definition = limited(5.0);
  definition.criterion = criterion;
  return moved(definition, {20.0, 0.0}, {motion, 0.0});
}

TEST_CASE("a force that turns back below a fallen limit is split where it comes out of it") {
  Potential potential;
  potential.parts = potential.leaves = 1;
  potential.leaf[0].direction[0] = 1.0;
  for (const SlipCriterion& criterion :
       {SlipCriterion{EuclideanPotential{}}, SlipCriterion{potential}}) {
    // To the predictor 10: beyond the limit 5 all the way, so it slips from the start.
    const FrictionUpdate beyond = turned_back(criterion, -1.0);
    CHECK(beyond.onset == 0.0);
    CHECK(beyond.work == Approx(0.5 * (20.0 + 5.0) * -1.0).epsilon(1e-14));
    // To the predictor -10: through the inside, out again at -5 after 25 of 30.
    const FrictionUpdate through = turned_back(criterion, -3.0);
    CHECK(through.onset == Approx(25.0 / 30.0).epsilon(1e-14));
    CHECK(through.work == Approx(0.5 * (20.0 - 5.0) * -2.5 + -5.0 * -0.5).epsilon(1e-14));
  }
}

TEST_CASE("a large force that turns back beside 0 is split where it comes out of a small limit") {
  // 3 beside the line through 0 that it moves along.
  const FrictionUpdate u =
      moved(limited(5.0, slip_space({1, 2})), {3e7 - 2.4, 4e7 + 1.8}, {-3.6e6, -4.8e6});
  CHECK(u.onset == Approx((5e7 + 4.0) / 6e7).epsilon(1e-15));
}

TEST_CASE("a force that turns back through 0 is split there, however small the limit") {
  for (const double limit : {1e-8, 1e-12, 1e-20, 1e-30}) {
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.6, 0.8}, {-0.28, 0.96}}) {
      const FrictionUpdate u =
          moved(limited(limit, slip_space({1, 2})), {5.1 * x, 5.1 * y}, {-0.62 * x, -0.62 * y});
      CHECK(u.onset == Approx((5.1 + limit) / 6.2).epsilon(1e-14));
      CHECK(u.work == Approx(-0.5 * 5.1 * 0.51).epsilon(1e-7));
    }
  }
}

TEST_CASE("the work of any number of elastic slips is that of the limit") {
  Potential potential;
  potential.parts = potential.leaves = 1;
  potential.leaf[0].direction[0] = 1.0;
  for (const SlipCriterion& criterion :
       {SlipCriterion{EuclideanPotential{}}, SlipCriterion{potential}}) {
    FrictionDefinition definition = limited(1e-30);
    definition.criterion = criterion;
    const FrictionUpdate u = moved(definition, {}, {1e4, 0.0});
    CHECK(u.onset == Approx(1e-35).epsilon(1e-14).margin(0.0));
    CHECK(u.work == Approx(1e-26).epsilon(1e-14).margin(0.0));
  }
}

TEST_CASE("a force that turns back through 0 while wear takes all of the limit keeps its energy") {
  Potential potential;
  potential.parts = potential.leaves = 1;
  potential.leaf[0].direction[0] = 1.0;
  FrictionDefinition definition;
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force =
      test::make_function({{10, 0}, {0, 2}}, {test::kOverAccumulatedSlip});
  definition.law = ConstantCoefficient{1.0};
  definition.stick = {StickStiffness::Mode::kStiffness, 10.0};
  FrictionState old;
  old.force[0] = -17.3;
  old.elastic_slip[0] = -1.73;
  ConnectorIncrement increment;
  increment.duration = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double motion = 4.1 + 0.37 * i;
    increment.end.position[0] = motion;
    for (const SlipCriterion& criterion :
         {SlipCriterion{EuclideanPotential{}}, SlipCriterion{potential}}) {
      INFO(motion << ", criterion " << criterion.index());
      definition.criterion = criterion;
      const FrictionUpdate u = update(definition, increment, old);
      CHECK(u.state.regime == Regime::kOpen);
      CHECK(u.dissipation == 0.0);
      // Of the spring alone: the limit of the end is 0.
      CHECK(u.work == Approx(-17.3 * 17.3 / 20.0).epsilon(1e-12));
    }
  }
}

TEST_CASE("in a plane a force that turns back comes out of a fallen limit where its line does") {
  // From (20, 6) to the predictor (-20, 6): out of the circle of 10 again at (-8, 6).
  const FrictionUpdate u = moved(limited(10.0, slip_space({1, 2})), {20.0, 6.0}, {-4.0, 0.0});
  CHECK(u.onset == Approx(28.0 / 40.0).epsilon(1e-14));
  const double end = -20.0 * 10.0 / std::hypot(20.0, 6.0);
  CHECK(u.work == Approx(-2.8 * 0.5 * (20.0 - 8.0) - 1.2 * 0.5 * (end - 8.0)).epsilon(1e-14));
}

}  // namespace
