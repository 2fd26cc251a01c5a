// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "reference/closed_form.hpp"

/// Common parts of the coefficients that depend on contact pressure and speed: what drives
/// them, what they answer and the floor under them.
///
/// Formula   p = N/A; coefficient = max(mu(p, |v|), floor).
/// Symbols   N normal force [F], A area [L^2], p contact pressure [F/L^2], v speed [L/T], mu [1].
/// Source    Radioss reference guide, /FRICTION.
/// Range     N >= 0, A > 0; each row by itself.
namespace slipbench::reference::pressure_coefficient {

/// mu before the floor and its slopes.
struct Coefficient {
  double value;           ///< mu [1], of either sign
  double speed_slope;     ///< dmu/dV [T/L]
  double pressure_slope;  ///< dmu/dp [L^2/F]
};

inline constexpr Parameter kFric{.name = "Fric",
                                 .dimension = "1",
                                 .text = "constant part of the coefficient",
                                 .default_value = 0.0};
inline constexpr Parameter kArea{.name = "area",
                                 .dimension = "L^2",
                                 .text = "area A that the normal force presses on",
                                 .default_value = 1.0,
                                 .lower = 0.0,
                                 .lower_open = true};
inline constexpr Parameter kFloor{.name = "floor",
                                  .dimension = "1",
                                  .text = "smallest coefficient",
                                  .default_value = 1e-30,
                                  .lower = 0.0};

/// A constant of the formula that is absent unless given.
constexpr Parameter constant(std::string_view name, std::string_view dimension,
                             std::string_view text) {
  return {.name = name, .dimension = dimension, .text = text, .default_value = 0.0};
}

inline constexpr std::array kInputs{Signal{"speed", "L/T", "relative speed, of either sign"},
                                    Signal{"normal_force", "F", "normal force, not negative"}};
inline constexpr std::array kOutputs{
    Signal{"coefficient", "1", "friction coefficient, not below the floor"},
    Signal{"unclamped_coefficient", "1", "the formula's value, of either sign"},
    Signal{"speed_slope", "T/L", "the formula's derivative by the magnitude of the speed"},
    Signal{"pressure_slope", "L^2/F", "the formula's derivative by the pressure"}};

/// Evaluator of a formula mu(p, V) -> Coefficient over an area [L^2] with a floor [1].
template <class Formula>
PathEvaluator evaluator(Formula formula, double area, double floor) {
  return [=](std::span<const double> inputs, std::span<double> outputs) {
    const Coefficient mu = formula(inputs[1] / area, std::abs(inputs[0]));
    outputs[0] = std::max(mu.value, floor);
    outputs[1] = mu.value;
    outputs[2] = mu.speed_slope;
    outputs[3] = mu.pressure_slope;
  };
}

/// The first N parameter values, each a scalar.
template <std::size_t N>
std::array<double, N> scalars(std::span<const std::vector<double>> values) {
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = values[i][0];
  return result;
}

}  // namespace slipbench::reference::pressure_coefficient
