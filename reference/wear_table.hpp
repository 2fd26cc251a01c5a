// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Internal contact force from a table over accumulated slip and temperature.
///
/// Formula   linear over the slip within each temperature, then linear over the temperature; beyond
///           the first and the last value of either, the value there.
/// Symbols   s accumulated slip [L], T temperature, F_int internal contact force [F].
/// Source    docs/theory, section 9.1.
/// Range     slips and temperatures rise strictly; as many forces as slips times temperatures,
///           all slips of the first temperature first.
namespace slipbench::reference::wear_table {

/// Linear interpolation of y over the rising x, held beyond the ends.
inline double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

/// F_int(s, T) [F]; `forces` holds all slips of the first temperature, then of the second, ...
inline double internal_contact_force(std::span<const double> slips,
                                     std::span<const double> temperatures,
                                     std::span<const double> forces, double slip,
                                     double temperature) {
  std::vector<double> at_slip;
  for (std::size_t i = 0; i < temperatures.size(); ++i) {
    at_slip.push_back(interpolate(slips, forces.subspan(i * slips.size(), slips.size()), slip));
  }
  return interpolate(temperatures, at_slip, temperature);
}

inline constexpr std::array kParameters{
    Parameter{.name = "slips",
              .dimension = "L",
              .text = "accumulated slips of the table, rising",
              .list = true,
              .lower = 0.0},
    Parameter{.name = "temperatures",
              .dimension = "1",
              .text = "temperatures of the table, rising",
              .list = true},
    Parameter{.name = "internal_contact_forces",
              .dimension = "F",
              .text = "one for each slip at the first temperature, then at the second, ...",
              .list = true,
              .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"accumulated_slip", "L", "accumulated slip"},
                                    Signal{"temperature", "1", "temperature"}};
inline constexpr std::array kOutputs{
    Signal{"internal_contact_force", "F", "internal contact force"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  for (const std::size_t i : {0u, 1u}) {
    const std::string name(kParameters[i].name);
    if (values[i].empty()) return name + " needs at least one entry";
    if (std::adjacent_find(values[i].begin(), values[i].end(),
                           [](double a, double b) { return !(a < b); }) != values[i].end()) {
      return name + " must rise from entry to entry";
    }
  }
  const std::size_t cells = values[0].size() * values[1].size();
  if (values[2].size() == cells) return std::nullopt;
  return "internal_contact_forces has " + std::to_string(values[2].size()) +
         " entries; slips times temperatures make " + std::to_string(cells);
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return [slips = values[0], temperatures = values[1], forces = values[2]](
             std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = internal_contact_force(slips, temperatures, forces, inputs[0], inputs[1]);
  };
}

inline constexpr ClosedForm kForm{
    .name = "wear_table",
    .title = "Internal contact force from a table over accumulated slip and temperature",
    .formula = "linear over slip within each temperature, then over temperature; ends held",
    .source = "docs/theory, section 9.1",
    .range = "rising slips and temperatures; forces of the first temperature first",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::wear_table
