// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// A mass held by a spring on a moving belt, with a static and a kinetic coefficient; rigid stick.
///
/// Formula   Slip in the sense z = sign(v - x'): x = c + (x_0 - c) cos(w t) + (x'_0/w) sin(w t),
///           c = z mu_k N/k, until x' = v again. Stick: x' = v while |k x| <= mu_s N. Limit cycle
///           with D = (mu_s - mu_k) N/k and X = sqrt(D^2 + (v/w)^2): slip lasts (2/w)(pi - atan(w
///           D/v)), stick 2 D/v, x reaches mu_k N/k + X, heat mu_k N (2 D + v t_slip).
/// Symbols   x motion of the mass from the relaxed spring [L], m mass [F T^2/L], k spring [F/L],
///           w = sqrt(k/m) [1/T], N normal force [F], v belt velocity [L/T], f friction force [F].
/// Sign      slip is that of the belt over the mass, v - x'; f has its sign, so it pushes the mass.
/// Source    derived in docs/theory.
/// Range     m, k > 0, N >= 0, mu_s >= mu_k >= 0. Exact at any time.
namespace slipbench::reference::stick_slip_oscillator {

struct Oscillator {
  double mass;                 ///< m [F T^2/L], > 0
  double stiffness;            ///< k [F/L], > 0
  double normal_force;         ///< N [F], >= 0
  double static_coefficient;   ///< mu_s [1], >= mu_k
  double kinetic_coefficient;  ///< mu_k [1], >= 0
  double belt_velocity;        ///< v [L/T]
};

/// w = sqrt(k/m) [1/T].
inline double circular_frequency(const Oscillator& oscillator) {
  return std::sqrt(oscillator.stiffness / oscillator.mass);
}

struct LimitCycle {
  double slip_time;       ///< [T]
  double stick_time;      ///< [T]
  double period;          ///< [T]
  double amplitude;       ///< X [L]
  double maximum_motion;  ///< mu_k N/k + X [L]
  double stick_motion;    ///< where the mass comes to stick again, mu_k N/k - D [L]
  double slip;            ///< slip of one cycle, 2 D + v t_slip [L]
  double heat;            ///< mu_k N times the slip [F L]
};

/// The stick-slip cycle of a belt velocity v > 0 and mu_s > mu_k.
inline LimitCycle limit_cycle(const Oscillator& o) {
  const double w = circular_frequency(o);
  const double v = o.belt_velocity;
  const double centre = o.kinetic_coefficient * o.normal_force / o.stiffness;
  const double reach =
      (o.static_coefficient - o.kinetic_coefficient) * o.normal_force / o.stiffness;
  LimitCycle cycle{};
  cycle.slip_time = 2.0 / w * (std::numbers::pi - std::atan2(w * reach, v));
  cycle.stick_time = 2.0 * reach / v;
  cycle.period = cycle.slip_time + cycle.stick_time;
  cycle.amplitude = std::hypot(reach, v / w);
  cycle.maximum_motion = centre + cycle.amplitude;
  cycle.stick_motion = centre - reach;
  cycle.slip = 2.0 * reach + v * cycle.slip_time;
  cycle.heat = o.kinetic_coefficient * o.normal_force * cycle.slip;
  return cycle;
}

struct State {
  double motion = 0.0;            ///< x [L]
  double velocity = 0.0;          ///< x' [L/T]
  double accumulated_slip = 0.0;  ///< integral of |v - x'| dt [L]
  int sense = 0;                  ///< 1 belt ahead, -1 mass ahead, 0 stick
};

/// Tells whether the mass sticks at this motion and velocity, and if not, the sense of slip.
inline State classify(const Oscillator& o, double motion, double velocity) {
  State state{motion, velocity, 0.0, 0};
  const double gap = o.belt_velocity - velocity;
  if (gap != 0.0) {
    state.sense = gap > 0.0 ? 1 : -1;
  } else if (o.stiffness * std::abs(motion) > o.static_coefficient * o.normal_force) {
    state.sense = motion > 0.0 ? 1 : -1;
  }
  return state;
}

/// Motion and velocity a time t [T] further on in the same phase.
inline State within_phase(const Oscillator& o, const State& begin, double t) {
  State end = begin;
  if (begin.sense == 0) {
    end.motion += o.belt_velocity * t;
    return end;
  }
  const double w = circular_frequency(o);
  const double centre = begin.sense * o.kinetic_coefficient * o.normal_force / o.stiffness;
  const double c = std::cos(w * t);
  const double s = std::sin(w * t);
  end.motion = centre + (begin.motion - centre) * c + begin.velocity / w * s;
  end.velocity = begin.velocity * c - (begin.motion - centre) * w * s;
  end.accumulated_slip += begin.sense * (o.belt_velocity * t - (end.motion - begin.motion));
  return end;
}

/// Returns how long the phase lasts [T]; infinite if for ever.
inline double phase_duration(const Oscillator& o, const State& begin) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const double v = o.belt_velocity;
  if (begin.sense == 0) {
    if (v == 0.0) return kForever;
    const double edge = std::copysign(o.static_coefficient * o.normal_force / o.stiffness, v);
    return std::max((edge - begin.motion) / v, 0.0);
  }
  // x' = q cos(w t + a) meets v from below if the belt is ahead, from above if the mass is.
  const double w = circular_frequency(o);
  const double centre = begin.sense * o.kinetic_coefficient * o.normal_force / o.stiffness;
  const double swing = w * (begin.motion - centre);
  const double q = std::hypot(begin.velocity, swing);
  const double a = std::atan2(swing, begin.velocity);
  if (!(std::abs(v) <= q)) return kForever;
  double angle = -begin.sense * std::acos(v / q) - a;
  // A phase that begins at x' = v ends a finite angle later.
  constexpr double kRounding = 1e-12;
  while (angle <= kRounding) angle += 2.0 * std::numbers::pi;
  return angle / w;
}

