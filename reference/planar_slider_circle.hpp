// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/closed_form.hpp"
#include "reference/planar_slider.hpp"

/// The planar slider on a circle: from rest at every angle, steadily, and what backward Euler makes
/// of it.
///
/// Formula   u = R (cos p - 1, sin p). Stick up to p_c = 2 asin(lim/(2kR)). Then, with psi the
///           force's lag behind the motion, d psi = dp - (kR/lim) sin(psi) dp, whose t = tan(psi/2)
///           obeys (t - t1)/(t - t2) = C exp(-q (p - p_c)); slip s = (lim/k) {q (p - p_c) + ln[((1
///           - E) / (1 - C))^2 (1 + t^2)/(1 + t_c^2)]}, E = C exp(-q (p - p_c)). Steady: sin(psi) =
///           lim/(kR).
/// Symbols   p phase [1], R radius [L], a0 = kR/lim, q = sqrt(a0^2 - 1), t1,2 = a0 -+ q, others as
///           in planar_slider.
/// Sign      counter-clockwise; f has the direction of the slip it resists.
/// Source    derived in docs/theory; increments: radial return of Simo and Hughes 1998.
/// Range     R > lim/k > 0; exact at every phase p >= 0.
namespace slipbench::reference::planar_slider_circle {

using planar_slider::Slider;
using planar_slider::Vector;

/// The lag psi [1] of the force behind the motion, from rest at p = 0.
inline double lag(const Slider& slider, double radius, double phase) {
  if (phase <= planar_slider::circle_onset(slider, radius)) return 0.5 * phase;
  const Vector force = planar_slider::circle_transient(slider, radius, phase);
  const Vector along{-std::sin(phase), std::cos(phase)};
  return std::atan2(force.x * along.y - force.y * along.x, force.x * along.x + force.y * along.y);
}

/// Slip [L] from rest at p = 0.
inline double accumulated_slip(const Slider& slider, double radius, double phase) {
  const double onset = planar_slider::circle_onset(slider, radius);
  if (phase <= onset) return 0.0;
  const double a0 = slider.stick_stiffness * radius / slider.limit;
  const double q = std::sqrt(a0 * a0 - 1.0);
  const double start = std::tan(0.25 * onset);
  const double constant = (start - 1.0 / (a0 + q)) / (start - (a0 + q));
  const double ratio = constant * std::exp(-q * (phase - onset));
  const double t = std::tan(0.5 * lag(slider, radius, phase));
  const double growth = (1.0 - ratio) / (1.0 - constant);
  return slider.limit / slider.stick_stiffness *
         (q * (phase - onset) + std::log(growth * growth * (1.0 + t * t) / (1.0 + start * start)));
}

/// A force [F] of the given magnitude that lags [1] behind counter-clockwise motion at the phase.
inline Vector lagging_force(double magnitude, double phase, double lag) {
  const double direction = phase - lag;
  return {-magnitude * std::sin(direction), magnitude * std::cos(direction)};
}

inline constexpr Parameter kMu{.name = "mu",
                               .dimension = "1",
                               .text = "friction coefficient",
                               .lower = 0.0,
                               .lower_open = true};
inline constexpr Parameter kNormalForce{.name = "normal_force",
                                        .dimension = "F",
                                        .text = "normal force",
                                        .lower = 0.0,
                                        .lower_open = true};
inline constexpr Parameter kStickStiffness{
    .name = "stick_stiffness",
    .dimension = "F/L",
    .text = "stiffness of the sticking contact, the same in both directions",
    .lower = 0.0,
    .lower_open = true};
inline constexpr Parameter kRadius{.name = "radius",
                                   .dimension = "L",
                                   .text = "radius R of the circle, above mu N/k",
                                   .lower = 0.0,
                                   .lower_open = true};

inline constexpr std::array kParameters{kMu, kNormalForce, kStickStiffness, kRadius};
inline constexpr std::array kInputs{
    Signal{"phase", "1", "angle p turned on the circle, 0 at rest and never negative"}};
inline constexpr std::array kOutputs{
    Signal{"force1", "F", "friction force from rest, along the first direction"},
    Signal{"force2", "F", "friction force from rest, along the second"},
    Signal{"force", "F", "magnitude of the friction force"},
    Signal{"accumulated_slip", "L", "length of the slip path"},
    Signal{"dissipation", "F L", "integral of the limit over slip"},
    Signal{"lag", "1", "angle of the force behind the motion"},
    Signal{"steady_force1", "F", "force of steady circling, along the first direction"},
    Signal{"steady_force2", "F", "force of steady circling, along the second"},
    Signal{"steady_slip_per_turn", "L", "slip of a turn of steady circling"},
    Signal{"steady_energy_per_turn", "F L", "energy of a turn of steady circling"}};

inline Slider slider_of(std::span<const std::vector<double>> values) {
  return {values[2][0], values[0][0] * values[1][0]};
}

inline std::optional<std::string> violation(std::span<const std::vector<double>> values) {
  const Slider slider = slider_of(values);
  if (slider.stick_stiffness * values[3][0] > slider.limit) return std::nullopt;
  return "radius is not above mu normal_force/stick_stiffness; such a circle does not slip "
         "steadily";
}

inline PathEvaluator make(std::span<const std::vector<double>> values) {
  return [slider = slider_of(values), radius = values[3][0]](std::span<const double> inputs,
                                                             std::span<double> outputs) {
    const double phase = inputs[0];
    const Vector force = planar_slider::circle_transient(slider, radius, phase);
    const auto steady = planar_slider::steady_circle(slider, radius);
    const Vector steady_force = lagging_force(slider.limit, phase, steady.lag);
    outputs[0] = force.x;
    outputs[1] = force.y;
    outputs[2] = std::hypot(force.x, force.y);
    outputs[3] = accumulated_slip(slider, radius, phase);
    outputs[4] = slider.limit * outputs[3];
    outputs[5] = lag(slider, radius, phase);
    outputs[6] = steady_force.x;
    outputs[7] = steady_force.y;
    outputs[8] = steady.slip_per_turn;
    outputs[9] = steady.energy_per_turn;
  };
}

inline constexpr ClosedForm kForm{
    .name = "planar_slider_circle",
    .title = "Elastic Coulomb slider on a circle, from rest and steadily",
    .formula = "d psi/dp = 1 - (kR/lim) sin(psi); steady: sin(psi) = lim/(kR)",
    .source = "derived in docs/theory",
    .range = "R > mu N/k > 0; u = R (cos p - 1, sin p), exact at every phase p >= 0",
    .parameters = kParameters,
    .inputs = kInputs,
    .outputs = kOutputs,
    .make = make,
    .violation = violation};

inline constexpr std::array kIncrementsParameters{kMu, kNormalForce, kStickStiffness, kRadius,
                                                  Parameter{.name = "increments_per_turn",
                                                            .dimension = "1",
                                                            .text = "equal increments a turn",
                                                            .lower = 3.0}};
inline constexpr std::array kIncrementsInputs{
    Signal{"phase", "1", "angle p turned on the circle at the increment's end"}};
inline constexpr std::array kIncrementsOutputs{
    Signal{"force1", "F", "backward Euler's steady force, along the first direction"},
    Signal{"force2", "F", "backward Euler's steady force, along the second"},
    Signal{"lag", "1", "angle of the force behind the tangent at the increment's end"},
    Signal{"slip_per_increment", "L", "equivalent slip of an increment"},
    Signal{"slip_per_turn", "L", "equivalent slip of a turn"},
    Signal{"energy_per_turn", "F L", "limit times slip of a turn"}};

inline std::optional<std::string> increments_violation(
    std::span<const std::vector<double>> values) {
  if (auto broken = violation(values)) return broken;
  const double increments = values[4][0];
  if (increments == std::floor(increments) &&
      increments <= static_cast<double>(std::numeric_limits<int>::max())) {
    const auto circle = planar_slider::discrete_circle(slider_of(values), values[3][0],
                                                       static_cast<int>(increments));
    if (std::isfinite(circle.lag)) return std::nullopt;
    return "increments_per_turn is too small; backward Euler does not slip steadily with it";
  }
  return "increments_per_turn must be a whole number";
}

inline PathEvaluator make_increments(std::span<const std::vector<double>> values) {
  const Slider slider = slider_of(values);
  const double increments = values[4][0];
  const auto circle =
      planar_slider::discrete_circle(slider, values[3][0], static_cast<int>(increments));
  return [slider, circle, increments](std::span<const double> inputs, std::span<double> outputs) {
    const Vector force = lagging_force(slider.limit, inputs[0], circle.lag);
    outputs[0] = force.x;
    outputs[1] = force.y;
    outputs[2] = circle.lag;
    outputs[3] = circle.slip_per_turn / increments;
    outputs[4] = circle.slip_per_turn;
    outputs[5] = slider.limit * circle.slip_per_turn;
  };
}

inline constexpr ClosedForm kIncrementsForm{
    .name = "planar_slider_circle_increments",
    .title = "What backward Euler settles to on a circle: the algorithm's answer, not physics",
    .formula = "lag = a/2 + asin((lim/(kR)) cos(a/2)), a = 2 pi/n",
    .source = "derived in docs/theory; radial return: Simo and Hughes 1998",
    .range = "R > mu N/k > 0, n >= 3; steady, after about five turns",
    .parameters = kIncrementsParameters,
    .inputs = kIncrementsInputs,
    .outputs = kIncrementsOutputs,
    .make = make_increments,
    .violation = increments_violation};

}  // namespace slipbench::reference::planar_slider_circle
