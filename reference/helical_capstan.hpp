// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "reference/capstan.hpp"
#include "reference/closed_form.hpp"

/// A belt wound as a helix around a cylinder.
///
/// Formula   T_2/T_1 = e^(mu theta cos psi): the path of length R theta/cos(psi) has the curvature
///           cos^2(psi)/R, and only the total turning of the tangent, theta cos(psi), counts.
/// Symbols   T tensions [F], mu coefficient [1], theta angle about the cylinder's axis [1], psi
///           helix angle between the belt and a circle around the cylinder [1].
/// Sign      see capstan: a-side first, rising with flow from a to c.
/// Source    any geodesic: Euler 1769 with the turning angle of the curve; non-circular guides:
///           Jayawardana 2020 (arXiv:2012.13353). docs/theory.
/// Range     mu, theta >= 0, 0 <= psi <= pi/2; the belt slips along its helix only. Bending
///           stiffness, which changes the law (arXiv:2205.04348), is left out.
namespace slipbench::reference::helical_capstan {

/// Total turning of the tangent of a helix [1].
inline double turning_angle(double wrap_angle, double helix_angle) {
  return wrap_angle * std::cos(helix_angle);
}

inline constexpr std::array kParameters{
    capstan::kMu,
    Parameter{.name = "wrap_angle",
              .dimension = "1",
              .text = "angle about the cylinder's axis in radians, of any size",
              .lower = 0.0},
    Parameter{.name = "helix_angle",
              .dimension = "1",
              .text = "angle between the belt and a circle around the cylinder, in radians",
              .lower = 0.0,
              .upper = 0.5 * std::numbers::pi}};
inline constexpr std::array kInputs{capstan::kTension};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const double exponent = values[0][0] * turning_angle(values[1][0], values[2][0]);
  return [exponent](std::span<const double> inputs, std::span<double> outputs) {
    capstan::write_band(exponent, inputs[0], 0.0, outputs);
  };
}

inline constexpr ClosedForm kForm{.name = "helical_capstan",
                                  .title = "A belt slipping along a helix around a cylinder",
                                  .formula = "T_2/T_1 = e^(mu theta cos psi)",
                                  .source = "Euler 1769 on a geodesic; derived in docs/theory",
                                  .range = "mu, theta >= 0; 0 <= psi <= pi/2",
                                  .parameters = kParameters,
                                  .inputs = kInputs,
                                  .outputs = capstan::kBandOutputs,
                                  .make = make,
                                  .violation = no_violation};

}  // namespace slipbench::reference::helical_capstan
