// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// Backlash, one spring and one Coulomb slider in series, with a limit for each direction.
///
/// Formula   f = k T(u - z), T(x) = x - g/2 for x > g/2, x + g/2 for x < -g/2, else 0, and
///           -lim_b <= f <= lim_f. The slider's place z moves only where f is at a limit and the
///           motion goes on. With g = 0 and equal limits this is the Jenkins element.
/// Symbols   u motion [L], f friction force [F], k stick stiffness [F/L], g width of the gap [L],
///           lim_f, lim_b limits of forward and backward slip [F], s accumulated slip [L], D
///           dissipation [F L], p = u - z - f/k play [L], in [-g/2, g/2].
/// Sign      f has the sign of the slip it resists, like a spring k u.
/// Source    Jenkins 1962 behind a dead-band (play) operator: Tao and Kokotovic, Adaptive Control
///           of Systems with Actuator and Sensor Nonlinearities, 1996. Energies: docs/theory.
/// Range     k > 0, g >= 0, limits > 0. Exact on every piecewise-linear path whose turning points
///           are rows, at any step.
namespace slipbench::reference::backlash_slider {

struct Slider {
  double stick_stiffness;  ///< k [F/L], > 0
  double forward_limit;    ///< lim_f [F], > 0
  double backward_limit;   ///< lim_b [F], > 0
  double gap = 0.0;        ///< g [L], >= 0
};

struct State {
  double motion = 0.0;            ///< u [L]
  double place = 0.0;             ///< z [L]
  double force = 0.0;             ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
  double dissipation = 0.0;       ///< integral of the limit over slip [F L]
  double work = 0.0;              ///< integral of f du [F L]
};

/// The relaxed slider at motion u [L] with play p [L].
inline State start(double motion, double play = 0.0) {
  return {.motion = motion, .place = motion - play};
}

/// f at u - z [L], the limits apart.
inline double spring_force(const Slider& slider, double extension) {
  const double half = 0.5 * slider.gap;
  return slider.stick_stiffness *
         (std::max(extension - half, 0.0) + std::min(extension + half, 0.0));
}

/// The energy held by the spring, f^2/(2k) [F L].
inline double stored_energy(const Slider& slider, double force) {
  return 0.5 * force * force / slider.stick_stiffness;
}

/// The slider after a straight piece of motion that ends at `motion` [L]. While the slider rests
/// the force follows from its potential, so that work is the energy the spring takes up; what lies
/// beyond a limit is work of the limit.
inline State advance(const Slider& slider, const State& begin, double motion) {
  State end = begin;
  end.motion = motion;
  const double free = spring_force(slider, motion - begin.place);
  end.force = std::clamp(free, -slider.backward_limit, slider.forward_limit);
  end.work += stored_energy(slider, end.force) - stored_energy(slider, begin.force);
  if (end.force == free) return end;
  const double slip = (free - end.force) / slider.stick_stiffness;
  end.place += slip;
  end.accumulated_slip += std::abs(slip);
  end.dissipation += end.force * slip;
  end.work += end.force * slip;
  return end;
}

/// p [L] of a state.
inline double play(const Slider& slider, const State& state) {
  const double half = 0.5 * slider.gap;
  return std::clamp(state.motion - state.place - state.force / slider.stick_stiffness, -half, half);
}

/// Slip of one closed cycle between -A and A [L]: 2 (2A - g - (lim_f + lim_b)/k), 0 if that is not
/// positive: the gap and both elastic slips are passed in each direction.
inline double loop_slip(const Slider& slider, double amplitude) {
  const double elastic = (slider.forward_limit + slider.backward_limit) / slider.stick_stiffness;
  return 2.0 * std::max(2.0 * amplitude - slider.gap - elastic, 0.0);
}

/// Energy of one closed cycle between -A and A [F L]: (lim_f + lim_b)(2A - g - (lim_f + lim_b)/k).
inline double loop_energy(const Slider& slider, double amplitude) {
  return 0.5 * (slider.forward_limit + slider.backward_limit) * loop_slip(slider, amplitude);
}

struct Point {
  double motion;  ///< u [L]
  double force;   ///< f [F]
};

/// The corners of the steady loop for 2A > g + (lim_f + lim_b)/k in the order they are passed, from
/// the forward reversal: unloaded, gap crossed, backward slip, backward reversal, and back.
inline std::array<Point, 8> loop_vertices(const Slider& slider, double amplitude) {
  const double forward = slider.forward_limit / slider.stick_stiffness;
  const double backward = slider.backward_limit / slider.stick_stiffness;
  const double a = amplitude;
  const double g = slider.gap;
  return {{{a, slider.forward_limit},
           {a - forward, 0.0},
           {a - forward - g, 0.0},
           {a - forward - g - backward, -slider.backward_limit},
           {-a, -slider.backward_limit},
           {-a + backward, 0.0},
           {-a + backward + g, 0.0},
           {-a + backward + g + forward, slider.forward_limit}}};
}

inline constexpr double kSameLimit = std::numeric_limits<double>::infinity();

inline constexpr std::array kParameters{
    Parameter{
        .name = "limit",
        .dimension = "F",
        .text = "limit of the friction force, mu N; of forward slip if backward_limit is given",
        .lower = 0.0,
        .lower_open = true},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact (F L per radian in a rotational use)",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "gap", .dimension = "L", .text = "width of the dead zone", .lower = 0.0},
    Parameter{.name = "backward_limit",
              .dimension = "F",
              .text = "limit of backward slip; that of forward slip if absent",
              .default_value = kSameLimit,
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "start",
              .dimension = "L",
              .text = "play at the start, from -gap/2 to gap/2",
              .default_value = 0.0}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of the limit over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of force over motion"},
    Signal{"play", "L", "place within the dead zone"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const double limit = values[0][0];
  const double backward = values[3][0] == kSameLimit ? limit : values[3][0];
  const Slider slider{values[1][0], limit, backward, values[2][0]};
  return [slider, first = values[4][0], state = State{}, started = false](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    state = started ? advance(slider, state, inputs[0]) : start(inputs[0], first);
    started = true;
    outputs[0] = state.force;
    outputs[1] = state.accumulated_slip;
    outputs[2] = state.dissipation;
    outputs[3] = stored_energy(slider, state.force);
    outputs[4] = state.work;
    outputs[5] = play(slider, state);
  };
}

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (std::abs(values[4][0]) <= 0.5 * values[2][0]) return std::nullopt;
  return "start lies between -gap/2 and gap/2";
}

inline constexpr ClosedForm kForm{
    .name = "backlash_slider",
    .title = "Backlash, elastic stick and Coulomb slip in series, a limit for each direction",
    .formula =
        "f = k T(u - z), T(x) = x -+ g/2 beyond +-g/2, else 0; -lim_b <= f <= lim_f; z moves "
        "only at a limit",
    .source = "Jenkins 1962 behind a play operator (Tao and Kokotovic 1996)",
    .range = "k > 0, g >= 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::backlash_slider
