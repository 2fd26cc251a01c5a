// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/pressure_coefficient.hpp"

/// Coefficient of friction that is quadratic in the contact pressure, each power with an
/// exponential of the speed of its own.
///
/// Formula   mu = Fric + C1 e^(C2 V) p^2 + C3 e^(C4 V) p + C5 e^(C6 V), here nested in p.
/// Symbols   p contact pressure [F/L^2], V = |v| speed [L/T], mu [1]; C1 [L^4/F^2], C3 [L^2/F],
///           C5 [1]; C2, C4, C6 [T/L].
/// Source    Radioss reference guide, /FRICTION, Ifric = 2.
/// Range     any constants whose exponentials do not overflow; C1 = C3 = 0 is a decay with the
///           speed from Fric + C5 to Fric, of the rate -C6.
namespace slipbench::reference::modified_darmstad {

using pressure_coefficient::Coefficient;

/// Fric, C1 .. C6, in the units above.
using Constants = std::array<double, 7>;

/// mu and its slopes at the pressure p [F/L^2] and the speed V >= 0 [L/T].
inline Coefficient coefficient(const Constants& c, double pressure, double speed) {
  const double quadratic = c[1] * std::exp(c[2] * speed);
  const double linear = c[3] * std::exp(c[4] * speed);
  const double constant = c[5] * std::exp(c[6] * speed);
  return {c[0] + constant + pressure * (linear + pressure * quadratic),
          c[6] * constant + pressure * (c[4] * linear + pressure * (c[2] * quadratic)),
          linear + 2.0 * pressure * quadratic};
}

inline constexpr std::array kParameters{
    pressure_coefficient::kFric,
    pressure_coefficient::constant("C1", "L^4/F^2", "factor of the pressure squared"),
    pressure_coefficient::constant("C2", "T/L", "rate of its exponential"),
    pressure_coefficient::constant("C3", "L^2/F", "factor of the pressure"),
    pressure_coefficient::constant("C4", "T/L", "rate of its exponential"),
    pressure_coefficient::constant("C5", "1", "factor of the part without pressure"),
    pressure_coefficient::constant("C6", "T/L", "rate of its exponential"),
    pressure_coefficient::kArea,
    pressure_coefficient::kFloor};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const auto constants = pressure_coefficient::scalars<7>(values);
  return pressure_coefficient::evaluator(
      [constants](double pressure, double speed) {
        return coefficient(constants, pressure, speed);
      },
      values[7][0], values[8][0]);
}

inline constexpr ClosedForm kForm{
    .name = "modified_darmstad_coefficient",
    .title = "Coefficient quadratic in pressure, exponential in speed (Radioss, Ifric 2)",
    .formula = "mu = Fric + C1 e^(C2 V) p^2 + C3 e^(C4 V) p + C5 e^(C6 V), p = N/A",
    .source = "Radioss reference guide, /FRICTION",
    .range = "N >= 0, A > 0; C2 V, C4 V, C6 V below 700; not below the floor",
    .parameters = kParameters,
    .inputs = pressure_coefficient::kInputs,
    .outputs = pressure_coefficient::kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::modified_darmstad
