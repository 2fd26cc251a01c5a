// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Free vibration of a mass on a spring, damped by Coulomb friction; rigid stick.
///
/// Formula   In the half cycle n = floor(w t/pi): x = sign(x_0) (-1)^n [(a_n - F/k) cos(w t - n pi)
///           + F/k], a_n = |x_0| - 2 n F/k; at rest for good from the first n with a_n <= F/k.
/// Symbols   x motion from the relaxed spring [L], x_0 its start, released at rest, m mass [F
///           T^2/L], k spring [F/L], w = sqrt(k/m) [1/T], F = mu N friction force [F].
/// Sign      the friction force has the sign of the velocity it resists; at rest it is -k x.
/// Source    textbook result, derived in docs/theory; numbers: Ansys verification manual, VM73.
/// Range     m, k > 0, F >= 0, static and kinetic friction alike.
namespace slipbench::reference::coulomb_vibration {

struct Vibration {
  double mass;            ///< m [F T^2/L], > 0
  double stiffness;       ///< k [F/L], > 0
  double friction_force;  ///< F [F], >= 0
  double initial_motion;  ///< x_0 [L]
};

/// w = sqrt(k/m) [1/T]; friction does not change it.
inline double circular_frequency(const Vibration& vibration) {
  return std::sqrt(vibration.stiffness / vibration.mass);
}

/// a_n [L], the distance from the relaxed spring at the start of the half cycle n while it moves.
inline double amplitude(const Vibration& vibration, double half_cycles) {
  return std::abs(vibration.initial_motion) -
         2.0 * half_cycles * vibration.friction_force / vibration.stiffness;
}

/// The number of half cycles before the mass rests for good; infinite without friction.
inline double half_cycles_to_rest(const Vibration& vibration) {
  const double reach = vibration.friction_force / vibration.stiffness;
  if (std::abs(vibration.initial_motion) <= reach) return 0.0;
  return std::ceil(0.5 * (std::abs(vibration.initial_motion) / reach - 1.0));
}

struct State {
  double motion;            ///< x [L]
  double velocity;          ///< x' [L/T]
  double force;             ///< friction force [F]
  double accumulated_slip;  ///< distance gone [L]
};

/// The state at the time t >= 0 [T] after the release.
inline State at(const Vibration& vibration, double time) {
  const double w = circular_frequency(vibration);
  const double reach = vibration.friction_force / vibration.stiffness;
  const double last = half_cycles_to_rest(vibration);
  const double n = std::floor(w * time / std::numbers::pi);
  const double first = std::copysign(1.0, vibration.initial_motion);
  const auto side = [&](double half_cycles) {
    return std::fmod(half_cycles, 2.0) == 0.0 ? first : -first;
  };
  // Distance gone in whole half cycles: sum of 2 (a_i - F/k).
  const auto gone = [&](double half_cycles) {
    return 2.0 * half_cycles * (std::abs(vibration.initial_motion) - reach * half_cycles);
  };
  if (n >= last) {
    const double motion = side(last) * amplitude(vibration, last);
    return {motion, 0.0, -vibration.stiffness * motion, gone(last)};
  }
  const double angle = w * time - n * std::numbers::pi;
  const double swing = amplitude(vibration, n) - reach;
  return {side(n) * (swing * std::cos(angle) + reach), -side(n) * swing * w * std::sin(angle),
          -side(n) * vibration.friction_force, gone(n) + swing * (1.0 - std::cos(angle))};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mass",
              .dimension = "F T^2/L",
              .text = "mass, in units that fit force, length and time",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "stiffness",
              .dimension = "F/L",
              .text = "spring that holds the mass",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    Parameter{.name = "initial_motion",
              .dimension = "L",
              .text = "motion at the start, when the mass is released at rest"},
    kStartTime};
inline constexpr std::array kInputs{Signal{"time", "T", "time; before the start the mass is held"}};
inline constexpr std::array kOutputs{
    Signal{"motion", "L", "motion of the mass from the relaxed spring"},
    Signal{"velocity", "L/T", "velocity of the mass"},
    Signal{"force", "F", "friction force, of the velocity's sign"},
    Signal{"accumulated_slip", "L", "distance gone"},
    Signal{"dissipation", "F L", "friction force times the distance gone"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Vibration vibration{values[0][0], values[1][0], values[2][0] * values[3][0], values[4][0]};
  return [vibration, start_time = values[5][0]](std::span<const double> inputs,
                                                std::span<double> outputs) {
    const State state = at(vibration, std::max(inputs[0] - start_time, 0.0));
    outputs[0] = state.motion;
    outputs[1] = state.velocity;
    outputs[2] = state.force;
    outputs[3] = state.accumulated_slip;
    outputs[4] = vibration.friction_force * state.accumulated_slip;
  };
}

inline constexpr ClosedForm kForm{
    .name = "coulomb_vibration",
    .title = "Free vibration of a mass on a spring with Coulomb friction",
    .formula = "x = +-[(a_n - F/k) cos(w t - n pi) + F/k], a_n = |x_0| - 2 n F/k, F = mu N",
    .source = "derived in docs/theory; numbers: Ansys verification manual, VM73",
    .range = "m, k > 0; released at rest; static and kinetic friction alike",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::coulomb_vibration
