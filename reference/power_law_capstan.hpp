// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/closed_form.hpp"

/// Belt friction where the friction per length grows as a power of the pressure per length.
///
/// Formula   friction f' = a w^n, w = T/R, so dT/dalpha = a R^(1-n) T^n and
///           T_1^(1-n) = T_0^(1-n) +- (1-n) a R^(1-n) alpha; n -> 1 is the capstan with mu = a.
///           Apparent coefficient: ln(T_1/T_0)/alpha.
/// Symbols   T tensions [F], w normal force per length [F/L], a coefficient [(F/L)^(1-n)], n
///           exponent [1], R radius [L], alpha wrap angle [1].
/// Sign      rising with flow from a to c, falling with the opposite flow.
/// Source    Howell 1953 and 1954 (fibres); integrated in docs/theory.
/// Range     0 < n <= 1, a >= 0, R > 0, alpha > 0. With n < 1 a falling tension may end before the
///           angle does: then it is 0.
namespace slipbench::reference::power_law_capstan {

struct Guide {
  double coefficient;  ///< a [(F/L)^(1-n)], >= 0
  double exponent;     ///< n [1], in (0, 1]
  double radius;       ///< R [L], > 0
  double wrap_angle;   ///< alpha [1], > 0
};

/// ln(T_1/T_0) [1] for a tension T_0 > 0 [F] and the sense +1 (rising) or -1 (falling); -infinity
/// where the falling tension is used up. log1p keeps the digits as n tends to 1.
inline double log_ratio(const Guide& guide, double tension, double sense) {
  const double rest = 1.0 - guide.exponent;
  const double linear =
      sense * guide.coefficient * std::pow(guide.radius / tension, rest) * guide.wrap_angle;
  if (rest == 0.0) return linear;
  if (rest * linear <= -1.0) return -std::numeric_limits<double>::infinity();
  return std::log1p(rest * linear) / rest;
}

/// ln(T_1/T_0)/alpha [1] of the rising tension: the coefficient that the capstan law would take for
/// the cause.
inline double apparent_coefficient(const Guide& guide, double tension) {
  return log_ratio(guide, tension, 1.0) / guide.wrap_angle;
}

inline constexpr std::array kParameters{
    Parameter{.name = "coefficient",
              .dimension = "(F/L)^(1-n)",
              .text = "friction per length at unit pressure per length",
              .lower = 0.0},
    Parameter{.name = "exponent",
              .dimension = "1",
              .text = "power of the pressure per length; 1 is Coulomb's law",
              .lower = 0.0,
              .upper = 1.0,
              .lower_open = true},
    Parameter{.name = "radius",
              .dimension = "L",
              .text = "radius of the guide",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "wrap_angle",
              .dimension = "1",
              .text = "angle of contact in radians, of any size",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{capstan::kTension};
inline constexpr std::array kOutputs{
    Signal{"upper_limit", "F", "friction force f_bc - f_ab of slip from a to c"},
    Signal{"lower_limit", "F", "friction force of slip from c to a, not positive"},
    Signal{"rising_tension", "F", "tension on the c-side in slip from a to c"},
    Signal{"falling_tension", "F", "tension on the c-side in slip from c to a"},
    Signal{"apparent_coefficient", "1",
           "ln(T_1/T_0)/alpha of the rising tension; 0 for a slack belt"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Guide guide{values[0][0], values[1][0], values[2][0], values[3][0]};
  return [guide](std::span<const double> inputs, std::span<double> outputs) {
    const double tension = inputs[0];
    const bool taut = tension > 0.0;
    outputs[0] = taut ? tension * std::expm1(log_ratio(guide, tension, 1.0)) : 0.0;
    outputs[1] = taut ? tension * std::expm1(log_ratio(guide, tension, -1.0)) : 0.0;
    outputs[2] = tension + outputs[0];
    outputs[3] = tension + outputs[1];
    outputs[4] = taut ? apparent_coefficient(guide, tension) : 0.0;
  };
}

inline constexpr ClosedForm kForm{
    .name = "power_law_capstan",
    .title = "Belt friction with a pressure-dependent coefficient",
    .formula = "T_1^(1-n) = T_0^(1-n) +- (1-n) a R^(1-n) alpha",
    .source = "Howell 1953, 1954",
    .range = "0 < n <= 1, a >= 0, R > 0, alpha > 0; steady slip, each row by itself",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::power_law_capstan
