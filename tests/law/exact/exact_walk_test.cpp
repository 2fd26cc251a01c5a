// SPDX-License-Identifier: Apache-2.0
#include "law/exact/exact_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "law/base/quadrature.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// A slider with the stiffness 1 whose limit follows a cubic over a segment: it moves by 2, of
/// which f = a t + b t^2 + c t^3 would be slip if slip could go back. F_N = 1 + t, and mu is what
/// divides the limit by that: a quadratic, as a table over temperature and a field has along its
/// diagonal.
struct CubicLimit {
  double a, b, c;
  std::vector<std::pair<double, double>> slips;  ///< where f is larger than it has been

  double slip(double t) const { return t * (a + t * (b + t * c)); }
  double limit(double t) const { return 2.0 + slip(-1.0) + 2.0 * t - slip(t); }

  FrictionDefinition definition() const {
    const double at_begin = limit(0.0);
    const double rise = c - b;
    const double aside = at_begin + 0.5 * rise;
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1.0));
    definition.contact_force = ComponentContactForce{2};
    definition.law = TabularCoefficient{
        make_function({{at_begin, 0, 0}, {aside, 1, 0}, {aside, 0, 1}, {at_begin + rise - c, 1, 1}},
                      {kOverTemperature, over_field(0)})};
    return definition;
  }
};

Waypoint on_diagonal(double u, double t) {
  Waypoint point = at(u, 1.0 + t);
  point.temperature = t;
  point.fields = {t};
  return point;
}

/// From slip at the begin of the segment on.
ExactRun run_over(FrictionDefinition definition, double begin, int count) {
  ExactRun run(std::move(definition), on_diagonal(0.0, 0.0));
  run.go(on_diagonal(begin, 0.0));
  run.dissipation = run.work = 0.0;
  run.state.accumulated_slip = 0.0;
  run.go(on_diagonal(begin + 2.0, 1.0), count);
  return run;
}

/// Slip that rests and goes on, rests in the last or the first part of a segment, or begins late.
std::vector<CubicLimit> cubic_limits() {
  const double rests = (1.4 + std::sqrt(1.96 - 0.72)) / 6.0;  // where -0.06 + 1.4 t - 3 t^2 = 0
  return {{0.1, -0.35, 1.0 / 3.0, {{0.0, 0.2}, {0.65, 1.0}}},
          {0.95, -0.5, 0.0, {{0.0, 0.95}}},
          {0.1, -0.5, 0.0, {{0.0, 0.1}}},
          {-0.06, 0.7, -1.0, {{0.1, rests}}}};
}

TEST_CASE("slip that rests and begins within a smooth piece of its limit is found") {
  for (const CubicLimit& cubic : cubic_limits()) {
    CAPTURE(cubic.a, cubic.b, cubic.c);
    double slip = 0.0;
    double dissipation = 0.0;
    for (const auto& [from, to] : cubic.slips) {
      slip += cubic.slip(to) - cubic.slip(from);
      dissipation += gauss(
          [&](double t) {
            return cubic.limit(t) * (cubic.a + t * (2.0 * cubic.b + t * 3.0 * cubic.c));
          },
          from, to);
    }
    const double begin = cubic.limit(0.0) + 1.0;
    for (const int count : {1, 3}) {
      const ExactRun run = run_over(cubic.definition(), begin, count);
      CHECK(run.state.accumulated_slip == Approx(slip).epsilon(1e-10));
      CHECK(run.state.force[0] == Approx(cubic.limit(0.0) + 2.0 - slip).epsilon(1e-10));
      CHECK(run.dissipation == Approx(dissipation).epsilon(1e-9));
      CHECK(run.last.state.regime ==
            (cubic.slips.back().second < 1.0 ? Regime::kStick : Regime::kSlip));
    }
  }
}

