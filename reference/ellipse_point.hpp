// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// The points of an ellipse that stand for a force outside it: the closest one, and the one that
/// OpenRadioss takes.
///
/// Formula   Closest: (a1 cos t, a2 sin t) with a1 x sin t - a2 y cos t = (a1^2 - a2^2) sin t cos
///           t, x, y >= 0, by bisection over 0 <= t <= pi/2. By ratio: G = F - q (e -
///           sqrt(e))/|q|^2 with q_i = F_i/a_i^2, e = q.F, brought onto the ellipse along its own
///           direction: |G_i| /sqrt((G1/a1)^2 + (G2/a2)^2), with the signs of F.
/// Symbols   F = (x, y) trial force [F], a_i semi-axes, mu_i N [F], t parameter angle [1].
/// Sign      each component keeps the sign of its trial.
/// Source    first-order condition of the distance, theory 14.19; by ratio: as
///           OpenRadioss (2026) computes.
/// Range     a_i >= 0; an axis of length 0 has no force and leaves the other to itself. A force
///           inside stays. Where both axes are equal both points are the radial one.
namespace slipbench::reference::ellipse_point {

struct Vector {
  double x;
  double y;
};

/// Tells whether the trial [F] lies in the ellipse with these semi-axes > 0 [F].
inline bool inside(Vector trial, Vector axes) {
  return std::hypot(trial.x / axes.x, trial.y / axes.y) <= 1.0;
}

/// The forces where one axis at least has no length: each component is bounded alone.
inline Vector bounded_alone(Vector trial, Vector axes) {
  return {std::clamp(trial.x, -axes.x, axes.x), std::clamp(trial.y, -axes.y, axes.y)};
}

/// The point [F] of the ellipse that lies closest to the trial.
///
/// Outside the ellipse the condition has one root in the quadrant of the trial: its left-hand side
/// less the right is not positive at t = 0 and not negative at pi/2.
inline Vector closest(Vector trial, Vector axes) {
  if (axes.x == 0.0 || axes.y == 0.0) return bounded_alone(trial, axes);
  if (inside(trial, axes)) return trial;
  const long double a = axes.x, b = axes.y;
  const long double x = std::abs(trial.x), y = std::abs(trial.y);
  long double low = 0.0L, high = 0.5L * std::numbers::pi_v<long double>;
  constexpr int kHalvings = 80;  // past the last bit of the angle
  for (int i = 0; i < kHalvings; ++i) {
    const long double t = 0.5L * (low + high);
    const long double c = std::cos(t), s = std::sin(t);
    (a * x * s - b * y * c - (a * a - b * b) * s * c < 0.0L ? low : high) = t;
  }
  const long double t = 0.5L * (low + high);
  return {std::copysign(static_cast<double>(a * std::cos(t)), trial.x),
          std::copysign(static_cast<double>(b * std::sin(t)), trial.y)};
}

/// The point [F] of the ellipse that the return by ratio takes.
inline Vector by_ratio(Vector trial, Vector axes) {
  if (axes.x == 0.0 || axes.y == 0.0) return bounded_alone(trial, axes);
  if (inside(trial, axes)) return trial;
  const Vector q{trial.x / (axes.x * axes.x), trial.y / (axes.y * axes.y)};
  const double e = q.x * trial.x + q.y * trial.y;
  const double step = (e - std::sqrt(e)) / (q.x * q.x + q.y * q.y);
  const Vector g{trial.x - q.x * step, trial.y - q.y * step};
  const double size = std::hypot(g.x / axes.x, g.y / axes.y);
  return {std::copysign(g.x / size, trial.x), std::copysign(g.y / size, trial.y)};
}

inline constexpr std::array kInputs{
    Signal{"trial1", "F", "trial force, first direction"},
    Signal{"trial2", "F", "trial force, second direction"},
    Signal{"limit1", "F", "semi-axis of the first direction, not negative"},
    Signal{"limit2", "F", "semi-axis of the second direction, not negative"}};
inline constexpr std::array kOutputs{Signal{"force1", "F", "friction force, first direction"},
                                     Signal{"force2", "F", "friction force, second direction"},
                                     Signal{"distance", "F", "from the trial to the force"}};

template <Vector (*Point)(Vector trial, Vector axes)>
PathEvaluator make(std::span<const std::vector<double>>) {
  return [](std::span<const double> inputs, std::span<double> outputs) {
    const Vector f = Point({inputs[0], inputs[1]}, {inputs[2], inputs[3]});
    outputs[0] = f.x;
    outputs[1] = f.y;
    outputs[2] = std::hypot(inputs[0] - f.x, inputs[1] - f.y);
  };
}

inline constexpr ClosedForm kClosestForm{
    .name = "ellipse_closest_point",
    .title = "The point of the friction ellipse closest to a trial force",
    .formula = "a1 x sin t - a2 y cos t = (a1^2 - a2^2) sin t cos t",
    .source = "first-order condition of the distance, theory 14.19",
    .range = "a_i >= 0; a trial inside stays, an axis of length 0 has no force",
    .parameters = {},
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make<closest>,
    .violation = no_violation};

inline constexpr ClosedForm kRatioForm{
    .name = "ellipse_ratio_point",
    .title = "The point of the friction ellipse that OpenRadioss takes for a trial force",
    .formula = "G = F - q (e - sqrt(e))/|q|^2, q_i = F_i/a_i^2, e = q.F, then along G",
    .source = "as OpenRadioss (2026) computes",
    .range = "a_i >= 0; a trial inside stays, an axis of length 0 has no force",
    .parameters = {},
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make<by_ratio>,
    .violation = no_violation};

}  // namespace slipbench::reference::ellipse_point
