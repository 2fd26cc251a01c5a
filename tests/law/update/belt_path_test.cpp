// SPDX-License-Identifier: Apache-2.0
// Belts along a straight piece of history: distance and reference length of an elastic one go
// straight, its tension does not.
#include <catch2/catch.hpp>
#include <cmath>

#include "law/connection/belt.hpp"
#include "law/exact/continuous_update.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

constexpr double kAngle = 1.5;
constexpr double kMu = 0.2;

FrictionDefinition belt(StickStiffness stick) {
  FrictionDefinition definition = slider(kMu, 0.0, stick, {2});
  definition.criterion = Capstan{kAngle};
  definition.contact_force = ComponentContactForce{0};
  return definition;
}

KineticBehavior spring(Elasticity elasticity) {
  KineticBehavior behavior;
  behavior.elasticity[0] = std::move(elasticity);
  behavior.pressing = ComponentSet::of(1);
  return behavior;
}

/// From 100 long and `begin_strain` of it to `distance`, while `flow` leaves at the ring; in 1 s.
PathSegment pull(const FrictionDefinition& definition, const KineticBehavior& behavior,
                 double begin_strain, double distance, double flow) {
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.begin_position[0] = 100.0;
  increment.end.position[0] = distance;
  increment.end.position[1] = flow;
  Ambient begin;
  begin.position = increment.begin_position;
  const double length = initial_reference_length(100.0, begin_strain);
  increment.end.motion[0] = strain(distance, length - flow);
  set_kinetic_forces(behavior, behavior.pressing, &increment);
  PathSegment segment = path_segment(definition, increment, begin, {});
  segment.kinetic = &behavior;
  segment.begin_length = length;
  segment.end_length = length - flow;
  return segment;
}

TEST_CASE("the tension at a place of a segment is that of the strain there, negative where slack") {
  const KineticBehavior behavior = spring(Elasticity(5000.0));
  const FrictionDefinition definition = belt(allowable_slip(0.01));
  const PathSegment segment = pull(definition, behavior, 0.01, 95.0, 1.0);
  SegmentPoints points(definition, segment, 1.0);
  for (const double tau : {0.0, 0.125, 0.3, 0.5, 0.9, 1.0}) {
    const double expected = 5000.0 * ((100.0 - 5.0 * tau) / (100.0 / 1.01 - tau) - 1.0);
    CHECK(points.increment(tau).force[0] == Approx(expected).margin(1e-10));
    CHECK(points.limit(tau, 0, 0, 1).force ==
          Approx(std::max(expected, 0.0) * std::expm1(kMu * kAngle)).margin(1e-10));
  }
  CHECK(points.increment(1.0).force[0] < -100.0);
  CHECK(points.increment(1.0).force[0] == segment.increment.force[0]);
}

TEST_CASE("a knot of the force over the strain is met inside of an increment") {
  // Up to the knot the limit grows more slowly than the spring of the stick and the belt slips;
  // from there on it grows faster, and the belt sticks.
  const KineticBehavior behavior =
      spring(Elasticity(make_function({{0, 0}, {10, 0.02}, {500, 0.04}}, {over_motion(1)})));
  const FrictionDefinition definition = belt(fixed_stiffness(100.0));
  RegimeChanges changes;
  const FrictionUpdate end = continuous_update(
      definition, pull(definition, behavior, 0.0, 103.0, 1.0), {}, 1e-12, &changes);
  // (100 + 3 tau)/(100 - tau) = 1.02.
  const double knot = 2.0 / 4.02;
  const double force = 10.0 * std::expm1(kMu * kAngle);
  REQUIRE(changes.count >= 2);
  const RegimeChange& last = changes.at[static_cast<std::size_t>(changes.count - 1)];
  CHECK(last.to == Regime::kStick);
  CHECK(last.fraction == Approx(knot).epsilon(1e-12));
  CHECK(last.force == Approx(force).epsilon(1e-11));
  CHECK(end.state.accumulated_slip == Approx(knot - force / 100.0).epsilon(1e-12));
  CHECK(end.state.force[0] == Approx(force + 100.0 * (1.0 - knot)).epsilon(1e-12));
  CHECK(end.work == Approx(end.dissipation + end.stored_energy).epsilon(1e-12));
}

TEST_CASE("a belt with an elastic slip dissipates under the tension of its strain") {
  const KineticBehavior behavior = spring(Elasticity(5000.0));
  const FrictionDefinition definition = belt(allowable_slip(0.01));
  const FrictionUpdate end =
      continuous_update(definition, pull(definition, behavior, 0.002, 101.0, 1.0), {}, 1e-12);
  CHECK(end.state.accumulated_slip == Approx(0.99).epsilon(1e-14));
  // With l the reference length, d = c - l: the integral of c/l - 2 from the end to where it slips.
  const double length = 100.0 / 1.002;
  const double c = 100.0 + length;
  CHECK(end.dissipation == Approx(5000.0 * std::expm1(kMu * kAngle) *
                                  (c * std::log((length - 0.01) / (length - 1.0)) - 2.0 * 0.99))
                               .epsilon(1e-11));
}

TEST_CASE("a belt of a viscous law meets the limit of the side that it flows to") {
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0), {2});
  definition.law = TabularCoefficient{make_function({{0.1, 0.0}, {0.3, 2.0}}, {kOverSlipRate})};
  definition.criterion = Capstan{1.5};
  definition.contact_force = ComponentContactForce{0};
  Waypoint begin;
  begin.force[0] = 100.0;
  for (const int count : {1, 7}) {
    ExactRun run(definition, begin);
    Waypoint to = begin;
    for (const double flow : {2.0, -2.0, 0.0}) {
      to.position[1] = flow;
      to.duration = std::abs(flow - run.here().position[1]) / 2.0;
      run.go(to, count);
      const double z = flow < 0.0 ? -1.0 : 1.0;
      CHECK(run.friction(2) == Approx(100.0 * std::expm1(z * 0.3 * 1.5)).epsilon(1e-11));
      CHECK(run.last.limit == Approx(std::abs(run.friction(2))).epsilon(1e-11));
      CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-11));
    }
  }
}

}  // namespace
