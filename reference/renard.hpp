// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Coefficient of friction that rises with the speed to a largest value, falls to a smallest one
/// and recovers.
///
/// Formula   V <= C5: mu = C3 - (C3 - C1)(1 - V/C5)^2, a parabola about its vertex.
///           C5 <= V <= C6: mu = C4 + (C3 - C4)(1 + 2 y)(1 - y)^2, y = (V - C5)/(C6 - C5).
///           V >= C6: mu = C2 - r, r = 1/(1/(C2 - C4) + s^2), s = V - C6; mu = C2 where C2 = C4.
///           Last slope: 2 s r^2.
/// Symbols   V = g |v| speed in the unit of C5 and C6, g the speed factor, v speed [L/T], mu [1];
///           C1 static, C2 dynamic, C3 largest, C4 smallest coefficient [1]; C5, C6 speeds of the
///           largest and the smallest.
/// Source    Radioss reference guide, /FRICTION, Ifric = 3; slopes derived.
/// Range     0 < C5 < C6, C4 <= C2. The last piece adds the square of a speed to a number without
///           dimension: it means the unit of C5 and C6, so g is 1 for a speed in that unit, 1e-3
///           for one in mm/s beside constants in m/s.
namespace slipbench::reference::renard {

/// C1 .. C6, and the factor g that leads from the speed given to the unit of C5 and C6.
struct Constants {
  double static_coefficient;    ///< C1 [1]
  double dynamic_coefficient;   ///< C2 [1]
  double largest_coefficient;   ///< C3 [1]
  double smallest_coefficient;  ///< C4 [1]
  double speed_of_largest;      ///< C5 > 0, in a unit of its own
  double speed_of_smallest;     ///< C6 > C5, in that unit
  double speed_factor = 1.0;    ///< g > 0
};

struct Coefficient {
  double value;  ///< mu [1]
  double slope;  ///< dmu/d|v| [T/L]
};

/// mu and its slope at the speed v [L/T], of either sign.
inline Coefficient coefficient(const Constants& c, double speed) {
  const double v = c.speed_factor * std::abs(speed);
  if (v <= c.speed_of_largest) {
    const double rise = c.largest_coefficient - c.static_coefficient;
    const double left = 1.0 - v / c.speed_of_largest;
    return {c.largest_coefficient - rise * left * left,
            c.speed_factor * 2.0 * rise * left / c.speed_of_largest};
  }
  if (v <= c.speed_of_smallest) {
    const double fall = c.largest_coefficient - c.smallest_coefficient;
    const double width = c.speed_of_smallest - c.speed_of_largest;
    const double y = (v - c.speed_of_largest) / width;
    const double left = 1.0 - y;
    return {c.smallest_coefficient + fall * (1.0 + 2.0 * y) * left * left,
            c.speed_factor * -6.0 * fall * y * left / width};
  }
  const double deficit = c.dynamic_coefficient - c.smallest_coefficient;
  if (deficit == 0.0) return {c.dynamic_coefficient, 0.0};
  const double beyond = v - c.speed_of_smallest;
  const double remainder = 1.0 / (1.0 / deficit + beyond * beyond);
  return {c.dynamic_coefficient - remainder, c.speed_factor * 2.0 * beyond * remainder * remainder};
}

/// The speed above C6, in the unit of C5 and C6, at which half of C2 - C4 is recovered; infinite
/// where there is nothing to recover.
inline double recovery_half_distance(const Constants& c) {
  return 1.0 / std::sqrt(c.dynamic_coefficient - c.smallest_coefficient);
}

inline constexpr std::array kParameters{
    Parameter{.name = "C1", .dimension = "1", .text = "coefficient at rest", .lower = 0.0},
    Parameter{.name = "C2", .dimension = "1", .text = "at infinite speed", .lower = 0.0},
    Parameter{.name = "C3", .dimension = "1", .text = "largest, at the speed C5", .lower = 0.0},
    Parameter{.name = "C4", .dimension = "1", .text = "smallest, at the speed C6", .lower = 0.0},
    Parameter{.name = "C5",
              .dimension = "L/T",
              .text = "speed of the largest coefficient, in the unit of the constants",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "C6",
              .dimension = "L/T",
              .text = "speed of the smallest coefficient, in the unit of the constants",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "speed_factor",
              .dimension = "1",
              .text = "speed in the unit of the constants over the speed given",
              .default_value = 1.0,
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{Signal{"speed", "L/T", "relative speed, of either sign"}};
inline constexpr std::array kOutputs{
    Signal{"coefficient", "1", "friction coefficient"},
    Signal{"slope", "T/L", "its derivative by the magnitude of the speed"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[4][0] >= values[5][0]) return "C5 must be below C6";
  if (values[3][0] > values[1][0]) return "C4 must not be above C2, else the last piece has a pole";
  return std::nullopt;
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Constants constants{values[0][0], values[1][0], values[2][0], values[3][0],
                            values[4][0], values[5][0], values[6][0]};
  return [constants](std::span<const double> inputs, std::span<double> outputs) {
    const Coefficient mu = coefficient(constants, inputs[0]);
    outputs[0] = mu.value;
    outputs[1] = mu.slope;
  };
}

inline constexpr ClosedForm kForm{
    .name = "renard_coefficient",
    .title = "Coefficient that rises, falls and recovers with the speed (Radioss, Ifric 3)",
    .formula = "parabola C1 to C3 at C5, cubic to C4 at C6, then C2 - 1/(1/(C2-C4) + (V-C6)^2)",
    .source = "Radioss reference guide, /FRICTION",
    .range = "0 < C5 < C6, C4 <= C2; the last piece means the unit of C5 and C6",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::renard
