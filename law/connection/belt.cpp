// SPDX-License-Identifier: Apache-2.0
#include "law/connection/belt.hpp"

#include <numbers>

namespace slipbench::law {
namespace {

using std::numbers::pi;

/// Angle between the segments, 0..pi [1], and the unit axis about which ab turns into bc by it; the
/// axis is 0 where there is none.
struct Bend {
  double angle = 0.0;
  Point axis{};
};

Bend bend(const Point& a, const Point& b, const Point& c) {
  // Below this sine the axis is rounding.
  constexpr double kStraight = 1e-12;
  const double ab = distance(a, b);
  const double bc = distance(b, c);
  Point u{};
  Point v{};
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = (b[i] - a[i]) / ab;
    v[i] = (c[i] - b[i]) / bc;
  }
  Bend result{wrap_angle(a, b, c),
              {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
  const double sine = distance({}, result.axis);
  for (double& x : result.axis) x = sine > kStraight ? x / sine : 0.0;
  return result;
}

/// Returns the one of `angle` + 2 pi k that is nearest to another angle.
double nearest_turn(double angle, double to) {
  return angle + 2.0 * pi * std::round((to - angle) / (2.0 * pi));
}

}  // namespace

BeltTurn begin_turn(int half_turns, const Point& a, const Point& b, const Point& c) {
  Bend now = bend(a, b, c);
  if (half_turns % 2 == 0) return {half_turns * pi + now.angle, now.axis};
  for (double& x : now.axis) x = -x;
  return {(half_turns + 1) * pi - now.angle, now.axis};
}

BeltTurn follow_turn(const BeltTurn& before, const Point& a, const Point& b, const Point& c) {
  Bend now = bend(a, b, c);
  const auto dot = [](const Point& p, const Point& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  };
  const bool has_axis = dot(now.axis, now.axis) > 0.0;
  const bool had_axis = dot(before.axis, before.axis) > 0.0;
  const double same = nearest_turn(now.angle, before.angle);
  const double opposite = nearest_turn(-now.angle, before.angle);
  if (has_axis && had_axis) {
    if (dot(now.axis, before.axis) >= 0.0) return {same, now.axis};
    for (double& x : now.axis) x = -x;
    return {opposite, now.axis};
  }
  // Without an axis to go by, the nearer one; out of a straight line the belt turns on.
  const double off_same = std::abs(same - before.angle);
  const double off_opposite = std::abs(opposite - before.angle);
  constexpr double kEqual = 1e-9;
  const bool take_same =
      std::abs(off_same - off_opposite) <= kEqual ? same >= opposite : off_same < off_opposite;
  if (take_same) return {same, has_axis ? now.axis : before.axis};
  for (double& x : now.axis) x = -x;
  return {opposite, has_axis ? now.axis : before.axis};
}

}  // namespace slipbench::law
