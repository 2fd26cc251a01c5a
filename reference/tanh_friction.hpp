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

/// Regularised Coulomb friction: a smooth function of the velocity that never sticks.
///
/// Formula   f = lim tanh(v/v_0), lim = mu N. A constant load P < lim makes it creep with v = v_0
///           atanh(P/lim), for ever.
/// Symbols   v velocity [L/T], v_0 regularisation velocity [L/T], f friction force [F], N normal
///           force [F], mu [1], P load [F].
/// Sign      f has the sign of the velocity it resists.
/// Source    textbook regularisation; creep derived in docs/theory.
/// Range     v_0 > 0, mu, N >= 0; creep for |P| < mu N only.
namespace slipbench::reference::tanh_friction {

struct Friction {
  double limit;                    ///< lim [F], >= 0
  double regularisation_velocity;  ///< v_0 [L/T], > 0
};

/// f [F] at the velocity v [L/T].
inline double force(const Friction& friction, double velocity) {
  return friction.limit * std::tanh(velocity / friction.regularisation_velocity);
}

/// Velocity [L/T] at which friction holds the load P [F]; infinite at the limit, NaN beyond.
inline double creep_velocity(const Friction& friction, double load) {
  return friction.regularisation_velocity * std::atanh(load / friction.limit);
}

inline constexpr Parameter kMu{
    .name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0};
inline constexpr Parameter kNormalForce{
    .name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0};
inline constexpr Parameter kRegularisationVelocity{
    .name = "regularisation_velocity",
    .dimension = "L/T",
    .text = "velocity at which the force is 76 % of its limit",
    .lower = 0.0,
    .lower_open = true};
inline constexpr std::array kParameters{kMu, kNormalForce, kRegularisationVelocity};
inline constexpr std::array kInputs{Signal{"velocity", "L/T", "relative velocity"}};
inline constexpr std::array kOutputs{Signal{"force", "F", "friction force"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Friction friction{values[0][0] * values[1][0], values[2][0]};
  return [friction](std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = force(friction, inputs[0]);
  };
}

inline constexpr ClosedForm kForm{.name = "tanh_friction",
                                  .title = "Regularised Coulomb friction",
                                  .formula = "f = mu N tanh(v/v_0)",
                                  .source = "textbook regularisation",
                                  .range = "v_0 > 0, mu, N >= 0; it never sticks",
                                  .parameters = kParameters,
                                  .inputs = kInputs,
                                  .outputs = kOutputs,
                                  .make = make,
                                  .violation = no_violation};

inline constexpr std::array kCreepParameters{
    kMu, kNormalForce, kRegularisationVelocity,
    Parameter{.name = "load",
              .dimension = "F",
              .text = "constant load, below the limit mu N in magnitude",
              .default_value = 0.0},
    kStartTime};
inline constexpr std::array kCreepInputs{
    Signal{"time", "T", "time; before the start there is no load"}};
inline constexpr std::array kCreepOutputs{Signal{"motion", "L", "creep since the start"},
                                          Signal{"velocity", "L/T", "creep velocity"}};

inline std::optional<std::string> creep_violation(std::span<const std::vector<double>> values) {
  if (std::abs(values[3][0]) < values[0][0] * values[1][0]) return std::nullopt;
  return "load must be below mu normal_force in magnitude, else there is no steady creep";
}

inline PathEvaluator make_creep(std::span<const std::vector<double>> values) {
  const Friction friction{values[0][0] * values[1][0], values[2][0]};
  return [velocity = creep_velocity(friction, values[3][0]), start_time = values[4][0]](
             std::span<const double> inputs, std::span<double> outputs) {
    outputs[0] = velocity * std::max(inputs[0] - start_time, 0.0);
    outputs[1] = inputs[0] < start_time ? 0.0 : velocity;
  };
}

inline constexpr ClosedForm kCreepForm{
    .name = "tanh_creep",
    .title = "Creep of regularised Coulomb friction under a constant load below the limit",
    .formula = "v = v_0 atanh(P/(mu N))",
    .source = "derived in docs/theory",
    .range = "|P| < mu N; quasi-static",
    .parameters = kCreepParameters,
    .inputs = kCreepInputs,
    .outputs = kCreepOutputs,
    .make = make_creep,
    .violation = creep_violation};

}  // namespace slipbench::reference::tanh_friction
