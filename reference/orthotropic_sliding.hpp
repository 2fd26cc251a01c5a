// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Steady sliding with a coefficient of its own in each of two directions.
///
/// Formula   (f1/(mu1 N))^2 + (f2/(mu2 N))^2 <= 1. The force of the greatest power at the velocity
///           v: with w_i = mu_i v_i, f_i = N mu_i w_i/|w|; power N |w|.
/// Symbols   f_i friction forces [F], v_i velocities [L/T], mu_i coefficients [1], N normal force
///           [F].
/// Sign      f_i has the sign of v_i; the vector is parallel to v only along the two directions or
///           for equal coefficients.
/// Source    principle of maximum dissipation; derived in docs/theory.
/// Range     mu_i, N >= 0; each row by itself. No force where w = 0. Reached from any start for
///           every size of increment by the closest point of the ellipse.
namespace slipbench::reference::orthotropic_sliding {

struct Vector {
  double x;
  double y;
};

/// Friction force [F] at the velocity [L/T] with the coefficients [1] and the normal force [F].
inline Vector force(Vector mu, double normal_force, Vector velocity) {
  const Vector w{mu.x * velocity.x, mu.y * velocity.y};
  const double length = std::hypot(w.x, w.y);
  if (length == 0.0) return {0.0, 0.0};
  return {normal_force * mu.x * (w.x / length), normal_force * mu.y * (w.y / length)};
}

inline constexpr std::array kInputs{
    Signal{"velocity1", "L/T", "relative velocity, first direction"},
    Signal{"velocity2", "L/T", "relative velocity, second direction"},
    Signal{"normal_force", "F", "normal force, not negative"},
    Signal{"mu1", "1", "friction coefficient of the first direction"},
    Signal{"mu2", "1", "friction coefficient of the second direction"}};
inline constexpr std::array kOutputs{
    Signal{"force1", "F", "friction force, first direction"},
    Signal{"force2", "F", "friction force, second direction"},
    Signal{"magnitude", "F", "magnitude of the friction force"},
    Signal{"power", "F L/T", "power dissipated"},
    Signal{"angle", "1", "from the velocity to the force, counter-clockwise"}};

inline PathEvaluator make(std::span<const std::vector<double>>) {
  return [](std::span<const double> inputs, std::span<double> outputs) {
    const Vector v{inputs[0], inputs[1]};
    const Vector f = force({inputs[3], inputs[4]}, inputs[2], v);
    outputs[0] = f.x;
    outputs[1] = f.y;
    outputs[2] = std::hypot(f.x, f.y);
    outputs[3] = inputs[2] * std::hypot(inputs[3] * v.x, inputs[4] * v.y);
    outputs[4] = std::atan2(v.x * f.y - v.y * f.x, v.x * f.x + v.y * f.y);
  };
}

inline constexpr ClosedForm kForm{
    .name = "orthotropic_steady_sliding",
    .title = "Steady sliding with two coefficients of friction: the force of the greatest power",
    .formula = "f_i = N mu_i^2 v_i/sqrt((mu1 v1)^2 + (mu2 v2)^2)",
    .source = "principle of maximum dissipation; derived in docs/theory",
    .range = "mu_i, N >= 0; steady slip, each row by itself",
    .parameters = {},
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::orthotropic_sliding
