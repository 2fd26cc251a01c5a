// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Viscous penalty friction: a damper up to the friction limit, which never sticks.
///
/// Formula   f = min(C |v|, mu N) v/|v|, C = VISF^e sqrt(2 K m). A constant load P < mu N makes it
///           creep with v = P/C, for ever.
/// Symbols   v velocity [L/T], f friction force [F], C damping [F T/L], mu [1], N normal force [F],
///           P load [F], VISF damping factor [1], e its exponent [1]: 1 as documented, 1/2 as
///           OpenRadioss (2026) computes, K normal stiffness [F/L], m mass [F T^2/L].
/// Sign      f has the direction of the velocity it resists.
/// Source    Radioss reference guide, /FRICTION (Iform = 1); creep derived in docs/theory.
/// Range     C > 0, mu, N >= 0; each row by itself: it has no memory. Creep for |P| < mu N only.
namespace slipbench::reference::viscous_penalty {

/// Force [F] at the velocity v [L/T] for the damping [F T/L] and the limit mu N [F].
inline double force(double damping, double limit, double velocity) {
  return std::clamp(damping * velocity, -limit, limit);
}

/// The factor [F T/L] between force and velocity vector of the magnitude |v| [L/T].
inline double secant_damping(double damping, double limit, double speed) {
  return damping * speed > limit ? limit / speed : damping;
}

/// C [F T/L] of a normal stiffness [F/L] and a mass [F T^2/L].
inline double damping(double factor, double exponent, double normal_stiffness, double mass) {
  return std::pow(factor, exponent) * std::sqrt(2.0 * normal_stiffness * mass);
}

inline constexpr Parameter kMu{
    .name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0};
inline constexpr Parameter kDamping{.name = "damping",
                                    .dimension = "F T/L",
                                    .text = "friction force over velocity below the limit",
                                    .lower = 0.0,
                                    .lower_open = true};
inline constexpr std::array kParameters{kMu, kDamping};
inline constexpr std::array kInputs{Signal{"velocity", "L/T", "relative velocity"},
                                    Signal{"normal_force", "F", "normal force, not negative"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"speed_at_limit", "L/T", "speed at which the force meets its limit"},
    Signal{"creeps", "1", "1 below that speed, else 0"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return [mu = values[0][0], damping = values[1][0]](std::span<const double> inputs,
                                                     std::span<double> outputs) {
    const double limit = mu * inputs[1];
    outputs[0] = force(damping, limit, inputs[0]);
    outputs[1] = limit / damping;
    outputs[2] = damping * std::abs(inputs[0]) < limit ? 1.0 : 0.0;
  };
}

inline constexpr ClosedForm kForm{.name = "viscous_penalty",
                                  .title = "Viscous penalty friction in one direction",
                                  .formula = "f = min(C |v|, mu N) sign(v)",
                                  .source = "Radioss reference guide, /FRICTION",
                                  .range = "C > 0, mu, N >= 0; no memory, it never sticks",
                                  .parameters = kParameters,
                                  .inputs = kInputs,
                                  .outputs = kOutputs,
                                  .make = make,
                                  .violation = no_violation};

inline constexpr std::array kPlaneParameters{kDamping};
inline constexpr std::array kPlaneInputs{
    Signal{"velocity1", "L/T", "relative velocity, first direction"},
    Signal{"velocity2", "L/T", "relative velocity, second direction"},
    Signal{"normal_force", "F", "normal force, not negative"},
    Signal{"mu", "1", "friction coefficient"}};
inline constexpr std::array kPlaneOutputs{
    Signal{"force1", "F", "friction force, first direction"},
    Signal{"force2", "F", "friction force, second direction"},
    Signal{"magnitude", "F", "magnitude of the friction force"}};

inline PathEvaluator make_plane(std::span<const std::vector<double>> values) {
  return [damping = values[0][0]](std::span<const double> inputs, std::span<double> outputs) {
    const double speed = std::hypot(inputs[0], inputs[1]);
    const double secant = secant_damping(damping, inputs[3] * inputs[2], speed);
    outputs[0] = secant * inputs[0];
    outputs[1] = secant * inputs[1];
    outputs[2] = secant * speed;
  };
}

inline constexpr ClosedForm kPlaneForm{
    .name = "viscous_penalty_plane",
    .title = "Viscous penalty friction in two directions, any coefficient",
    .formula = "f = min(C |v|, mu N) v/|v|",
    .source = "Radioss reference guide, /FRICTION",
    .range = "C > 0, mu, N >= 0; no memory, it never sticks",
    .parameters = kPlaneParameters,
    .inputs = kPlaneInputs,
    .outputs = kPlaneOutputs,
    .make = make_plane,
    .violation = no_violation};

inline constexpr std::array kCreepParameters{
    kMu, Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    kDamping,
    Parameter{.name = "load",
              .dimension = "F",
              .text = "constant load, below the limit mu N in magnitude",
              .default_value = 0.0},
    kStartTime};
inline constexpr std::array kCreepInputs{
    Signal{"time", "T", "time; before the start there is no load"}};
inline constexpr std::array kCreepOutputs{Signal{"motion", "L", "creep since the start"},
                                          Signal{"velocity", "L/T", "creep velocity"},
                                          Signal{"dissipation", "F L", "load times creep"}};

inline std::optional<std::string> creep_violation(std::span<const std::vector<double>> values) {
  if (std::abs(values[3][0]) < values[0][0] * values[1][0]) return std::nullopt;
  return "load must be below mu normal_force in magnitude, else there is no steady creep";
}

inline PathEvaluator make_creep(std::span<const std::vector<double>> values) {
  return [velocity = values[3][0] / values[2][0], load = values[3][0], start_time = values[4][0]](
             std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = velocity * std::max(inputs[0] - start_time, 0.0);
    outputs[1] = inputs[0] < start_time ? 0.0 : velocity;
    outputs[2] = load * outputs[0];
  };
}

inline constexpr ClosedForm kCreepForm{
    .name = "viscous_penalty_creep",
    .title = "Creep of viscous penalty friction under a constant load below the limit",
    .formula = "v = P/C",
    .source = "derived in docs/theory",
    .range = "|P| < mu N; quasi-static",
    .parameters = kCreepParameters,
    .inputs = kCreepInputs,
    .outputs = kCreepOutputs,
    .make = make_creep,
    .violation = creep_violation};

inline constexpr std::array kDampingParameters{
    Parameter{.name = "mass",
              .dimension = "F T^2/L",
              .text = "mass that meets the contact",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "VISF",
              .dimension = "1",
              .text = "damping factor",
              .default_value = 1.0,
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "VISF_exponent",
              .dimension = "1",
              .text = "power of VISF: 1 as documented, 0.5 as OpenRadioss (2026) computes",
              .default_value = 1.0}};
inline constexpr std::array kDampingInputs{
    Signal{"normal_stiffness", "F/L", "normal stiffness of the contact"}};
inline constexpr std::array kDampingOutputs{
    Signal{"damping", "F T/L", "friction force over velocity below the limit"}};

inline PathEvaluator make_damping(std::span<const std::vector<double>> values) {
  return [mass = values[0][0], factor = values[1][0], exponent = values[2][0]](
             std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = damping(factor, exponent, inputs[0], mass);
  };
}

inline constexpr ClosedForm kDampingForm{
    .name = "viscous_penalty_damping",
    .title = "Damping of viscous penalty friction from stiffness and mass",
    .formula = "C = VISF sqrt(2 K m); as OpenRadioss (2026) computes: sqrt(VISF) sqrt(2 K m)",
    .source = "Radioss reference guide, /FRICTION",
    .range = "K >= 0, m, VISF > 0",
    .parameters = kDampingParameters,
    .inputs = kDampingInputs,
    .outputs = kDampingOutputs,
    .make = make_damping,
    .violation = no_violation};

}  // namespace slipbench::reference::viscous_penalty
