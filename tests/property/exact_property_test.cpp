// SPDX-License-Identifier: Apache-2.0
// Promises of exact integration on histories of straight pieces, whatever the law.
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include "tests/support/backward_euler_error.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Fixes the seed before RapidCheck first looks; a RC_PARAMS of the environment wins.
const bool kSeeded =
    setenv("RC_PARAMS", "seed=20240611 max_success=1500 max_discard_ratio=100", 0) == 0;

template <class Property>
void check(const std::string& text, const Property& property) {
  REQUIRE(kSeeded);
  REQUIRE(rc::check(text, property));
}

Dice draw_dice() {
  return Dice(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()).as("seed"));
}

double magnitude(const std::array<double, kComponents>& v) {
  double square = 0.0;
  for (const double x : v) square += x * x;
  return std::sqrt(square);
}

double distance(const FrictionState& a, const FrictionState& b) {
  double square = 0.0;
  for (std::size_t i = 0; i < kComponents; ++i) {
    square += (a.force[i] - b.force[i]) * (a.force[i] - b.force[i]);
  }
  return std::sqrt(square);
}

/// A slider under a constant normal force, in one to three dimensions, in either stick mode.
struct Polyline {
  FrictionDefinition definition;
  double limit = 0.0;
  double elastic = 0.0;
  std::vector<Waypoint> corners;
};

Polyline draw_polyline(Dice* dice, int dimension, int corners) {
  Polyline line;
  const double mu = dice->between(0.05, 0.8);
  const double normal = dice->between(1.0, 500.0);
  const double g = dice->between(0.005, 0.1);
  line.limit = mu * normal;
  line.elastic = g;
  const bool fixed = dice->chance(0.5);
  line.definition = slider(mu, normal, fixed ? fixed_stiffness(line.limit / g) : allowable_slip(g));
  line.definition.slip.dimension = dimension;
  for (int i = 0; i < dimension; ++i)
    line.definition.slip.component[static_cast<std::size_t>(i)] = i;
  Waypoint here;
  const std::vector<double> strides = {0.0, 0.01, 0.3, 1.0, 5.0};
  for (int n = 0; n < corners; ++n) {
    const double stride = dice->one_of(strides) * g;
    const bool straight = n > 0 && dice->chance(0.2);
    const Waypoint before = here;
    for (int i = 0; i < dimension; ++i) {
      // Now and then exactly back, or exactly on.
      const double last =
          n > 0 ? line.corners.back().position[i] -
                      (n > 1 ? line.corners[static_cast<std::size_t>(n - 2)].position[i] : 0.0)
                : 0.0;
      here.position[i] = before.position[i] + (straight ? (dice->chance(0.5) ? -last : last)
                                                        : dice->between(-stride, stride));
    }
    line.corners.push_back(here);
  }
  return line;
}

struct End {
  FrictionState state;
  double dissipation = 0.0;
  double work = 0.0;
  double stored = 0.0;
};

End follow(const FrictionDefinition& definition, const std::vector<Waypoint>& corners, int count) {
  ExactRun run(definition);
  for (const Waypoint& corner : corners) run.go(corner, count);
  return {run.state, run.dissipation, run.work, run.last.stored_energy};
}

TEST_CASE("on polylines at a constant limit dividing segments changes nothing") {
  check("1, 7 and 100 increments a segment: the same end, the energies close", [] {
    const int dimension = *rc::gen::inRange(1, 4).as("dimension");
    const int corners = *rc::gen::inRange(1, 12).as("corners");
    Dice dice = draw_dice();
    const Polyline line = draw_polyline(&dice, dimension, corners);
    const End one = follow(line.definition, line.corners, 1);
    for (const int count : {7, 100}) {
      const End end = follow(line.definition, line.corners, count);
      // The rounding of a hundred increments of every segment.
      RC_ASSERT(distance(end.state, one.state) <= 1e-11 * line.limit);
      RC_ASSERT(std::abs(end.state.accumulated_slip - one.state.accumulated_slip) <=
                1e-11 * (line.elastic + one.state.accumulated_slip));
      RC_ASSERT(std::abs(end.dissipation - one.dissipation) <=
                1e-11 * (line.limit * line.elastic + one.dissipation));
    }
    RC_ASSERT(magnitude(one.state.force) <= line.limit * (1.0 + 1e-12));
    RC_ASSERT(std::abs(one.work - one.dissipation - one.stored) <=
              1e-12 * (line.limit * line.elastic + one.dissipation));
  });
}

