// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/masing.hpp"

/// Iwan's continuum of sliders whose elements share the stiffness evenly and yield evenly between
/// the motions 0 and 2 f_y/k.
///
/// Formula   F_b(u) = k u - k^2 u^2/(4 f_y) up to u = 2 f_y/k, then f_y; after a reversal Masing's
///           rule. Loop: E = k^2 A^3/(3 f_y) up to A = 2 f_y/k, then 4 f_y A - 16 f_y^2/(3 k).
/// Symbols   u motion [L], k stiffness while nothing slips [F/L], f_y force once everything slips
///           [F], A amplitude [L], E [F L].
/// Sign      forces have the sign of the slip they resist.
/// Source    Iwan 1966; branches: Masing 1926.
/// Range     k > 0, f_y > 0; exact on piecewise-linear paths whose turning points are rows. n equal
///           sliders approach it as 1/n^2.
namespace slipbench::reference::iwan_uniform {

struct Joint {
  double initial_stiffness;  ///< k [F/L], > 0
  double yield_force;        ///< f_y [F], > 0
};

/// The motion at which everything slips, 2 f_y/k [L].
inline double yield_motion(const Joint& joint) {
  return 2.0 * joint.yield_force / joint.initial_stiffness;
}

/// Force on first loading [F]; odd.
inline double backbone(const Joint& joint, double motion) {
  const double u = std::abs(motion);
  const double k = joint.initial_stiffness;
  const double fy = joint.yield_force;
  const double force = u < yield_motion(joint) ? k * u * (1.0 - k * u / (4.0 * fy)) : fy;
  return std::copysign(force, motion);
}

/// Integral of the backbone from 0 [F L]; even: k u^2/2 - k^2 |u|^3/(12 f_y), linear beyond yield.
inline double backbone_work(const Joint& joint, double motion) {
  const double u = std::abs(motion);
  const double k = joint.initial_stiffness;
  const double fy = joint.yield_force;
  if (u < yield_motion(joint)) return k * u * u * (0.5 - k * u / (12.0 * fy));
  return 4.0 * fy * fy / (3.0 * k) + fy * (u - yield_motion(joint));
}

/// Energy of one closed loop of amplitude A >= 0 [F L].
inline double loop_energy(const Joint& joint, double amplitude) {
  const double k = joint.initial_stiffness;
  const double fy = joint.yield_force;
  if (amplitude < yield_motion(joint)) {
    return k * k * amplitude * amplitude * amplitude / (3.0 * fy);
  }
  return 4.0 * fy * amplitude - 16.0 * fy * fy / (3.0 * k);
}

inline constexpr std::array kParameters{Parameter{.name = "initial_stiffness",
                                                  .dimension = "F/L",
                                                  .text = "stiffness while nothing slips",
                                                  .lower = 0.0,
                                                  .lower_open = true},
                                        Parameter{.name = "yield_force",
                                                  .dimension = "F",
                                                  .text = "force once everything slips",
                                                  .lower = 0.0,
                                                  .lower_open = true}};
inline constexpr std::array kInputs{Signal{"motion", "L", "relative motion of the joint"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"dissipation", "F L", "energy dissipated by the sliders"},
    Signal{"stored_energy", "F L", "work less dissipation"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return masing::evaluator(Joint{values[0][0], values[1][0]});
}

inline constexpr ClosedForm kForm{
    .name = "iwan_uniform",
    .title = "Iwan's joint with evenly distributed yield forces, Masing branches",
    .formula = "F_b = k u - k^2 u^2/(4 f_y) up to u = 2 f_y/k, then f_y; F = F_r -+ 2 F_b(|du|/2)",
    .source = "Iwan 1966; Masing 1926",
    .range = "k > 0, f_y > 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::iwan_uniform
