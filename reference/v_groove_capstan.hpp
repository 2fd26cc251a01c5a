// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/closed_form.hpp"

/// A belt wedged into a V-shaped groove around a pulley.
///
/// Formula   T_2/T_1 = e^(mu' alpha), mu' = mu/sin(gamma/2): the two flanks together press 1/sin
///           (gamma/2) times as hard as a flat rim would.
/// Symbols   T tensions [F], mu coefficient [1], mu' apparent coefficient [1], alpha wrap angle
///           [1], gamma full angle between the flanks [1].
/// Sign      see capstan: a-side first, rising with flow from a to c.
/// Source    textbook belt drives; derived in docs/theory.
/// Range     mu, alpha >= 0, 0 < gamma <= pi; slip along the belt only, none into the groove.
namespace slipbench::reference::v_groove_capstan {

/// mu/sin(gamma/2) [1] for the full groove angle gamma [1]; gamma = pi is a flat rim.
inline double apparent_coefficient(double mu, double groove_angle) {
  return mu / std::sin(0.5 * groove_angle);
}

inline constexpr std::array kParameters{
    capstan::kMu, capstan::kWrapAngle,
    Parameter{.name = "groove_angle",
              .dimension = "1",
              .text = "full angle between the flanks in radians",
              .lower = 0.0,
              .upper = std::numbers::pi,
              .lower_open = true}};
inline constexpr std::array kInputs{capstan::kTension};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const double exponent = apparent_coefficient(values[0][0], values[2][0]) * values[1][0];
  return [exponent](std::span<const double> inputs, std::span<double> outputs) {
    capstan::write_band(exponent, inputs[0], 0.0, outputs);
  };
}

inline constexpr ClosedForm kForm{.name = "v_groove_capstan",
                                  .title = "A belt slipping in a V-shaped groove",
                                  .formula = "T_2/T_1 = e^(mu alpha/sin(gamma/2))",
                                  .source = "textbook belt drives; derived in docs/theory",
                                  .range = "mu, alpha >= 0; 0 < gamma <= pi, pi is a flat rim",
                                  .parameters = kParameters,
                                  .inputs = kInputs,
                                  .outputs = capstan::kBandOutputs,
                                  .make = make,
                                  .violation = no_violation};

}  // namespace slipbench::reference::v_groove_capstan