TEST_CASE("exact paths are odd and turn with the plane") {
  check("-u gives -y; a rotated path gives the rotated force and the same slip", [] {
    const int corners = *rc::gen::inRange(1, 12).as("corners");
    Dice dice = draw_dice();
    const Polyline line = draw_polyline(&dice, 2, corners);
    const double angle = dice.between(0.0, 6.3);
    std::vector<Waypoint> mirrored = line.corners;
    std::vector<Waypoint> rotated = line.corners;
    for (std::size_t i = 0; i < line.corners.size(); ++i) {
      const double x = line.corners[i].position[0];
      const double y = line.corners[i].position[1];
      mirrored[i].position[0] = -x;
      mirrored[i].position[1] = -y;
      rotated[i].position[0] = std::cos(angle) * x - std::sin(angle) * y;
      rotated[i].position[1] = std::sin(angle) * x + std::cos(angle) * y;
    }
    const End end = follow(line.definition, line.corners, 1);
    const End back = follow(line.definition, mirrored, 1);
    for (std::size_t i = 0; i < 2; ++i) RC_ASSERT(back.state.force[i] == -end.state.force[i]);
    RC_ASSERT(back.state.accumulated_slip == end.state.accumulated_slip);
    RC_ASSERT(back.dissipation == end.dissipation);
    const End turned = follow(line.definition, rotated, 1);
    // A path that goes exactly back is unstable to the rounding of its direction by the rotation:
    // what it ends with is not, since slip goes on straight.
    const double fx = std::cos(angle) * end.state.force[0] - std::sin(angle) * end.state.force[1];
    const double fy = std::sin(angle) * end.state.force[0] + std::cos(angle) * end.state.force[1];
    RC_ASSERT(std::hypot(fx - turned.state.force[0], fy - turned.state.force[1]) <=
              1e-10 * line.limit);
    RC_ASSERT(std::abs(turned.state.accumulated_slip - end.state.accumulated_slip) <=
              1e-10 * (line.elastic + end.state.accumulated_slip));
  });
}

TEST_CASE("backward Euler goes to the exact path with the first power of the increment") {
  check("the distance at 400 and at 800 increments a segment has the ratio 2", [] {
    Dice dice = draw_dice();
    const Polyline line = draw_polyline(&dice, 2, 4);
    const End exact = follow(line.definition, line.corners, 1);
    const auto apart = [&](int count) {
      FrictionRun run(line.definition);
      Waypoint from;
      for (const Waypoint& corner : line.corners) {
        for (int i = 1; i <= count; ++i) {
          for (int c = 0; c < 2; ++c) {
            run.position[c] =
                from.position[c] + (corner.position[c] - from.position[c]) * i / count;
          }
          run.step();
        }
        from = corner;
      }
      return distance(run.state, exact.state);
    };
    // Where the error is not rounding it halves, up to what is of higher order: of few increments
    // in an elastic slip that may still count.
    const auto is_of_first_order = [&](int count) {
      const double coarse = apart(count);
      const double fine = apart(2 * count);
      return fine <= 0.02 * line.limit &&
             (coarse <= 1e-6 * line.limit || std::abs(fine / coarse - 0.5) < 0.05);
    };
    // In parentheses: RC_ASSERT takes both sides of an || first.
    RC_ASSERT((is_of_first_order(400) || is_of_first_order(12800)));
  });
}

