// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/closed_form.hpp"

/// Isotropic elastic stick and Coulomb slip in a plane, constant normal force, and its closed
/// solutions on an L-shaped path and on a circle.
///
/// Formula   While slipping f = lim (cos th, sin th); with the motion's direction phi and
///           psi = phi - th: d psi = d phi - (k/lim) sin(psi) |du|, ds = cos(psi) |du|.
///           On a straight piece tan(psi/2) falls as exp(-k r/lim) with the length r slipped
///           through.
/// Symbols   u motion [L], f friction force [F], k stick stiffness [F/L], lim = mu N limit [F],
///           s accumulated slip [L], phi, th, psi angles [1].
/// Sign      f has the direction of the slip it resists.
/// Source    derived in docs/theory; discrete circle: radial return of Simo and Hughes 1998.
/// Range     k > 0, lim >= 0. Exact on polylines whose corners are rows; second order in the step
///           on curves. With lim = 0 the contact counts as open: no force and no slip.
namespace slipbench::reference::planar_slider {

struct Slider {
  double stick_stiffness;  ///< k [F/L], > 0
  double limit;            ///< lim [F], >= 0
};

struct Vector {
  double x = 0.0;
  double y = 0.0;
};

struct State {
  Vector motion;                  ///< u [L]
  Vector force;                   ///< f [F]
  double accumulated_slip = 0.0;  ///< s [L]
};

/// The slider after a straight piece of motion that ends at `motion` [L]; exact.
///
/// The piece sticks over the length w at which |f| meets the limit on the way out, and slips over
/// the rest r, where f swings towards the direction of motion.
inline State advance(const Slider& slider, const State& begin, Vector motion) {
  State end = begin;
  end.motion = motion;
  const Vector du{motion.x - begin.motion.x, motion.y - begin.motion.y};
  const double length = std::hypot(du.x, du.y);
  const double lim = slider.limit;
  if (length == 0.0 || lim == 0.0) return end;

  const double k = slider.stick_stiffness;
  const Vector e{du.x / length, du.y / length};
  const Vector f = begin.force;
  const double along = f.x * e.x + f.y * e.y;
  const double reserve = std::max(lim * lim - (f.x * f.x + f.y * f.y), 0.0);
  const double root = std::sqrt(along * along + reserve);
  // Both expressions are the same root; each is the one that does not cancel.
  const double stick = (along > 0.0 ? reserve / (along + root) : root - along) / k;
  if (stick >= length) {
    end.force = {f.x + k * du.x, f.y + k * du.y};
    return end;
  }
  const double rest = length - stick;
  const Vector onset{f.x + k * stick * e.x, f.y + k * stick * e.y};
  const double psi0 =
      std::atan2(e.x * onset.y - e.y * onset.x, e.x * onset.x + e.y * onset.y);  // from e to f
  const double psi1 = 2.0 * std::atan(std::tan(0.5 * psi0) * std::exp(-k * rest / lim));
  const double c = std::cos(psi1);
  const double s = std::sin(psi1);
  end.force = {lim * (e.x * c - e.y * s), lim * (e.y * c + e.x * s)};
  const double half = std::sin(0.5 * psi0);
  end.accumulated_slip +=
      rest + lim / k * std::log1p(half * half * std::expm1(-2.0 * k * rest / lim));
  return end;
}

/// Second leg of an L-shaped path: the force was (lim, 0) and the motion turned to direction 2.
struct LPath {
  Vector force;  ///< [F]
  double slip;   ///< on the second leg [L]
};

/// L-path after the length w >= 0 [L] of the second leg: f = lim (sech(k w/lim), tanh(k w/lim)),
/// slip = (lim/k) ln cosh(k w/lim). The first leg must have slipped.
inline LPath l_path(const Slider& slider, double second_leg) {
  const double x = slider.stick_stiffness * second_leg / slider.limit;
  // ln cosh x without overflow
  const double log_cosh = x + std::log1p(std::exp(-2.0 * x)) - std::numbers::ln2;
  return {{slider.limit / std::cosh(x), slider.limit * std::tanh(x)},
          slider.limit / slider.stick_stiffness * log_cosh};
}

struct SteadyCircle {
  double lag;               ///< angle of the force behind the motion [1]
  double tangential_force;  ///< [F]
  double radial_force;      ///< [F], towards the circle's centre
  double slip_per_turn;     ///< [L]
  double energy_per_turn;   ///< [F L]
};

/// Steady motion on a circle of radius R [L]: lag = asin(lim/(kR)), slip per turn 2 pi sqrt(R^2 -
/// (lim/k)^2). A circle with R <= lim/k never slips steadily: the lag is pi/2, the force k R is
/// radial and slip and energy are 0.
inline SteadyCircle steady_circle(const Slider& slider, double radius) {
  using std::numbers::pi;
  const double elastic = slider.limit / slider.stick_stiffness;
  if (radius <= elastic) return {0.5 * pi, 0.0, slider.stick_stiffness * radius, 0.0, 0.0};
  const double lag = std::asin(elastic / radius);
  const double slip = 2.0 * pi * std::sqrt((radius - elastic) * (radius + elastic));
  return {lag, slider.limit * std::cos(lag), slider.limit * std::sin(lag), slip,
          slider.limit * slip};
}

struct DiscreteCircle {
  double lag;            ///< angle of the force behind the tangent at the increment's end [1]
  double slip_per_turn;  ///< [L]
};

/// Returns what backward Euler with n >= 3 equal increments a turn settles to on a circle of radius
/// R [L] (the algorithm's answer, not physics). With a = 2 pi/n and the chord c = 2 R sin(a/2): lag
/// = a/2 + chi, sin(chi) = (lim/(kR)) cos(a/2), slip = n [c cos(chi) - (lim/k)(1 - cos a)]. NaN if
/// the circle does not slip.
inline DiscreteCircle discrete_circle(const Slider& slider, double radius, int increments) {
  const double elastic = slider.limit / slider.stick_stiffness;
  const double half = std::numbers::pi / increments;
  const double chi = std::asin(elastic / radius * std::cos(half));
  const double versine = 2.0 * std::sin(half) * std::sin(half);
  const double slip = 2.0 * radius * std::sin(half) * std::cos(chi) - elastic * versine;
  if (!(slip > 0.0)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  return {half + chi, increments * slip};
}

/// The angle p [1] at which the circle u = R (cos p - 1, sin p) first slips: 2 asin(lim/(2kR)). NaN
/// if the circle's diameter is below lim/k.
inline double circle_onset(const Slider& slider, double radius) {
  return 2.0 * std::asin(slider.limit / (2.0 * slider.stick_stiffness * radius));
}

/// Force [F] at the angle p >= 0 [1] of the circle u = R (cos p - 1, sin p) that starts from rest.
///
/// Stick up to the onset p_c; then t = tan(psi/2) obeys (t - t1)/(t - t2) = C exp(-q (p - p_c))
/// with a0 = kR/lim, q = sqrt(a0^2 - 1), t1,2 = a0 -+ q and psi(p_c) = p_c/2. Needs a0 > 1, else
/// NaN.
inline Vector circle_transient(const Slider& slider, double radius, double angle) {
  const double onset = circle_onset(slider, radius);
  const double a0 = slider.stick_stiffness * radius / slider.limit;
  if (!(a0 > 1.0)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  if (angle <= onset) {
    const double scale = slider.stick_stiffness * radius;
    return {scale * (std::cos(angle) - 1.0), scale * std::sin(angle)};
  }
  const double q = std::sqrt(a0 * a0 - 1.0);
  const double t1 = 1.0 / (a0 + q);  // a0 - q without cancellation
  const double t2 = a0 + q;
  const double t0 = std::tan(0.25 * onset);
  const double ratio = (t0 - t1) / (t0 - t2) * std::exp(-q * (angle - onset));
  const double psi = 2.0 * std::atan((t1 - ratio * t2) / (1.0 - ratio));
  const double direction = angle + 0.5 * std::numbers::pi - psi;
  return {slider.limit * std::cos(direction), slider.limit * std::sin(direction)};
}

/// Magnitude of the tangential force of a shaft of radius R [L] under f1 [F] and m1 [F L]:
/// sqrt(f1^2 + (m1/R)^2) [F].
inline double shaft_force(double f1, double m1, double radius) {
  return std::hypot(f1, m1 / radius);
}

struct HelicalSlip {
  double force;      ///< f1 [F]
  double moment;     ///< m1 [F L]
  double slip_rate;  ///< [L/T]
  double power;      ///< dissipated [F L/T]
};

/// Steady helical slip of a shaft of radius R [L] that moves with v [L/T] and turns with omega
/// [1/T] against the limit lim [F]: the friction force points along (v, R omega). v and omega not
/// both 0.
inline HelicalSlip helical_slip(double limit, double radius, double velocity, double omega) {
  const double rate = std::hypot(velocity, radius * omega);
  return {limit * velocity / rate, limit * radius * (radius * omega / rate), rate, limit * rate};
}

inline constexpr std::array kParameters{
    Parameter{.name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0},
    Parameter{.name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0},
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact, the same in both directions",
              .lower = 0.0,
              .lower_open = true}};
inline constexpr std::array kInputs{
    Signal{"motion1", "L", "relative motion along the first direction"},
    Signal{"motion2", "L", "relative motion along the second"}};
inline constexpr std::array kOutputs{
    Signal{"force1", "F", "friction force along the first direction"},
    Signal{"force2", "F", "friction force along the second"},
    Signal{"force", "F", "magnitude of the friction force"},
    Signal{"accumulated_slip", "L", "length of the slip path"},
    Signal{"dissipation", "F L", "integral of the limit over slip"}};

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  const Slider slider{values[2][0], values[0][0] * values[1][0]};
  return [slider, state = State{}, started = false](std::span<const double> inputs,
                                                    std::span<double> outputs) mutable {
    const Vector motion{inputs[0], inputs[1]};
    if (started) {
      state = advance(slider, state, motion);
    } else {
      state.motion = motion;
    }
    started = true;
    outputs[0] = state.force.x;
    outputs[1] = state.force.y;
    outputs[2] = std::hypot(state.force.x, state.force.y);
    outputs[3] = state.accumulated_slip;
    outputs[4] = slider.limit * state.accumulated_slip;
  };
}

inline constexpr ClosedForm kForm{
    .name = "planar_slider",
    .title = "Elastic stick and Coulomb slip in two coupled directions, constant normal force",
    .formula = "stick: f += k du; slip: tan(psi/2) falls as exp(-k r/lim), ds = cos(psi) dr",
    .source = "derived in docs/theory",
    .range = "k > 0; exact on polylines with their corners on rows, second order on curves",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = no_violation};

}  // namespace slipbench::reference::planar_slider
