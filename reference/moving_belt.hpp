// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/closed_form.hpp"

/// A belt that runs over a pulley: part of its tension turns the belt's own mass and does not
/// press.
///
/// Formula   (T_1 - m v^2)/(T_2 - m v^2) = e^(mu alpha).
/// Symbols   T_1 >= T_2 tensions [F], m mass per length [F T^2/L^2], v speed [L/T], mu coefficient
///           [1], alpha wrap angle [1].
/// Sign      see capstan: a-side first, rising with slip from a to c.
/// Source    textbook belt drives; derived in docs/theory.
/// Range     mu, alpha, m >= 0; where T <= m v^2 the belt has left the pulley and both tensions are
///           equal.
namespace slipbench::reference::moving_belt {

/// The part of the tension that turns the belt, m v^2 [F].
inline double centrifugal_tension(double mass_per_length, double speed) {
  return mass_per_length * speed * speed;
}

/// The tension [F] on the far side of a belt that slips and carries m v^2 [F]; sense > 0: the
/// larger, sense < 0: the smaller one.
inline double far_tension(double exponent, double tension, double centrifugal, double sense) {
  const auto band = capstan::band(exponent, tension - centrifugal);
  return tension + (sense > 0.0 ? band.upper : band.lower);
}

inline constexpr std::array kParameters{capstan::kMu, capstan::kWrapAngle,
                                        Parameter{.name = "mass_per_length",
                                                  .dimension = "F T^2/L^2",
                                                  .text = "mass of the belt per length",
                                                  .lower = 0.0}};
inline constexpr std::array kInputs{capstan::kTension,
                                    Signal{"speed", "L/T", "speed of the belt, of either sign"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return [exponent = values[0][0] * values[1][0], mass = values[2][0]](
             std::span<const double> inputs, std::span<double> outputs) {
    capstan::write_band(exponent, inputs[0], centrifugal_tension(mass, inputs[1]), outputs);
  };
}

inline constexpr ClosedForm kForm{
    .name = "moving_belt",
    .title = "A running belt with mass slipping on its pulley",
    .formula = "(T_1 - m v^2)/(T_2 - m v^2) = e^(mu alpha)",
    .source = "textbook belt drives; derived in docs/theory",
    .range = "mu, alpha, m >= 0; steady speed; T <= m v^2: no contact, no friction",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = capstan::kBandOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::moving_belt