/// A random definition that has a continuous solution by events, and a history of it.
struct Case {
  DefinitionDescription description;
  FrictionDefinition definition;
  std::vector<HistoryRow> rows;
};

/// Draws a case of each kind of definitions, and belts, one after the other; by Dice alone, since
/// RapidCheck draws small numbers first: few kinds, and the same ones again.
std::optional<Case> draw_case(std::uint64_t seed) {
  Dice dice(seed);
  const int kind = static_cast<int>(seed % (kDefinitionKinds + 1));
  Case c{kind < kDefinitionKinds ? random_definition(&dice, kind) : random_belt(&dice), {}, {}};
  c.definition = c.description.build();
  if (continuous_method(c.definition) != ContinuousMethod::kEvents ||
      no_continuous_solution(c.definition)) {
    return std::nullopt;
  }
  c.rows = random_history(&dice, 1 + dice.pick(4));
  // Half of all tensions push: three of four belts are tight instead.
  if (c.description.belt && dice.chance(0.75)) {
    for (HistoryRow& row : c.rows) row.force[0] = std::abs(row.force[0]);
  }
  // A row without time has no rate that parts of it could share.
  for (HistoryRow& row : c.rows) row.duration = std::max(row.duration, 1e-3);
  return c;
}

Waypoint waypoint(const HistoryRow& row) {
  Waypoint point;
  point.position = row.end;
  point.force = row.force;
  point.temperature = row.temperature;
  point.fields.assign(row.fields.begin(), row.fields.end());
  point.duration = row.duration;
  return point;
}

Waypoint first_waypoint(const HistoryRow& row) {
  Waypoint point = waypoint(row);
  point.position = row.begin;
  return point;
}

TEST_CASE("whatever the law, exact results are finite, admissible and dissipate") {
  int drawn = 0;
  for (std::uint64_t seed = 0; drawn < 500; ++seed) {
    const auto c = draw_case(seed);
    if (!c) continue;
    ++drawn;
    CAPTURE(seed, c->description.name);
    ExactRun run(c->definition, first_waypoint(c->rows.front()), 1e-10);
    double slip = 0.0;
    for (const HistoryRow& row : c->rows) {
      const Regime before = run.state.regime;
      const double held = run.last.stored_energy;
      const FrictionUpdate& u = run.go(waypoint(row));
      for (const double x : numbers(u)) REQUIRE(std::isfinite(x));
      REQUIRE(u.converged);
      REQUIRE(magnitude(u.state.force) <= u.limit * (1.0 + 1e-12));
      REQUIRE(u.dissipation >= 0.0);
      REQUIRE(u.slip_increment >= 0.0);
      REQUIRE(u.state.accumulated_slip >= slip);
      slip = u.state.accumulated_slip;
      double at = 0.0;
      Regime regime = before;
      for (int i = 0; i < run.changes.count; ++i) {
        const RegimeChange& change = run.changes.at[static_cast<std::size_t>(i)];
        REQUIRE(change.fraction >= at);
        REQUIRE(change.fraction <= 1.0);
        REQUIRE(change.to != regime);
        at = change.fraction;
        regime = change.to;
      }
      if (!run.changes.overflow) REQUIRE(regime == u.state.regime);
      if (c->definition.stick.mode == StickStiffness::Mode::kStiffness &&
          u.state.regime != Regime::kOpen && run.changes.count == 0) {
        REQUIRE(std::abs(u.work - u.dissipation - (u.stored_energy - held)) <=
                1e-9 * (u.dissipation + u.stored_energy + held) + 1e-300);
      }
    }
  }
}

/// Record of a run, row by row.
struct Trace {
  std::vector<double> force, slip, dissipation, stored, work;
  bool opens = false;
};

