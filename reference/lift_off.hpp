// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/varying_normal_force.hpp"

/// One spring in series with one Coulomb slider whose normal force is proportional to the motion
/// and ends where the bodies part.
///
/// Formula   N = <N0 + g u>. While N = 0: f = 0 and nothing is remembered; f starts again from 0,
///           with the motion counted from the place of contact, u_c = -N0/g. Steady loop for k >
///           mu g > 0 and N0 < g A: a triangle with the corners (u_c, 0), (A, mu g d) and (u_c + q
///           d, -mu g q d), d = A - u_c, q = (k - mu g)/(k + mu g); E = mu g q d^2.
/// Symbols   u motion [L], N normal force [F], N0 normal force at u = 0 [F], g its gradient [F/L],
///           A amplitude [L], f friction force [F], k stick stiffness [F/L], mu [1], E [F L].
/// Sign      f has the sign of the slip it resists.
/// Source    Menq, Griffin and Bielak 1986; Yang and Menq 1998; loop derived in docs/theory.
/// Range     k > 0, mu >= 0. Exact on piecewise-linear motion with its turning points on rows;
///           parting and meeting need no row.
namespace slipbench::reference::lift_off {

using varying_normal_force::Slider;
using varying_normal_force::State;

struct Contact {
  double normal_force;  ///< N0 at u = 0 [F], negative if there is a gap
  double gradient;      ///< g [F/L]
};

/// <N0 + g u> [F].
inline double normal_force(const Contact& contact, double motion) {
  return std::max(contact.normal_force + contact.gradient * motion, 0.0);
}

/// The slider after a straight piece of motion that ends at `motion` [L]; exact, also if the bodies
/// part or meet on the way.
inline State advance(const Slider& slider, const Contact& contact, const State& begin,
                     double motion) {
  const double before = contact.normal_force + contact.gradient * begin.motion;
  const double after = contact.normal_force + contact.gradient * motion;
  State state = begin;
  if ((before < 0.0) != (after < 0.0)) {
    state =
        varying_normal_force::advance(slider, state, -contact.normal_force / contact.gradient, 0.0);
    state.force = 0.0;
  }
  return varying_normal_force::advance(slider, state, motion, std::max(after, 0.0));
}

struct Loop {
  double contact_motion;  ///< u_c, where contact begins and ends [L]
  double top_force;       ///< at u = A [F]
  double backward_onset;  ///< motion where backward slip begins [L]
  double backward_force;  ///< force there [F]
  double energy;          ///< area of the triangle [F L]
};

/// Steady loop between -A and A with separation. None unless k > mu g > 0 and N0 < g A, and the
/// bodies meet at all (N0 > -g A).
inline std::optional<Loop> loop(const Slider& slider, const Contact& contact, double amplitude) {
  const double slope = slider.mu * contact.gradient;
  if (!(slope > 0.0 && slider.stick_stiffness > slope &&
        std::abs(contact.normal_force) < contact.gradient * amplitude)) {
    return std::nullopt;
  }
  const double start = -contact.normal_force / contact.gradient;
  const double travel = amplitude - start;
  const double share = (slider.stick_stiffness - slope) / (slider.stick_stiffness + slope);
  return Loop{start, slope * travel, start + share * travel, -slope * share * travel,
              slope * share * travel * travel};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "mean_normal_force",
              .dimension = "F",
              .text = "normal force at motion 0; negative if there is a gap"},
    Parameter{.name = "normal_force_gradient",
              .dimension = "F/L",
              .text = "normal force added per motion"}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction, counted from 0"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"normal_force", "F", "normal force, 0 while the bodies are apart"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes in contact"},
    Signal{"dissipation", "F L", "integral of mu N over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Slider slider{values[0][0], values[1][0]};
  const Contact contact{values[2][0], values[3][0]};
  return [slider, contact, state = State{}, started = false](std::span<const double> inputs,
                                                             std::span<double> outputs) mutable {
    if (started) {
      state = advance(slider, contact, state, inputs[0]);
    } else {
      state.motion = inputs[0];
      state.normal_force = normal_force(contact, inputs[0]);
    }
    started = true;
    outputs[0] = state.force;
    outputs[1] = state.normal_force;
    outputs[2] = state.accumulated_slip;
    outputs[3] = state.dissipation;
    outputs[4] = 0.5 * state.force * state.force / slider.stick_stiffness;
    outputs[5] = state.work;
  };
}

inline constexpr ClosedForm kForm{
    .name = "lift_off",
    .title = "Elastic Coulomb slider under a normal force in phase, with separation",
    .formula = "N = <N0 + g u>; N = 0: f = 0, then contact starts afresh; E = mu g q d^2",
    .source = "Menq, Griffin and Bielak 1986; Yang and Menq 1998",
    .range = "k > 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::lift_off
