// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/exponential_decay.hpp"

/// Saw-tooth of a steady pull on a stick stiffness and a coefficient that falls with the slip rate:
/// a saw-tooth in the limit of short increments, a smooth answer for long ones, and the threshold.
///
/// Formula   Saw-tooth: |f| rises with k to mu_s N, then drops to mu_k N at once; the next drop is
///           due after the travel (mu_s - mu_k) N/k. Smooth: f = N mu(v). Backward Euler over dt
///           keeps the smooth answer only if dt > 2 N (mu_s - mu_k) d e^(-d v)/k; several roots
///           coexist if dt < N (mu_s - mu_k) d/k.
/// Symbols   f force [F], N normal force [F], k stick stiffness [F/L], mu_s, mu_k coefficients at
///           rest and at speed [1], d decay coefficient [T/L], v speed of the pull [L/T], dt [T].
/// Sign      f has the sign of the slip it resists.
/// Source    derived in docs/theory.
/// Range     k > 0, N >= 0, mu_s > mu_k, d > 0; the saw-tooth is the limit dt -> 0 and does not
///           depend on d and v.
namespace slipbench::reference::static_kinetic_sawtooth {

using exponential_decay::Decay;

struct Slider {
  Decay decay;
  double normal_force;     ///< N [F]
  double stick_stiffness;  ///< k [F/L]
};

/// Drop of the force, (mu_s - mu_k) N [F].
inline double drop(const Slider& slider) {
  return (slider.decay.static_coefficient - slider.decay.kinetic_coefficient) * slider.normal_force;
}

/// Travel from one drop to the next [L].
inline double drop_travel(const Slider& slider) { return drop(slider) / slider.stick_stiffness; }

/// Time from one drop to the next at the speed v > 0 [T].
inline double period(const Slider& slider, double speed) { return drop_travel(slider) / speed; }

/// Force [F] of steady slip at the speed v [L/T].
inline double smooth_force(const Slider& slider, double speed) {
  return slider.normal_force * exponential_decay::coefficient(slider.decay, speed);
}

/// The increment [T] above which backward Euler settles on the smooth force at the speed v: its
/// answer f_n+1(f_n) then has a slope between -1 and 1 there.
inline double smallest_increment(const Slider& slider, double speed) {
  return 2.0 * drop_travel(slider) * slider.decay.decay_coefficient *
         std::exp(-slider.decay.decay_coefficient * std::abs(speed));
}

/// The increment [T] below which an increment may have several answers.
inline double coexistence_increment(const Slider& slider) {
  return drop_travel(slider) * slider.decay.decay_coefficient;
}

/// One backward-Euler increment over the travel du [L] in the time dt > 0 [T]: stick if the
/// predictor is within mu_s N, else |f| = N mu(ds/dt), whose slip is unique then.
///
/// With the predictor beyond mu_s N the residual |f_tr| - k ds - N mu(ds/dt) is concave and
/// positive at ds = 0: it has one root, and Newton's iteration from the right comes down to it.
inline double backward_euler(const Slider& slider, double force, double travel, double increment) {
  const double k = slider.stick_stiffness;
  const double predictor = std::abs(force + k * travel);
  const double static_limit = slider.normal_force * slider.decay.static_coefficient;
  if (predictor <= static_limit) return force + k * travel;
  const double kinetic_limit = slider.normal_force * slider.decay.kinetic_coefficient;
  const double rate = slider.decay.decay_coefficient / increment;
  double slip = (predictor - kinetic_limit) / k;
  for (int i = 0; i < 100; ++i) {
    const double decaying = drop(slider) * std::exp(-rate * slip);
    const double step = (predictor - k * slip - kinetic_limit - decaying) / (k - rate * decaying);
    if (!(step < 0.0)) break;
    slip += step;
  }
  return std::copysign(predictor - k * slip, force + k * travel);
}

struct State {
  double force = 0.0;             ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
};

/// The saw-tooth after a straight piece of motion of the travel du [L]; exact, any number of drops.
/// Where the piece ends on mu_s N the drop is still to come.
inline State advance(const Slider& slider, const State& begin, double travel) {
  if (travel == 0.0) return begin;
  const double sense = std::copysign(1.0, travel);
  const double static_limit = slider.normal_force * slider.decay.static_coefficient;
  State end = begin;
  end.force += slider.stick_stiffness * travel;
  const double excess = sense * end.force - static_limit;
  if (excess > 0.0) {
    const double drops = std::ceil(excess / drop(slider));
    end.force = sense * (static_limit + excess - drops * drop(slider));
    end.accumulated_slip += drops * drop_travel(slider);
  }
  return end;
}

inline constexpr std::array kParameters{
    Parameter{.name = "static_coefficient",
              .dimension = "1",
              .text = "coefficient at slip rate 0, above the kinetic one",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "kinetic_coefficient",
              .dimension = "1",
              .text = "coefficient at infinite slip rate",
              .lower = 0.0},
    Parameter{.name = "decay_coefficient",
              .dimension = "T/L",
              .text = "inverse of the slip rate over which the difference falls to 1/e",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "normal_force",
              .dimension = "F",
              .text = "normal force",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction"},
    Signal{"time", "T", "time; a row is an increment of backward Euler"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "saw-tooth, the limit of short increments"},
    Signal{"accumulated_slip", "L", "slip of the saw-tooth's drops"},
    Signal{"backward_euler_force", "F", "what backward Euler makes of the rows"},
    Signal{"smooth_force", "F", "force of steady slip at the row's speed, N mu(v)"},
    Signal{"smallest_increment", "T",
           "increment above which backward Euler gives the smooth force"},
    Signal{"drop_travel", "L", "travel from one drop of the saw-tooth to the next"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[0][0] > values[1][0]) return std::nullopt;
  return "static_coefficient must be above kinetic_coefficient";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  struct Row {
    State sawtooth;
    double backward_euler = 0.0;
    double motion = 0.0;
    double time = 0.0;
    bool started = false;
  };
  const Slider slider{{values[0][0], values[1][0], values[2][0]}, values[3][0], values[4][0]};
  return [slider, row = Row{}](std::span<const double> inputs, std::span<double> outputs) mutable {
    double speed = 0.0;
    if (row.started) {
      const double travel = inputs[0] - row.motion;
      const double increment = inputs[1] - row.time;
      row.sawtooth = advance(slider, row.sawtooth, travel);
      if (travel != 0.0) {
        row.backward_euler = backward_euler(slider, row.backward_euler, travel, increment);
        speed = travel / increment;
      }
    }
    row.motion = inputs[0];
    row.time = inputs[1];
    row.started = true;
    outputs[0] = row.sawtooth.force;
    outputs[1] = row.sawtooth.accumulated_slip;
    outputs[2] = row.backward_euler;
    outputs[3] = smooth_force(slider, speed);
    outputs[4] = smallest_increment(slider, speed);
    outputs[5] = drop_travel(slider);
  };
}

inline constexpr ClosedForm kForm{
    .name = "static_kinetic_sawtooth",
    .title = "Saw-tooth, smooth answer and threshold of a falling coefficient with elastic stick",
    .formula = "drop (mu_s - mu_k) N each (mu_s - mu_k) N/k; dt > 2 N (mu_s - mu_k) d e^(-d v)/k",
    .source = "derived in docs/theory",
    .range = "mu_s > mu_k, d > 0, N > 0, k > 0; time rises wherever there is motion",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::static_kinetic_sawtooth
