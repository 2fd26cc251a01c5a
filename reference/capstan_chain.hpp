// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/closed_form.hpp"

/// A belt that slips over several guides one after the other, all in one direction of flow.
///
/// Formula   T_n = T_0 e^(+-(mu_1 alpha_1 + ... + mu_n alpha_n)).
/// Symbols   T_0 tension of the first segment [F], T_n behind the n-th guide [F], mu_i coefficients
///           [1], alpha_i wrap angles [1].
/// Sign      rising along the flow, falling against it.
/// Source    Euler 1769; Eytelwein 1808, applied guide by guide.
/// Range     mu_i, alpha_i >= 0; a slack belt (T_0 <= 0) keeps its tension. With one coefficient
///           only the sum of the angles counts.
namespace slipbench::reference::capstan_chain {

struct Guide {
  double mu;          ///< [1], >= 0
  double wrap_angle;  ///< [1], >= 0
};

/// The sum of mu alpha [1] over the guides.
inline double exponent(std::span<const Guide> guides) {
  double sum = 0.0;
  for (const Guide& guide : guides) sum += guide.mu * guide.wrap_angle;
  return sum;
}

/// The tension [F] behind each guide, guide by guide, for a tension [F] of the first segment;
/// sense > 0: the tensions rise (flow away from the first segment), sense < 0: they fall.
inline std::vector<double> tensions(std::span<const Guide> guides, double tension, double sense) {
  std::vector<double> result;
  for (const Guide& guide : guides) {
    const auto band = capstan::band(guide.mu * guide.wrap_angle, tension);
    tension += sense > 0.0 ? band.upper : band.lower;
    result.push_back(tension);
  }
  return result;
}

inline constexpr std::array kParameters{Parameter{.name = "mu",
                                                  .dimension = "1",
                                                  .text = "friction coefficient of each guide",
                                                  .list = true,
                                                  .lower = 0.0},
                                        Parameter{.name = "wrap_angle",
                                                  .dimension = "1",
                                                  .text = "wrap angle of each guide in radians",
                                                  .list = true,
                                                  .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"tension", "F", "tension of the first segment"}};
inline constexpr std::array kOutputs{
    Signal{"upper_limit", "F", "last tension less the first, flow towards the last"},
    Signal{"lower_limit", "F", "last tension less the first, flow towards the first"},
    Signal{"rising_tension", "F", "tension behind the last guide, flow towards it"},
    Signal{"falling_tension", "F", "tension behind the last guide, flow away from it"},
    Signal{"exponent", "1", "sum of mu alpha over the guides"}};

inline std::vector<Guide> guides(std::span<const std::vector<double>> values) {
  std::vector<Guide> result;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    result.push_back({values[0][i], values[1][i]});
  }
  return result;
}

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[0].size() == values[1].size()) return std::nullopt;
  return "mu has " + std::to_string(values[0].size()) + " entries and wrap_angle " +
         std::to_string(values[1].size()) + "; every guide needs both";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const double sum = exponent(guides(values));
  return [sum](std::span<const double> inputs, std::span<double> outputs) {
    capstan::write_band(sum, inputs[0], 0.0, outputs);
  };
}

inline constexpr ClosedForm kForm{
    .name = "capstan_chain",
    .title = "A belt slipping over several guides",
    .formula = "T_n = T_0 e^(+-(mu_1 alpha_1 + ... + mu_n alpha_n))",
    .source = "Euler 1769; Eytelwein 1808",
    .range = "mu_i, alpha_i >= 0; all guides slip in one direction of flow",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::capstan_chain
