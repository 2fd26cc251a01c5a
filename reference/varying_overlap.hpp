// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/helical_slip.hpp"

/// Contact force of a shaft that is drawn out of its bushing: the weight of the bending moment from
/// a table over the position, beside the true one.
///
/// Formula   F_N = sqrt(f2^2 + f3^2) + beta(x) sqrt(m2^2 + m3^2) + F_int. True weight 2/(L - x); a
///           table is linear between its points and held beyond, or extended straight.
/// Symbols   x position, 0 at the full overlap L [L], beta weight [1/L], f2, f3, m2, m3 reactions
///           [F, F L], F_int internal contact force [F].
/// Sign      the result is never negative.
/// Source    docs/theory, sections 4 and 6.
/// Range     table positions rising, weights >= 0; the true weight needs x < L. A table with few
///           points lies above the true weight in between, for 2/(L - x) is convex.
namespace slipbench::reference::varying_overlap {

/// The true weight of the bending moment [1/L] at the position x < L [L].
inline double true_weight(double overlap, double position) { return 2.0 / (overlap - position); }

/// The table's weight [1/L] at x [L]: linear between points (positions rising), beyond them held
/// or, if `extend`, continued straight and never below 0. One point is a constant.
inline double table_weight(std::span<const double> positions, std::span<const double> weights,
                           double position, bool extend) {
  if (positions.size() == 1) return weights[0];
  const double x = extend ? position : std::clamp(position, positions.front(), positions.back());
  std::size_t i = 1;
  while (i + 1 < positions.size() && x > positions[i]) ++i;
  const double part = (x - positions[i - 1]) / (positions[i] - positions[i - 1]);
  return std::max(weights[i - 1] + part * (weights[i] - weights[i - 1]), 0.0);
}

inline constexpr std::array kParameters{
    Parameter{.name = "overlap",
              .dimension = "L",
              .text = "overlap L at the position 0",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "positions",
              .dimension = "L",
              .text = "positions of the table, rising",
              .list = true},
    Parameter{.name = "weights",
              .dimension = "1/L",
              .text = "weights of the bending moment at these positions",
              .list = true,
              .lower = 0.0},
    Parameter{.name = "internal_contact_force",
              .dimension = "F",
              .text = "internal contact force",
              .default_value = 0.0,
              .lower = 0.0},
    Parameter{.name = "linear_extrapolation",
              .dimension = "1",
              .text = "1: the table goes on straight beyond its ends; 0: it is held",
              .default_value = 0.0,
              .lower = 0.0,
              .upper = 1.0}};
inline constexpr std::array kInputs{Signal{"position", "L", "position x, 0 at the full overlap"},
                                    helical_slip::kF2, helical_slip::kF3, helical_slip::kM2,
                                    helical_slip::kM3};
inline constexpr std::array kOutputs{
    Signal{"normal_force", "F", "normal force with the table's weight"},
    Signal{"true_normal_force", "F", "normal force with 2/(L - x); infinite without overlap"},
    Signal{"weight", "1/L", "the table's weight"},
    Signal{"true_weight", "1/L", "2/(L - x); infinite without overlap"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[1].size() != values[2].size()) {
    return "positions has " + std::to_string(values[1].size()) + " entries and weights " +
           std::to_string(values[2].size()) + "; they belong together";
  }
  for (std::size_t i = 1; i < values[1].size(); ++i) {
    if (!(values[1][i] > values[1][i - 1])) return "positions must rise from entry to entry";
  }
  if (values[4][0] != 0.0 && values[4][0] != 1.0) return "linear_extrapolation is 0 or 1";
  return std::nullopt;
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return
      [overlap = values[0][0], positions = values[1], weights = values[2], internal = values[3][0],
       extend = values[4][0] == 1.0](std::span<const double> inputs, std::span<double> outputs) {
        const double x = inputs[0];
        const double shear = std::hypot(inputs[1], inputs[2]);
        const double bending = std::hypot(inputs[3], inputs[4]);
        const double infinite = std::numeric_limits<double>::infinity();
        outputs[2] = table_weight(positions, weights, x, extend);
        outputs[3] = x < overlap ? true_weight(overlap, x) : infinite;
        outputs[0] = shear + outputs[2] * bending + internal;
        outputs[1] = bending == 0.0 ? shear + internal : shear + outputs[3] * bending + internal;
      };
}

inline constexpr ClosedForm kForm{
    .name = "contact_force_varying_overlap",
    .title = "Normal force of a shaft drawn out of its bushing: tabulated and true weight",
    .formula = "F_N = sqrt(f2^2 + f3^2) + beta(x) sqrt(m2^2 + m3^2) + F_int; true 2/(L - x)",
    .source = "docs/theory, sections 4 and 6",
    .range = "table positions rising; the true weight needs x < L",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::varying_overlap
