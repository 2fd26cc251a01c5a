// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"

/// The Bouc-Wen hysteresis with the exponent 1.
///
/// Formula   dz = A du - (beta |du| z + gamma du |z|), f = k [r u + (1 - r) z]. From rest: z = A (1
///           - e^(-(beta + gamma) u))/(beta + gamma). Along the motion with y = sign(du) z: dy/d|u|
///           = A - (beta +- gamma) y, + for y > 0: exponentials, split where y changes its sign.
/// Symbols   u motion [L], z hysteretic motion [L], f force [F], k stiffness [F/L], r share of the
///           elastic part [1], A [1], beta and gamma [1/L].
/// Sign      f has the sign of the motion it resists.
/// Source    Bouc 1967; Wen 1976.
/// Range     beta > 0, gamma > -beta, A > 0, k > 0, 0 <= r <= 1; exact on piecewise-linear motion
///           with its turning points on rows.
namespace slipbench::reference::bouc_wen {

struct Hysteresis {
  double stiffness;      ///< k [F/L], > 0
  double beta;           ///< [1/L], > 0
  double gamma;          ///< [1/L], > -beta
  double gain;           ///< A [1], > 0
  double elastic_share;  ///< r [1]
};

/// The solution of dy/dx = A - c y after x.
inline double relax(double gain, double c, double y, double x) {
  if (c == 0.0) return y + gain * x;
  return y - (gain / c - y) * std::expm1(-c * x);
}

/// The hysteretic motion z [L] after a straight piece du [L]; exact.
inline double advance(const Hysteresis& h, double z, double travel) {
  const double sense = std::copysign(1.0, travel);
  double y = sense * z;
  double x = std::abs(travel);
  if (y < 0.0) {
    const double c = h.beta - h.gamma;
    const double to_zero = c == 0.0 ? -y / h.gain : std::log1p(-c * y / h.gain) / c;
    if (x <= to_zero) return sense * relax(h.gain, c, y, x);
    x -= to_zero;
    y = 0.0;
  }
  return sense * relax(h.gain, h.beta + h.gamma, y, x);
}

/// The largest hysteretic motion, A/(beta + gamma) [L].
inline double largest_hysteretic_motion(const Hysteresis& h) { return h.gain / (h.beta + h.gamma); }

inline constexpr std::array kParameters{
    Parameter{.name = "stiffness",
              .dimension = "F/L",
              .text = "stiffness at rest, for a gain of 1",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "beta",
              .dimension = "1/L",
              .text = "rate of the part that always dissipates",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "gamma",
              .dimension = "1/L",
              .text = "rate of the part that changes its sign, above -beta"},
    Parameter{.name = "gain",
              .dimension = "1",
              .text = "A, slope of the hysteretic motion at rest",
              .default_value = 1.0,
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "elastic_share",
              .dimension = "1",
              .text = "share r of the stiffness that stays elastic",
              .default_value = 0.0,
              .lower = 0.0,
              .upper = 1.0}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion, counted from the first row"}};
inline constexpr std::array kOutputs{Signal{"force", "F", "force"},
                                     Signal{"hysteretic_motion", "L", "hysteretic motion z"}};

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  if (values[2][0] > -values[1][0]) return std::nullopt;
  return "gamma must be above -beta, else the hysteretic motion has no bound";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Hysteresis hysteresis{values[0][0], values[1][0], values[2][0], values[3][0], values[4][0]};
  struct State {
    double start = 0.0;
    double motion = 0.0;
    double hysteretic_motion = 0.0;
    bool started = false;
  };
  return [hysteresis, state = State{}](std::span<const double> inputs,
                                       std::span<double> outputs) mutable {
    if (state.started) {
      state.hysteretic_motion =
          advance(hysteresis, state.hysteretic_motion, inputs[0] - state.motion);
    } else {
      state.start = inputs[0];
    }
    state.started = true;
    state.motion = inputs[0];
    const double r = hysteresis.elastic_share;
    outputs[0] = hysteresis.stiffness *
                 (r * (state.motion - state.start) + (1.0 - r) * state.hysteretic_motion);
    outputs[1] = state.hysteretic_motion;
  };
}

inline constexpr ClosedForm kForm{
    .name = "bouc_wen",
    .title = "Bouc-Wen hysteresis, exponent 1",
    .formula = "dz = A du - beta |du| z - gamma du |z|, f = k [r u + (1 - r) z]",
    .source = "Bouc 1967; Wen 1976",
    .range = "beta > 0, gamma > -beta; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

}  // namespace slipbench::reference::bouc_wen
