// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Coefficient of friction that falls from rest to sliding and rises with the speed.
///
/// Formula   mu = mu_c + (mu_s - mu_c) w + c |v|, w = exp(-(|v|/V_s)^delta);
///           dmu/d|v| = c - (mu_s - mu_c) w delta (|v|/V_s)^delta / |v|.
/// Symbols   v speed [L/T], mu [1]; mu_s static, mu_c kinetic coefficient [1]; V_s Stribeck
///           velocity [L/T]; delta shape [1]; c viscous part [T/L].
/// Source    Armstrong-Helouvry, Dupont, Canudas de Wit 1994, the general kinetic friction model;
///           slope derived.
/// Range     mu_s >= mu_c, V_s > 0, delta >= 1.
namespace slipbench::reference::stribeck {

inline constexpr std::array kParameters{
    Parameter{.name = "static", .dimension = "1", .text = "coefficient at rest", .lower = 0.0},
    Parameter{.name = "kinetic", .dimension = "1", .text = "coefficient of sliding", .lower = 0.0},
    Parameter{.name = "stribeck_rate",
              .dimension = "L/T",
              .text = "speed at which 1/e of static - kinetic is left",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "exponent",
              .dimension = "1",
              .text = "shape of the fall",
              .default_value = 2.0,
              .lower = 1.0},
    Parameter{.name = "viscous",
              .dimension = "T/L",
              .text = "growth with the speed",
              .default_value = 0.0}};
inline constexpr std::array kInputs{Signal{"speed", "L/T", "relative speed, of either sign"}};
inline constexpr std::array kOutputs{
    Signal{"coefficient", "1", "friction coefficient"},
    Signal{"slope", "T/L", "its derivative by the magnitude of the speed"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[0][0] < values[1][0]) return "static must not be below kinetic";
  return std::nullopt;
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const double at_rest = values[0][0], sliding = values[1][0], velocity = values[2][0];
  const double delta = values[3][0], growth = values[4][0];
  return [=](std::span<const double> inputs, std::span<double> outputs) {
    const double speed = std::abs(inputs[0]);
    const double excess = (at_rest - sliding) * std::exp(-std::pow(speed / velocity, delta));
    outputs[0] = sliding + excess + growth * speed;
    outputs[1] = growth - excess * delta / velocity * std::pow(speed / velocity, delta - 1.0);
  };
}

inline constexpr ClosedForm kForm{
    .name = "stribeck_coefficient",
    .title = "Coefficient that falls from rest to sliding and rises with the speed (Stribeck)",
    .formula = "kinetic + (static - kinetic) exp(-(|v|/stribeck_rate)^exponent) + viscous |v|",
    .source = "Armstrong-Helouvry, Dupont and Canudas de Wit 1994",
    .range = "static >= kinetic, exponent >= 1",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::stribeck