Trace trace(const FrictionDefinition& definition, const std::vector<HistoryRow>& rows, int count,
            bool backward_euler = false) {
  ExactRun run(definition, first_waypoint(rows.front()), 1e-10);
  run.backward_euler = backward_euler;
  Trace result;
  for (const HistoryRow& row : rows) {
    run.go(waypoint(row), count);
    for (int i = 0; i < run.changes.count; ++i) {
      if (run.changes.at[static_cast<std::size_t>(i)].to == Regime::kOpen) result.opens = true;
    }
    result.force.push_back(magnitude(run.state.force));
    result.slip.push_back(run.state.accumulated_slip);
    result.dissipation.push_back(run.dissipation);
    result.stored.push_back(run.last.stored_energy);
    result.work.push_back(run.work);
  }
  return result;
}

double largest(const std::vector<double>& curve) {
  return std::accumulate(curve.begin(), curve.end(), 1e-12,
                         [](double most, double x) { return std::max(most, std::abs(x)); });
}

/// The largest difference of two curves as a part of the first one's size, or of `size`.
double apart(const std::vector<double>& a, const std::vector<double>& b, double size = 1e-12) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    size = std::max(size, std::abs(a[i]));
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most / size;
}

TEST_CASE("whatever the law, dividing increments changes nothing beyond the tolerance") {
  int drawn = 0;
  int belts = 0;
  for (std::uint64_t seed = 0; drawn < 200 || belts < 15; ++seed) {
    const auto c = draw_case(seed);
    if (!c) continue;
    ++drawn;
    if (c->description.belt) ++belts;
    const Trace whole = trace(c->definition, c->rows, 1);
    // The tolerance of 1e-10 in some ten pieces of each row.
    const double within = 1e-9 * static_cast<double>(c->rows.size());
    for (const int count : {3, 7, 50}) {
      CAPTURE(seed, c->description.name, count);
      const Trace parts = trace(c->definition, c->rows, count);
      CHECK(apart(whole.force, parts.force) <= within);
      CHECK(apart(whole.slip, parts.slip) <= within);
      CHECK(apart(whole.dissipation, parts.dissipation) <= within);
      CHECK(apart(whole.stored, parts.stored) <= within);
      CHECK(apart(whole.work, parts.work) <= within);
    }
  }
}

TEST_CASE("whatever the law, a fine backward Euler tends to the exact end of every row") {
  int belts = 0;
  std::vector<double> ratios;
  int drawn = 0;
  for (std::uint64_t seed = 0; drawn < 200 || belts < 5; ++seed) {
    const auto c = draw_case(seed);
    if (!c) continue;
    const bool fixed = c->definition.stick.mode == StickStiffness::Mode::kStiffness;
    const Trace exact = trace(c->definition, c->rows, 1);
    // Backward Euler does not see an opening of an instant, in which an elastic slip is forgotten.
    if (!fixed && exact.opens) continue;
    ++drawn;
    if (c->description.belt) ++belts;
    // Where the speed of the next row lets the limit fall at once, the spring relaxes in one
    // increment against the force of its end, whatever its length; exactly, against that on the
    // way.
    const bool falls_at_once = fixed && !c->description.rate_independent();
    // What is less than the spring holds counts as little.
    const double stick = c->definition.stick.value;
    const double elastic = fixed ? largest(exact.force) / stick : stick;
    const double stored = largest(exact.stored);
    const auto error_at = [&](int count) {
      const Trace euler = trace(c->definition, c->rows, count, true);
      const double error = apart(exact.force, euler.force) +
                           apart(exact.slip, euler.slip, elastic) +
                           apart(exact.stored, euler.stored);
      return falls_at_once ? error : error + apart(exact.dissipation, euler.dissipation, stored);
    };
    const BackwardEulerError error = backward_euler_error(300, error_at);
    CAPTURE(seed, c->description.name, error.coarse, error.fine);
    if (error.coarse < 0.05 && error.fine > 1e-6) ratios.push_back(error.coarse / error.fine);
    CHECK(error.last <= 0.05);
  }
  REQUIRE(ratios.size() > 20);
  CHECK(middle_of(ratios) == Approx(2.0).margin(0.1));
}

}  // namespace
