// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/closed_form.hpp"

/// One spring in series with one Coulomb slider (the Jenkins element), constant normal force.
///
/// Formula   f = k (u - z), |f| <= lim, lim = min(mu N, f_max). The origin z moves only where |f| =
///           lim and the motion goes on, and then by ds = sign(f) dz >= 0.
/// Symbols   u motion [L], f friction force [F], k stick stiffness [F/L], N normal force [F], mu
///           coefficient [1], f_max force limit [F], s accumulated slip [L], D dissipation [F L],
///           s_c = lim/k elastic slip [L]. In a rotational use: L is replaced by radians, F by F L.
/// Sign      f has the sign of the slip it resists, like a spring k u.
/// Source    Coulomb 1785; Jenkins 1962; harmonic balance: Griffin 1980. Energies: docs/theory.
/// Range     k > 0, lim >= 0. Exact on every piecewise-linear path whose turning points are rows,
///           at any step. With lim = 0 the contact counts as open: no force and no slip is
///           accumulated.
namespace slipbench::reference::coulomb_slider {

struct Slider {
  double stick_stiffness;  ///< k [F/L], > 0
  double limit;            ///< lim [F], >= 0
};

/// The limiting friction force lim = min(mu N, f_max) [F].
inline double limit(double mu, double normal_force,
                    double force_limit = std::numeric_limits<double>::infinity()) {
  return std::min(mu * normal_force, force_limit);
}

struct State {
  double motion = 0.0;            ///< u [L]
  double origin = 0.0;            ///< z [L], the motion at which the spring would be relaxed
  double force = 0.0;             ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
  double dissipation = 0.0;       ///< integral of lim ds [F L]
  double work = 0.0;              ///< integral of f du [F L]
};

/// The relaxed slider at motion u [L].
inline State start(double motion) { return {.motion = motion, .origin = motion}; }

/// The slider after a straight piece of motion that ends at `motion` [L].
///
/// Work is the integral of force over motion, split where stick turns into slip; it does not use
/// the dissipation, so that work = dissipation + change of stored energy is a genuine check.
inline State advance(const Slider& slider, const State& begin, double motion) {
  State end = begin;
  end.motion = motion;
  if (slider.limit == 0.0) {
    end.origin = motion;
    return end;
  }
  const double k = slider.stick_stiffness;
  const double travel = motion - begin.motion;
  const double predictor = k * (motion - begin.origin);
  if (std::abs(predictor) <= slider.limit) {
    end.force = predictor;
    end.work += 0.5 * (begin.force + end.force) * travel;
    return end;
  }
  end.force = std::copysign(slider.limit, predictor);
  end.origin = motion - end.force / k;
  const double slip = std::abs(end.origin - begin.origin);
  end.accumulated_slip += slip;
  end.dissipation += slider.limit * slip;
  const double stick_travel = (end.force - begin.force) / k;
  end.work += 0.5 * (begin.force + end.force) * stick_travel + end.force * (travel - stick_travel);
  return end;
}

/// The energy held by the spring, f^2/(2k) [F L].
inline double stored_energy(const Slider& slider, double force) {
  return 0.5 * force * force / slider.stick_stiffness;
}

/// Slip of one closed cycle between -A and A [L]: 4 (A - s_c), 0 if A <= s_c.
inline double loop_slip(const Slider& slider, double amplitude) {
  return 4.0 * std::max(amplitude - slider.limit / slider.stick_stiffness, 0.0);
}

/// Energy of one closed cycle between -A and A [F L]: 4 lim (A - s_c), exactly 0 if A <= s_c.
inline double loop_energy(const Slider& slider, double amplitude) {
  return slider.limit * loop_slip(slider, amplitude);
}

struct Point {
  double motion;  ///< u [L]
  double force;   ///< f [F]
};

/// The corners of the steady loop for A > s_c, in the order they are passed: (A, lim), (A - 2 s_c,
/// -lim), (-A, -lim), (-A + 2 s_c, lim).
inline std::array<Point, 4> loop_vertices(const Slider& slider, double amplitude) {
  const double elastic = slider.limit / slider.stick_stiffness;
  return {{{amplitude, slider.limit},
           {amplitude - 2.0 * elastic, -slider.limit},
           {-amplitude, -slider.limit},
           {-amplitude + 2.0 * elastic, slider.limit}}};
}

struct HarmonicBalance {
  double slip_angle;            ///< theta [1]
  double equivalent_stiffness;  ///< k_eq [F/L]
  double loss_stiffness;        ///< c_eq omega [F/L]; pi c_eq omega A^2 is the loop energy
};

/// First-harmonic stiffness and loss under u = A cos(p), A > 0 [L] (Griffin 1980): theta = acos(1 -
/// 2 s_c/A), k_eq = (k/pi)(theta - sin(2 theta)/2), c_eq omega = 4 lim/(pi A) (1 - s_c/A). For A <=
/// s_c: theta = pi, k_eq = k and no loss.
inline HarmonicBalance harmonic_balance(const Slider& slider, double amplitude) {
  using std::numbers::pi;
  const double ratio = slider.limit / slider.stick_stiffness / amplitude;
  if (ratio >= 1.0) return {pi, slider.stick_stiffness, 0.0};
  const double theta = std::acos(1.0 - 2.0 * ratio);
  return {theta, slider.stick_stiffness / pi * (theta - 0.5 * std::sin(2.0 * theta)),
          4.0 * slider.limit / (pi * amplitude) * (1.0 - ratio)};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "normal_force",
              .dimension = "F",
              .text = "normal force (a moment, F L, in a rotational use)",
              .lower = 0.0},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact (F L per radian in a rotational use)",
              .lower = 0.0,
              .lower_open = true},
    Parameter{.name = "force_limit",
              .dimension = "F",
              .text = "cap of the friction force; none if absent",
              .default_value = std::numeric_limits<double>::infinity(),
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"motion", "L", "relative motion along the slip direction"}};
inline constexpr std::array kOutputs{
    Signal{"force", "F", "friction force"},
    Signal{"accumulated_slip", "L", "sum of the slip increments' magnitudes"},
    Signal{"dissipation", "F L", "integral of the limit over slip"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"},
    Signal{"work", "F L", "integral of force over motion"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Slider slider{values[2][0], limit(values[0][0], values[1][0], values[3][0])};
  return [slider, state = State{}, started = false](std::span<const double> inputs,
                                                    std::span<double> outputs) mutable {
    state = started ? advance(slider, state, inputs[0]) : start(inputs[0]);
    started = true;
    outputs[0] = state.force;
    outputs[1] = state.accumulated_slip;
    outputs[2] = state.dissipation;
    outputs[3] = stored_energy(slider, state.force);
    outputs[4] = state.work;
  };
}

inline constexpr ClosedForm kForm{
    .name = "coulomb_slider",
    .title = "Elastic stick and Coulomb slip in one dimension, constant normal force",
    .formula = "f = k (u - z), |f| <= min(mu N, f_max); z moves only at the limit",
    .source = "Coulomb 1785; Jenkins 1962",
    .range = "k > 0; piecewise-linear motion with its turning points on rows",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::coulomb_slider
