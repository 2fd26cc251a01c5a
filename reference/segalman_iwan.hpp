// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/masing.hpp"

/// Segalman's four-parameter Iwan model of a joint.
///
/// Formula   Sliders of unit stiffness with the density rho(phi) = R phi^chi on [0, phi_max] and a
///           delta of strength S at phi_max:
///           F_b(u) = R u^(chi+2)/(chi+2) + u [R (phi_max^(chi+1) - u^(chi+1))/(chi+1) + S],
///           E(A) = 4 R A^(chi+3)/((chi+2)(chi+3)) up to A = phi_max, then 4 F_S more per L. After
///           a reversal Masing's rule.
/// Symbols   u motion and phi yield motion [L], R [F/L^(2+chi)], S [F/L], chi exponent [1], F_S =
///           F_b(phi_max) [F].
/// Sign      forces have the sign of the slip they resist.
/// Source    Segalman 2005; branches after a reversal: Masing 1926.
/// Range     -1 < chi, R >= 0, S >= 0, phi_max > 0; exact on piecewise-linear paths whose turning
///           points are rows.
namespace slipbench::reference::segalman_iwan {

struct Joint {
  double density;         ///< R [F/L^(2+chi)]
  double exponent;        ///< chi [1], > -1
  double maximum_motion;  ///< phi_max [L], the motion at which everything slips
  double end_stiffness;   ///< S [F/L]
};

/// Stiffness while nothing slips, R phi_max^(chi+1)/(chi+1) + S [F/L].
inline double initial_stiffness(const Joint& joint) {
  const double order = joint.exponent + 1.0;
  return joint.density * std::pow(joint.maximum_motion, order) / order + joint.end_stiffness;
}

/// Force on first loading [F]; odd in the motion [L] and constant beyond phi_max.
inline double backbone(const Joint& joint, double motion) {
  const double u = std::min(std::abs(motion), joint.maximum_motion);
  const double order = joint.exponent + 1.0;
  const double slipping = joint.density * std::pow(u, order + 1.0) / (order + 1.0);
  const double sticking =
      joint.density * (std::pow(joint.maximum_motion, order) - std::pow(u, order)) / order;
  return std::copysign(slipping + u * (sticking + joint.end_stiffness), motion);
}

/// Force once everything slips [F].
inline double slip_force(const Joint& joint) { return backbone(joint, joint.maximum_motion); }

/// Integral of the backbone from 0 [F L]; even: K_T u^2/2 - R |u|^(chi+3)/((chi+1)(chi+2)(chi+3))
/// with the initial stiffness K_T, linear beyond phi_max.
inline double backbone_work(const Joint& joint, double motion) {
  const double u = std::min(std::abs(motion), joint.maximum_motion);
  const double chi = joint.exponent;
  const double lost =
      joint.density * std::pow(u, chi + 3.0) / ((chi + 1.0) * (chi + 2.0) * (chi + 3.0));
  return 0.5 * initial_stiffness(joint) * u * u - lost + slip_force(joint) * (std::abs(motion) - u);
}

/// Energy of one closed loop of amplitude A >= 0 [F L].
inline double loop_energy(const Joint& joint, double amplitude) {
  const double chi = joint.exponent;
  const double a = std::min(amplitude, joint.maximum_motion);
  return 4.0 * joint.density * std::pow(a, chi + 3.0) / ((chi + 2.0) * (chi + 3.0)) +
         4.0 * slip_force(joint) * (amplitude - a);
}

inline constexpr std::array kParameters{
    Parameter{.name = "density",
              .dimension = "F/L^(2+chi)",
              .text = "factor R of the density of sliders over their yield motion",
              .lower = 0.0},
    Parameter{.name = "exponent",
              .dimension = "1",
              .text = "exponent chi of the density; the loop energy grows as A^(chi+3)",
              .lower = -1.0,
              .lower_open = true},
    Parameter{.name = "maximum_motion",
              .dimension = "L",
              .text = "motion phi_max at which everything slips",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "end_stiffness",
              .dimension = "F/L",
              .text = "stiffness S of the sliders that all yield at phi_max",
              .default_value = 0.0,
              .lower = 0.0}};
inline constexpr std::array kInputs{Signal{"motion", "L", "relative motion of the joint"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"dissipation", "F L", "energy dissipated by the sliders"},
    Signal{"stored_energy", "F L", "work less dissipation"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return masing::evaluator(Joint{values[0][0], values[1][0], values[2][0], values[3][0]});
}

inline constexpr ClosedForm kForm{
    .name = "segalman_iwan",
    .title = "Segalman's four-parameter Iwan joint, Masing branches",
    .formula = "F_b = R u^(chi+2)/(chi+2) + u [R (phi_max^(chi+1) - u^(chi+1))/(chi+1) + S]",
    .source = "Segalman 2005; Masing 1926",
    .range = "chi > -1, R, S >= 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::segalman_iwan
