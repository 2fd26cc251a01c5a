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
#include "reference/coulomb_slider.hpp"

/// Friction potentials other than the root of squares: p-norms of scaled forces and their limit,
/// the maximum.
///
/// Formula   P = (sum |f_i/R_i|^p)^(1/p); p = 1 adds, p -> infinity is the maximum. Steady slip
///           along the rate v under associated flow, P = lim: with d_i = R_i v_i and q = p/(p-1),
///           f_i/R_i = lim sign(d_i) (|d_i|/|d|_q)^(q-1). Maximum: independent boxes, |f_i| <= R_i
///           lim. Power lim |d|_q.
/// Symbols   f_i forces [F] (or moments), R_i scales [1] (or [L]), v_i slip rates [L/T] (or [1/T]),
///           d_i scaled slip rates [L/T], lim = mu N limit [F].
/// Sign      f has the sign of the slip it resists.
/// Source    docs/theory, section 7.1; Hoelder's inequality, docs/theory.
/// Range     p >= 1 for P, p > 1 for the slip direction (p = 1 has corners), R_i > 0.
namespace slipbench::reference::p_norm {

/// (sum |x_i|^p)^(1/p) for p >= 1, the largest |x_i| for an infinite p; scaled by the largest, so
/// that no power overflows and an infinite p needs no case of its own.
inline double norm(std::span<const double> x, double p) {
  double largest = 0.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  if (largest == 0.0) return 0.0;
  double sum = 0.0;
  for (const double value : x) sum += std::pow(std::abs(value) / largest, p);
  return largest * std::pow(sum, 1.0 / p);
}

struct Pair {
  double first;
  double second;
};

struct SteadySlip {
  Pair force;    ///< f_1, f_2 [F], or moments
  double power;  ///< dissipated [F L/T]
};

/// Force in steady slip of a two-component potential with the exponent p > 1 (infinite: maximum).
///
/// Maximises the power over all forces with P <= lim. A component without slip carries no force;
/// for the maximum this is a convention, for any force inside its box would do.
inline SteadySlip steady_slip(double limit, double p, Pair scale, Pair rate) {
  const double d[] = {scale.first * rate.first, scale.second * rate.second};
  const double largest = std::max(std::abs(d[0]), std::abs(d[1]));
  if (largest == 0.0) return {{0.0, 0.0}, 0.0};
  const double dual = std::isinf(p) ? 1.0 : p / (p - 1.0);
  const double size = norm(d, dual);
  const auto component = [&](double x) {
    if (x == 0.0) return 0.0;
    return std::copysign(limit * std::pow(std::abs(x) / size, dual - 1.0), x);
  };
  return {{scale.first * component(d[0]), scale.second * component(d[1])}, limit * size};
}

inline constexpr Parameter kExponent{.name = "exponent",
                                     .dimension = "1",
                                     .text = "exponent p; infinite is the maximum",
                                     .lower = 1.0};
inline constexpr std::array kNormParameters{
    kExponent, Parameter{.name = "scale",
                         .dimension = "1",
                         .text = "scale of each contribution, one to three entries; L where a "
                                 "moment is scaled to a force",
                         .list = true,
                         .lower = 0.0,
                         .lower_open = true}};
inline constexpr std::array kNormInputs{
    Signal{"contribution1", "F", "first force"},
    Signal{"contribution2", "F", "second force; not read if there is one scale"},
    Signal{"contribution3", "F", "third force; not read if there are fewer scales"}};
inline constexpr std::array kNormOutputs{
    Signal{"magnitude", "F", "the p-norm of the scaled contributions"},
    Signal{"maximum", "F", "the largest of them"}};

inline std::optional<std::string> norm_violation(std::span<const std::vector<double>> values) {
  const std::size_t n = values[1].size();
  if (n >= 1 && n <= kNormInputs.size()) return std::nullopt;
  return "scale has " + std::to_string(n) + " entries; one to three are needed";
}

inline PathEvaluator make_norm(std::span<const std::vector<double>> values) {
  return [p = values[0][0], scale = values[1]](std::span<const double> inputs,
                                               std::span<double> outputs) {
    std::array<double, kNormInputs.size()> scaled{};
    for (std::size_t i = 0; i < scale.size(); ++i) scaled[i] = inputs[i] / scale[i];
    outputs[0] = norm(scaled, p);
    outputs[1] = norm(scaled, std::numeric_limits<double>::infinity());
  };
}

inline constexpr ClosedForm kNormForm{
    .name = "p_norm",
    .title = "Magnitude of a potential with any exponent, and its maximum",
    .formula = "P = (sum |f_i/R_i|^p)^(1/p)",
    .source = "docs/theory, section 7",
    .range = "p >= 1, R_i > 0; each row by itself",
    .parameters = kNormParameters,
    .inputs = kNormInputs,
    .outputs = kNormOutputs,
    .make = make_norm,
    .violation = norm_violation};

inline constexpr Parameter kMu{
    .name = "mu", .dimension = "1", .text = "friction coefficient", .lower = 0.0};
inline constexpr Parameter kNormalForce{
    .name = "normal_force", .dimension = "F", .text = "normal force", .lower = 0.0};
inline constexpr Parameter kScale1{.name = "scale1",
                                   .dimension = "1",
                                   .text = "scale of the first force (L for a moment)",
                                   .default_value = 1.0,
                                   .lower = 0.0,
                                   .lower_open = true};
inline constexpr Parameter kScale2{.name = "scale2",
                                   .dimension = "1",
                                   .text = "scale of the second force (L for a moment)",
                                   .default_value = 1.0,
                                   .lower = 0.0,
                                   .lower_open = true};

inline constexpr std::array kSliderParameters{kExponent, kMu, kNormalForce, kScale1, kScale2};
inline constexpr std::array kMotionInputs{
    Signal{"motion1", "L", "relative motion in the first direction (radians for a moment)"},
    Signal{"motion2", "L", "relative motion in the second direction"}};
inline constexpr std::array kSliderOutputs{
    Signal{"force1", "F", "friction force (or moment) in the first direction"},
    Signal{"force2", "F", "friction force (or moment) in the second direction"}};

inline std::optional<std::string> slider_violation(std::span<const std::vector<double>> values) {
  if (values[0][0] > 1.0) return std::nullopt;
  return "exponent is 1; the direction of the force needs an exponent above 1";
}

inline PathEvaluator make_slider(std::span<const std::vector<double>> values) {
  return [p = values[0][0], limit = values[1][0] * values[2][0],
          scale = Pair{values[3][0], values[4][0]}, motion = Pair{0.0, 0.0}, force = Pair{0.0, 0.0},
          started = false](std::span<const double> inputs, std::span<double> outputs) mutable {
    const Pair travel{inputs[0] - motion.first, inputs[1] - motion.second};
    if (started && (travel.first != 0.0 || travel.second != 0.0)) {
      force = steady_slip(limit, p, scale, travel).force;
    }
    started = true;
    motion = {inputs[0], inputs[1]};
    outputs[0] = force.first;
    outputs[1] = force.second;
  };
}

inline constexpr ClosedForm kSliderForm{
    .name = "p_norm_slider",
    .title = "Steady slip of two components coupled by a potential with any exponent",
    .formula = "f_i/R_i = mu N sign(d_i) (|d_i|/|d|_q)^(q-1), d_i = R_i du_i, q = p/(p-1)",
    .source = "Hoelder's inequality; derived in docs/theory",
    .range = "p > 1, R_i > 0; motion straight long enough for the elastic transient to die out",
    .parameters = kSliderParameters,
    .inputs = kMotionInputs,
    .outputs = kSliderOutputs,
    .make = make_slider,
    .violation = slider_violation};

inline constexpr std::array kBoxParameters{
    kMu, kNormalForce,
    Parameter{.name = "stick_stiffness",
              .dimension = "F/L",
              .text = "stiffness of the sticking contact in the scaled space, k R^2 in a component",
              .lower = 0.0,
              .lower_open = true},
    kScale1, kScale2};
inline constexpr std::array kBoxOutputs{
    kSliderOutputs[0], kSliderOutputs[1],
    Signal{"dissipation", "F L", "energy dissipated by both components"},
    Signal{"stored_energy", "F L", "energy held by the stick stiffness"}};

inline PathEvaluator make_box(std::span<const std::vector<double>> values) {
  const double limit = values[0][0] * values[1][0];
  const auto slider = [&](double scale) {
    return coulomb_slider::Slider{values[2][0] * scale * scale, limit * scale};
  };
  return [sliders = std::array{slider(values[3][0]), slider(values[4][0])},
          states = std::array<coulomb_slider::State, 2>{},
          started = false](std::span<const double> inputs, std::span<double> outputs) mutable {
    outputs[2] = 0.0;
    outputs[3] = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      states[i] = started ? coulomb_slider::advance(sliders[i], states[i], inputs[i])
                          : coulomb_slider::start(inputs[i]);
      outputs[i] = states[i].force;
      outputs[2] += states[i].dissipation;
      outputs[3] += coulomb_slider::stored_energy(sliders[i], states[i].force);
    }
    started = true;
  };
}

inline constexpr ClosedForm kBoxForm{
    .name = "maximum_slider",
    .title = "Two components coupled by the maximum: independent elastic Coulomb sliders",
    .formula = "f_i = k R_i^2 (u_i - z_i), |f_i| <= R_i mu N",
    .source = "docs/theory, section 7; Coulomb 1785",
    .range = "k > 0, R_i > 0; piecewise-linear motion with its turning points on rows",
    .parameters = kBoxParameters,
    .inputs = kMotionInputs,
    .outputs = kBoxOutputs,
    .make = make_box,
    .violation = no_violation};

}  // namespace slipbench::reference::p_norm
