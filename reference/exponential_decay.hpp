// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Coefficient of friction that falls with the slip rate from a static to a kinetic value, from its
/// constants or from test data.
///
/// Formula   mu(v) = mu_k + (mu_s - mu_k) e^(-d |v|). Test data (0, mu1), (v2, mu2), mu_inf: mu_s =
///           mu1, mu_k = mu_inf, d = ln((mu1 - mu_inf)/(mu2 - mu_inf))/v2. Without mu_inf the ratio
///           (mu2 - mu_inf)/(mu1 - mu_inf) is taken as 5 %: mu_inf = (mu2 - 0.05 mu1)/0.95, d =
///           ln(20)/v2.
/// Symbols   v slip rate [L/T], mu coefficients [1], d decay coefficient [T/L].
/// Source    docs/theory, section 9. The 5 % are a convention.
/// Range     d >= 0; test data: v2 > 0 and mu_inf < mu2 < mu1.
namespace slipbench::reference::exponential_decay {

struct Decay {
  double static_coefficient;   ///< mu_s [1]
  double kinetic_coefficient;  ///< mu_k [1]
  double decay_coefficient;    ///< d [T/L]
};

/// mu at the slip rate v [L/T]; even in v.
inline double coefficient(const Decay& decay, double slip_rate) {
  return decay.kinetic_coefficient + (decay.static_coefficient - decay.kinetic_coefficient) *
                                         std::exp(-decay.decay_coefficient * std::abs(slip_rate));
}

/// The law through (0, mu1) and (v2, mu2) that tends to mu_inf: three points of test data.
inline Decay from_test_data(double static_coefficient, double test_coefficient,
                            double test_slip_rate, double infinite_rate_coefficient) {
  return {static_coefficient, infinite_rate_coefficient,
          std::log((static_coefficient - infinite_rate_coefficient) /
                   (test_coefficient - infinite_rate_coefficient)) /
              test_slip_rate};
}

/// The law through (0, mu1) and (v2, mu2) of which 5 % of the fall remain at v2: two points.
inline Decay from_test_data(double static_coefficient, double test_coefficient,
                            double test_slip_rate) {
  constexpr double kRemainder = 0.05;
  return {static_coefficient,
          (test_coefficient - kRemainder * static_coefficient) / (1.0 - kRemainder),
          -std::log(kRemainder) / test_slip_rate};
}

inline constexpr std::array kParameters{
    Parameter{.name = "static_coefficient",
              .dimension = "1",
              .text = "coefficient at slip rate 0",
              .lower = 0.0},
    Parameter{.name = "kinetic_coefficient",
              .dimension = "1",
              .text = "coefficient at infinite slip rate",
              .lower = 0.0},
    Parameter{.name = "decay_coefficient",
              .dimension = "T/L",
              .text = "inverse of the slip rate over which the difference falls to 1/e",
              .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"slip_rate", "L/T", "slip rate, of either sign"}};
inline constexpr std::array kOutputs{Signal{"coefficient", "1", "friction coefficient"}};

inline PathEvaluator evaluator(const Decay& decay) {
  return [decay](std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = coefficient(decay, inputs[0]);
  };
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return evaluator({values[0][0], values[1][0], values[2][0]});
}

inline constexpr ClosedForm kForm{
    .name = "exponential_decay",
    .title = "Coefficient that falls exponentially with the slip rate",
    .formula = "mu = mu_k + (mu_s - mu_k) e^(-d |v|)",
    .source = "docs/theory, section 9",
    .range = "d >= 0",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

inline constexpr std::array kTestDataParameters{
    Parameter{.name = "static_coefficient",
              .dimension = "1",
              .text = "mu1, measured at slip rate 0",
              .lower = 0.0},
    Parameter{.name = "test_coefficient",
              .dimension = "1",
              .text = "mu2, measured at the test's slip rate",
              .lower = 0.0},
    Parameter{.name = "test_slip_rate",
              .dimension = "L/T",
              .text = "slip rate of the second measurement",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "infinite_rate_coefficient",
              .dimension = "1",
              .text = "mu_inf, at infinite slip rate; if absent, 5 % of the fall remain at mu2",
              .default_value = std::numeric_limits<double>::infinity(),
              .lower = 0.0}};

inline Decay test_data_from(std::span<const std::vector<double>> values) {
  if (std::isinf(values[3][0])) {
    return from_test_data(values[0][0], values[1][0], values[2][0]);
  }
  return from_test_data(values[0][0], values[1][0], values[2][0], values[3][0]);
}

inline PathEvaluator make_from_test_data(std::span<const std::vector<double>> values) {
  return evaluator(test_data_from(values));
}

inline std::optional<std::string> test_data_violation(std::span<const std::vector<double>> values) {
  if (values[1][0] >= values[0][0]) {
    return "test_coefficient must be below static_coefficient";
  }
  if (!std::isinf(values[3][0]) && values[3][0] >= values[1][0]) {
    return "infinite_rate_coefficient must be below test_coefficient";
  }
  if (test_data_from(values).kinetic_coefficient < 0.0) {
    return "test_coefficient is below 5 % of static_coefficient: give infinite_rate_coefficient";
  }
  return std::nullopt;
}

inline constexpr ClosedForm kTestDataForm{
    .name = "exponential_decay_test_data",
    .title = "Exponentially falling coefficient through two or three points of test data",
    .formula = "d = ln((mu1 - mu_inf)/(mu2 - mu_inf))/v2; two points: mu_inf = (mu2 - mu1/20)/0.95",
    .source = "docs/theory, section 9",
    .range = "mu_inf < mu2 < mu1, v2 > 0",
    .parameters = kTestDataParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make_from_test_data,
    .violation = test_data_violation};

}  // namespace slipbench::reference::exponential_decay
