// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// Stiffness penalty friction: a constant velocity from rest, and what the incremental form makes
/// of any history.
///
/// Formula   Ramp: f = min(K V t, mu N) with the sign of the velocity. Increments: f_n is the point
///           of the disc |f| <= mu N that lies closest to f_n-1 + K du; slip K ds = |f_n-1 + K du -
///           f_n|, dissipation f_n ds.
/// Symbols   f friction force [F], K tangential stiffness [F/L], V speed [L/T], t time since rest
///           [T], u motion [L], s accumulated slip [L], mu [1], N normal force [F].
/// Sign      f has the direction of the slip it resists.
/// Source    Radioss reference guide, /FRICTION (Iform = 2); ramp derived.
/// Range     K > 0, mu, N >= 0. Ramp: constant normal force, exact at any increment. Increments:
///           mu and N of the row's end; N = 0 forgets the force. As OpenRadioss (2026) computes, a
///           filter's smoothing factor a makes the stiffness a K.
namespace slipbench::reference::stiffness_penalty {

/// Slider with the tangential stiffness K [F/L] and the limit mu N [F].
struct Slider {
  double stiffness;
  double limit;
};

/// Friction force [F] after moving the distance V t >= 0 [L] from rest.
inline double ramp_force(const Slider& slider, double travel) {
  return std::min(slider.stiffness * travel, slider.limit);
}

/// A vector of the tangential plane: first direction real, second imaginary.
using Vector = std::complex<double>;

struct State {
  Vector motion;                  ///< u [L]
  Vector force;                   ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
  double dissipation = 0.0;       ///< [F L]
};

/// The state after one increment that ends at `motion` [L] under the limit of its end.
inline State increment(const Slider& slider, const State& begin, Vector motion) {
  const Vector trial = begin.force + slider.stiffness * (motion - begin.motion);
  const double excess = std::max(std::abs(trial) - slider.limit, 0.0);
  State end = begin;
  end.motion = motion;
  end.force = excess > 0.0 ? std::polar(slider.limit, std::arg(trial)) : trial;
  end.accumulated_slip += excess / slider.stiffness;
  end.dissipation += slider.limit * (excess / slider.stiffness);
  return end;
}

inline constexpr Parameter kStiffness{.name = "stiffness",
                                      .dimension = "F/L",
                                      .text = "tangential stiffness",
                                      .lower = 0.0,
                                      .lower_open = true};
inline constexpr std::array kRampParameters{
    kStiffness,
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    Parameter{.name = "velocity", .dimension = "L/T", .text = "constant, of either sign"},
    kStartTime};
inline constexpr std::array kRampInputs{
    Signal{"time", "T", "time; before the start the body is at rest"}};
inline constexpr std::array kRampOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"elastic_slip", "L", "force over stiffness"},
    Signal{"accumulated_slip", "L", "slip beyond the elastic one"},
    Signal{"dissipation", "F L", "limit times accumulated slip"},
    Signal{"stored_energy", "F L", "energy held by the stiffness"},
    Signal{"work", "F L", "dissipation and stored energy"}};

inline PathEvaluator make_ramp(std::span<const std::vector<double>> values) {
  const Slider slider{values[0][0], values[1][0] * values[2][0]};
  return [slider, velocity = values[3][0], start_time = values[4][0]](
             std::span<const double> inputs, std::span<double> outputs) {
    const double travel = std::abs(velocity) * std::max(inputs[0] - start_time, 0.0);
    const double magnitude = ramp_force(slider, travel);
    outputs[0] = std::copysign(magnitude, velocity);
    outputs[1] = outputs[0] / slider.stiffness;
    outputs[2] = std::max(travel - slider.limit / slider.stiffness, 0.0);
    outputs[3] = slider.limit * outputs[2];
    outputs[4] = 0.5 * magnitude * magnitude / slider.stiffness;
    outputs[5] = outputs[3] + outputs[4];
  };
}

inline constexpr ClosedForm kRampForm{
    .name = "stiffness_penalty_ramp",
    .title = "Stiffness penalty friction at a constant velocity from rest",
    .formula = "f = min(K |v| t, mu N) sign(v)",
    .source = "Radioss reference guide, /FRICTION; derived",
    .range = "K > 0, mu, N >= 0 constant; exact at any increment",
    .parameters = kRampParameters,
    .inputs = kRampInputs,
    .outputs = kRampOutputs,
    .make = make_ramp,
    .violation = no_violation};

inline constexpr std::array kIncrementsParameters{kStiffness};
inline constexpr std::array kIncrementsInputs{
    Signal{"motion1", "L", "relative motion, first direction"},
    Signal{"motion2", "L", "relative motion, second direction"},
    Signal{"normal_force", "F", "normal force at the row, not negative"},
    Signal{"mu", "1", "friction coefficient of the increment that ends at the row"}};
inline constexpr std::array kIncrementsOutputs{
    Signal{"force1", "F", "friction force, first direction"},
    Signal{"force2", "F", "friction force, second direction"},
    Signal{"magnitude", "F", "magnitude of the friction force"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "sum of limit times slip increment"}};

inline PathEvaluator make_increments(std::span<const std::vector<double>> values) {
  return [stiffness = values[0][0], state = State{}, started = false](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    const Vector motion{inputs[0], inputs[1]};
    if (started) {
      state = increment({stiffness, inputs[3] * inputs[2]}, state, motion);
    } else {
      state.motion = motion;
    }
    started = true;
    outputs[0] = state.force.real();
    outputs[1] = state.force.imag();
    outputs[2] = std::abs(state.force);
    outputs[3] = state.accumulated_slip;
    outputs[4] = state.dissipation;
  };
}

inline constexpr ClosedForm kIncrementsForm{
    .name = "stiffness_penalty_increments",
    .title = "What incremental stiffness penalty friction makes of the rows, in two directions",
    .formula = "f_n is the point of |f| <= mu N closest to f_n-1 + K du",
    .source = "Radioss reference guide, /FRICTION",
    .range = "K > 0, mu, N >= 0; rows are increments: the algorithm's answer, not physics",
    .parameters = kIncrementsParameters,
    .inputs = kIncrementsInputs,
    .outputs = kIncrementsOutputs,
    .make = make_increments,
    .violation = no_violation};

}  // namespace slipbench::reference::stiffness_penalty
