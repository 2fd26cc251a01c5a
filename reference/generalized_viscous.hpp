// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/pressure_coefficient.hpp"

/// Coefficient of friction that is a full quadratic polynomial in contact pressure and speed.
///
/// Formula   mu = Fric + C1 p + C2 V + C3 p V + C4 p^2 + C5 V^2, here nested in p.
/// Symbols   p contact pressure [F/L^2], V = |v| speed [L/T], mu [1]; C1 [L^2/F], C2 [T/L],
///           C3 [L T/F], C4 [L^4/F^2], C5 [T^2/L^2].
/// Source    Radioss reference guide, /FRICTION, Ifric = 1.
/// Range     any constants; the polynomial may fall below zero, the floor is below it.
namespace slipbench::reference::generalized_viscous {

using pressure_coefficient::Coefficient;

/// Fric, C1 .. C5, in the units above.
using Constants = std::array<double, 6>;

/// mu and its slopes at the pressure p [F/L^2] and the speed V >= 0 [L/T].
inline Coefficient coefficient(const Constants& c, double pressure, double speed) {
  const double linear = c[1] + c[3] * speed;
  const double at_no_pressure = c[0] + speed * (c[2] + speed * c[5]);
  return {at_no_pressure + pressure * (linear + pressure * c[4]),
          c[2] + c[3] * pressure + 2.0 * c[5] * speed, linear + 2.0 * c[4] * pressure};
}

inline constexpr std::array kParameters{
    pressure_coefficient::kFric,
    pressure_coefficient::constant("C1", "L^2/F", "factor of the pressure"),
    pressure_coefficient::constant("C2", "T/L", "factor of the speed"),
    pressure_coefficient::constant("C3", "L T/F", "factor of pressure times speed"),
    pressure_coefficient::constant("C4", "L^4/F^2", "factor of the pressure squared"),
    pressure_coefficient::constant("C5", "T^2/L^2", "factor of the speed squared"),
    pressure_coefficient::kArea,
    pressure_coefficient::kFloor};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const auto constants = pressure_coefficient::scalars<6>(values);
  return pressure_coefficient::evaluator(
      [constants](double pressure, double speed) {
        return coefficient(constants, pressure, speed);
      },
      values[6][0], values[7][0]);
}

inline constexpr ClosedForm kForm{
    .name = "generalized_viscous_coefficient",
    .title = "Coefficient quadratic in pressure and speed (Radioss, Ifric 1)",
    .formula = "mu = Fric + C1 p + C2 V + C3 p V + C4 p^2 + C5 V^2, p = N/A",
    .source = "Radioss reference guide, /FRICTION",
    .range = "N >= 0, A > 0; not below the floor",
    .parameters = kParameters,
    .inputs = pressure_coefficient::kInputs,
    .outputs = pressure_coefficient::kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::generalized_viscous