/// The state at the end of the phase, in the phase that follows.
inline State next_phase(const Oscillator& o, const State& begin, double duration) {
  const State end = within_phase(o, begin, duration);
  State next;
  if (begin.sense == 0) {
    const double sense = std::copysign(1.0, o.belt_velocity);
    next = {sense * o.static_coefficient * o.normal_force / o.stiffness, o.belt_velocity, 0.0,
            o.belt_velocity > 0.0 ? 1 : -1};
  } else {
    next = classify(o, end.motion, o.belt_velocity);
  }
  next.accumulated_slip = end.accumulated_slip;
  return next;
}

/// Friction force [F]; it balances the spring in stick.
inline double force(const Oscillator& o, const State& state) {
  if (state.sense == 0) return o.stiffness * state.motion;
  return state.sense * o.kinetic_coefficient * o.normal_force;
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
    Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    Parameter{.name = "static_coefficient",
              .dimension = "1",
              .text = "coefficient that ends stick, not below the kinetic one",
              .lower = 0.0},
    Parameter{.name = "kinetic_coefficient",
              .dimension = "1",
              .text = "coefficient in slip",
              .lower = 0.0},
    Parameter{.name = "belt_velocity", .dimension = "L/T", .text = "velocity of the belt"},
    Parameter{.name = "initial_motion",
              .dimension = "L",
              .text = "motion of the mass at the start",
              .default_value = 0.0},
    Parameter{.name = "initial_velocity",
              .dimension = "L/T",
              .text = "velocity of the mass at the start",
              .default_value = 0.0},
    kStartTime};
inline constexpr std::array kInputs{
    Signal{"time", "T", "time, never falling; before the start the mass is held"}};
inline constexpr std::array kOutputs{
    Signal{"motion", "L", "motion of the mass from the relaxed spring"},
    Signal{"velocity", "L/T", "velocity of the mass"},
    Signal{"force", "F", "friction force of the belt on the mass"},
    Signal{"accumulated_slip", "L", "slip of the belt over the mass, summed in magnitude"},
    Signal{"dissipation", "F L", "kinetic friction force times accumulated slip"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[3][0] >= values[4][0]) return std::nullopt;
  return "static_coefficient must not be below kinetic_coefficient";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Oscillator oscillator{values[0][0], values[1][0], values[2][0],
                              values[3][0], values[4][0], values[5][0]};
  // With next to no friction phases last less than the time can tell.
  constexpr int kMostPhases = 1'000'000;
  struct Phase {
    State state;
    double begin = 0.0;
    double duration = 0.0;
  };
  Phase first;
  first.begin = values[8][0];
  first.state = classify(oscillator, values[6][0], values[7][0]);
  first.duration = phase_duration(oscillator, first.state);
  return [oscillator, phase = first, phases = 0](std::span<const double> inputs,
                                                 std::span<double> outputs) mutable {
    while (inputs[0] - phase.begin > phase.duration) {
      if (++phases > kMostPhases) {
        std::fill(outputs.begin(), outputs.end(), std::numeric_limits<double>::quiet_NaN());
        return;
      }
      phase.state = next_phase(oscillator, phase.state, phase.duration);
      phase.begin += phase.duration;
      phase.duration = phase_duration(oscillator, phase.state);
    }
    const State state =
        within_phase(oscillator, phase.state, std::max(inputs[0] - phase.begin, 0.0));
    outputs[0] = state.motion;
    outputs[1] = state.velocity;
    outputs[2] = force(oscillator, state);
    outputs[3] = state.accumulated_slip;
    outputs[4] = oscillator.kinetic_coefficient * oscillator.normal_force * state.accumulated_slip;
  };
}

inline constexpr ClosedForm kForm{
    .name = "stick_slip_oscillator",
    .title = "Mass and spring on a moving belt, static and kinetic coefficient",
    .formula =
        "slip: m x'' + k x = z mu_k N, z = sign(v - x'); stick: x' = v while |k x| <= mu_s N",
    .source = "derived in docs/theory",
    .range = "m, k > 0, mu_s >= mu_k; rigid stick; exact for 10^6 phases of stick and slip",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::stick_slip_oscillator