TEST_CASE("slip that wears rests and begins alike however a segment is divided") {
  for (const CubicLimit& cubic : cubic_limits()) {
    CAPTURE(cubic.a, cubic.b, cubic.c);
    FrictionDefinition definition = cubic.definition();
    definition.internal_contact_force =
        make_function({{1e-3, 0.0}, {0.0, 10.0}}, {kOverAccumulatedSlip});
    const double begin = cubic.limit(0.0) + 1.0;
    const ExactRun whole = run_over(definition, begin, 1);
    const ExactRun parts = run_over(definition, begin, 40);
    CHECK(whole.state.regime == parts.state.regime);
    CHECK(whole.state.force[0] == Approx(parts.state.force[0]).epsilon(1e-10));
    CHECK(whole.dissipation == Approx(parts.dissipation).epsilon(1e-9));
  }
}

TEST_CASE("a force that turns under a limit that vanishes does so in any part of a segment") {
  // R = 0.02 falls to 0 while the motion across goes on by R: tan(psi/2) falls with R, and the slip
  // is R pi/2, the dissipation F R ln 2.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0), {1, 2});
  DerivedTerm term = norm_term({3}, 1.0);
  term.combine = TermOperator::kMacauleySum;
  definition.contact_force = DerivedComponent{term};
  for (const double part : {1.0, 1e-3, 1e-6}) {
    CAPTURE(part);
    ExactRun run(definition, at(0.0, 100.0));
    run.go(at(0.05, 100.0));
    run.dissipation = 0.0;
    run.go(at(0.05, 100.0 - 100.0 / part, 0.02 / part));
    CHECK(run.last.slip_increment == Approx(0.01 * std::numbers::pi).epsilon(1e-8));
    CHECK(run.dissipation == Approx(0.4 * std::numbers::ln2).epsilon(1e-8));
  }
}

TEST_CASE("slip in all six components has the direction of the motion") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0), {1, 2, 3, 4, 5, 6});
  ExactRun run(definition);
  Waypoint end;
  for (int c = 0; c < kComponents; ++c) end.position[c] = 0.05;
  run.go(end);
  for (int number = 1; number <= kComponents; ++number) {
    CHECK(run.friction(number) == Approx(20.0 / std::sqrt(6.0)).epsilon(1e-14));
  }
  CHECK(run.last.motion_direction[5] == Approx(1.0 / std::sqrt(6.0)).epsilon(1e-14));
  CHECK(run.last.slip_rate == 0.0);  // none that the coefficient saw
  run.changes.overflow = true;
  run.go(end);
  CHECK(run.last.motion_direction == SlipVector{});
  CHECK_FALSE(run.changes.overflow);
}

TEST_CASE("the work of a stick under a limit that grows is that of its force") {
  // F = 20 (1 + t) s/0.02, s = 0.01 t.
  FrictionDefinition definition = slider(0.2, 0.0, allowable_slip(0.02));
  definition.contact_force = ComponentContactForce{2};
  ExactRun run(definition, at(0.0, 100.0));
  run.go(at(0.01, 200.0));
  CHECK(run.work == Approx(0.1 * (1.0 / 2.0 + 1.0 / 3.0)).epsilon(1e-11));
}

TEST_CASE("a coefficient over the rate of the slip sees motions of any size") {
  for (const double unit : {1.0, 1e-3, 1e-9}) {
    FrictionDefinition definition = slider(0.0, 100.0, allowable_slip(0.01 * unit));
    definition.law = ExponentialDecay{0.3, 0.2, 0.05 / unit};
    Waypoint end = at(unit);
    end.duration = 0.1;
    ExactRun run(definition, at(0.0));
    run.go(end);
    CHECK(run.friction(1) == Approx(20.0 + 10.0 * std::exp(-0.5)).epsilon(1e-13));
  }
}

TEST_CASE("a change of friction that begins with the law alone goes to the definition's start") {
  FrictionDefinition definition = slider(0.3, 100.0, fixed_stiffness(1000.0));
  definition.blend = {0.1, 0.5};
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.end.position[0] = 1.0;
  PathSegment segment = path_segment(definition, increment, {}, {});
  segment.begin_blend = {};
  CHECK(continuous_update(definition, segment, {}, 1e-12).state.force[0] ==
        Approx(20.0).epsilon(1e-12));
}

}  // namespace
