// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "reference/closed_form.hpp"

/// The first-order recursive filter of a force: its answer to a step, to a harmonic and to any
/// history, without the recursion.
///
/// Formula   The recursion F_n = a R_n + (1 - a) F_n-1 from F_0 = 0 has the sum F_n = sum over k
///           from 1 to n of a (1 - a)^(n-k) R_k. Step R_n = R: F_n = R (1 - (1 - a)^n). Harmonic
///           R_n = m + A sin(n w): F_n = S_n - (1 - a)^n S_0, S_n = m + g A sin(n w + phi), with
///           1/g^2 = 1 + 4 (1 - a) sin^2(w/2)/a^2 and tan(phi) = -(1 - a) sin(w)/(1 - (1 - a)
///           cos(w)). g^2 = 1/2 at w = 2 asin(a/(2 sqrt(1 - a))), the same as cos(w) = 1 - a^2/(2
///           (1 - a)).
/// Symbols   a smoothing factor [1], R_n force before, F_n after the filter at the end of the n-th
///           increment [F], w angle that the harmonic turns in an increment [1], g gain [1], phi
///           phase [1].
/// Source    solution of the recursion of the Radioss reference guide, /FRICTION (Ifiltr);
///           derived in docs/theory.
/// Range     equal increments; 0 < a < 2 settles, a = 1 passes all, 1 < a < 2 overshoots from
///           increment to increment, a >= 2 grows without bound. Half power only for a <= 2
///           (sqrt(2) - 1).
namespace slipbench::reference::first_order_filter {

/// 1 - (1 - a)^n [1], n >= 0 whole: the answer to a unit step after n increments.
inline double step_response(double smoothing, double increments) {
  if (smoothing < 1.0) return -std::expm1(increments * std::log1p(-smoothing));
  return 1.0 - std::pow(1.0 - smoothing, increments);
}

/// Gain g [1] of a harmonic that turns by w [1] in an increment.
inline double gain(double smoothing, double angular_step) {
  const double s = std::sin(0.5 * angular_step);
  return 1.0 / std::sqrt(1.0 + 4.0 * (1.0 - smoothing) * s * s / (smoothing * smoothing));
}

/// Phase phi [1] of that harmonic; negative: the filtered force is late.
inline double phase(double smoothing, double angular_step) {
  const double rest = 1.0 - smoothing;
  return -std::atan2(rest * std::sin(angular_step), 1.0 - rest * std::cos(angular_step));
}

/// Angular step [1] at which the power is halved (-3 dB); nothing if no harmonic is.
inline std::optional<double> half_power_step(double smoothing) {
  if (smoothing > 2.0 * (std::numbers::sqrt2 - 1.0)) return std::nullopt;
  return 2.0 * std::asin(0.5 * smoothing / std::sqrt(1.0 - smoothing));
}

/// A mean [F] with a harmonic of the amplitude [F] about it.
struct Harmonic {
  double mean;
  double amplitude;
  double angular_step;  ///< w [1]
};

/// R_n [F] at the end of the n-th increment.
inline double unfiltered(const Harmonic& harmonic, double increments) {
  return harmonic.mean + harmonic.amplitude * std::sin(harmonic.angular_step * increments);
}

/// S_n [F], what the filter settles to.
inline double steady(double smoothing, const Harmonic& harmonic, double increments) {
  const double w = harmonic.angular_step;
  return harmonic.mean +
         gain(smoothing, w) * harmonic.amplitude * std::sin(w * increments + phase(smoothing, w));
}

/// F_n [F] from F_0 = 0.
inline double from_rest(double smoothing, const Harmonic& harmonic, double increments) {
  const double forgotten = step_response(smoothing, increments);
  return steady(smoothing, harmonic, increments) -
         (1.0 - forgotten) * steady(smoothing, harmonic, 0.0);
}

/// F_n [F] of the forces R_1 .. R_n [F]: the sum, newest first, up to weights that count.
inline double filtered(double smoothing, std::span<const double> forces) {
  double sum = 0.0;
  double weight = smoothing;
  for (std::size_t i = forces.size(); i-- > 0 && std::abs(weight) > 1e-25 * smoothing;) {
    sum += weight * forces[i];
    weight *= 1.0 - smoothing;
  }
  return sum;
}

/// Whole increments [1] since the start; 0 before it.
inline double increments_at(double time, double start_time, double increment) {
  return std::max(std::round((time - start_time) / increment), 0.0);
}

inline constexpr Parameter kSmoothing{.name = "smoothing",
                                      .dimension = "1",
                                      .text = "share a of the new force in an increment",
                                      .lower = 0.0,
                                      .lower_open = true};
inline constexpr Parameter kTimeIncrement{.name = "time_increment",
                                          .dimension = "T",
                                          .text = "time from row to row",
                                          .lower = 0.0,
                                          .lower_open = true};
inline constexpr std::array kTimeInputs{
    Signal{"time", "T", "time, a whole number of increments after the start"}};

inline constexpr std::array kStepParameters{
    kSmoothing, kTimeIncrement,
    Parameter{
        .name = "value", .dimension = "F", .text = "force before the filter", .default_value = 1.0},
    kStartTime};
inline constexpr std::array kStepOutputs{
    Signal{"force", "F", "force after the filter"},
    Signal{"increments", "1", "whole increments since the start"}};

inline PathEvaluator make_step(std::span<const std::vector<double>> values) {
  return [smoothing = values[0][0], increment = values[1][0], value = values[2][0],
          start_time = values[3][0]](std::span<const double> inputs, std::span<double> outputs) {
    outputs[1] = increments_at(inputs[0], start_time, increment);
    outputs[0] = value * step_response(smoothing, outputs[1]);
  };
}

inline constexpr ClosedForm kStepForm{
    .name = "filter_step_response",
    .title = "Filtered force after the unfiltered one has jumped from 0 to a constant",
    .formula = "F_n = R (1 - (1 - a)^n)",
    .source = "solution of the recursion of the Radioss reference guide, /FRICTION",
    .range = "a > 0; equal increments, the first one ends a time increment after the start",
    .parameters = kStepParameters,
    .inputs = kTimeInputs,
    .outputs = kStepOutputs,
    .make = make_step,
    .violation = no_violation};

inline constexpr std::array kHarmonicParameters{kSmoothing,
                                                kTimeIncrement,
                                                kPeriod,
                                                Parameter{.name = "amplitude",
                                                          .dimension = "F",
                                                          .text = "of the force before the filter",
                                                          .default_value = 1.0},
                                                Parameter{.name = "mean",
                                                          .dimension = "F",
                                                          .text = "of the force before the filter",
                                                          .default_value = 0.0},
                                                kStartTime};
inline constexpr std::array kHarmonicOutputs{
    Signal{"force", "F", "force after the filter, from no force at the start"},
    Signal{"steady_force", "F", "what it settles to"},
    Signal{"unfiltered_force", "F", "mean + amplitude sin(2 pi (t - start)/period)"},
    Signal{"gain", "1", "ratio of the amplitudes after and before the filter"},
    Signal{"phase", "1", "angle by which the filtered force leads, negative: it is late"},
    Signal{"half_power_period", "T", "period at which the gain is 1/sqrt(2); 0: there is none"}};

inline PathEvaluator make_harmonic(std::span<const std::vector<double>> values) {
  const double smoothing = values[0][0];
  const double increment = values[1][0];
  const Harmonic harmonic{values[4][0], values[3][0],
                          2.0 * std::numbers::pi * increment / values[2][0]};
  return [=, start_time = values[5][0]](std::span<const double> inputs, std::span<double> outputs) {
    const double n = increments_at(inputs[0], start_time, increment);
    const auto half_power = half_power_step(smoothing);
    outputs[0] = from_rest(smoothing, harmonic, n);
    outputs[1] = steady(smoothing, harmonic, n);
    outputs[2] = unfiltered(harmonic, n);
    outputs[3] = gain(smoothing, harmonic.angular_step);
    outputs[4] = phase(smoothing, harmonic.angular_step);
    outputs[5] = half_power ? 2.0 * std::numbers::pi * increment / *half_power : 0.0;
  };
}

inline constexpr ClosedForm kHarmonicForm{
    .name = "filter_harmonic",
    .title = "Filtered force of a harmonic one: exact gain and phase, from rest",
    .formula = "1/g^2 = 1 + 4 (1 - a) sin^2(w/2)/a^2, tan(phi) = -(1-a) sin w/(1 - (1-a) cos w)",
    .source = "solution of the recursion of the Radioss reference guide, /FRICTION",
    .range = "0 < a < 2; equal increments, w = 2 pi dt/period",
    .parameters = kHarmonicParameters,
    .inputs = kTimeInputs,
    .outputs = kHarmonicOutputs,
    .make = make_harmonic,
    .violation = no_violation};

inline constexpr std::array kSignalParameters{kSmoothing};
inline constexpr std::array kSignalInputs{
    Signal{"unfiltered_force", "F", "force before the filter; that of the first row has no effect"},
    Signal{"normal_force", "F", "normal force; where it is 0 the filter forgets"}};
inline constexpr std::array kSignalOutputs{Signal{"force", "F", "force after the filter"}};

inline PathEvaluator make_signal(std::span<const std::vector<double>> values) {
  return [smoothing = values[0][0], forces = std::vector<double>{}, started = false](
             std::span<const double> inputs, std::span<double> outputs) mutable {
    if (inputs[1] <= 0.0) {
      forces.clear();
    } else if (started) {
      forces.push_back(inputs[0]);
    }
    started = true;
    outputs[0] = filtered(smoothing, forces);
  };
}

inline constexpr ClosedForm kSignalForm{
    .name = "filtered_force",
    .title = "Filtered force of any history, as a sum over its past",
    .formula = "F_n = sum over k of a (1 - a)^(n-k) R_k since contact began",
    .source = "solution of the recursion of the Radioss reference guide, /FRICTION",
    .range = "0 < a < 2; rows are increments",
    .parameters = kSignalParameters,
    .inputs = kSignalInputs,
    .outputs = kSignalOutputs,
    .make = make_signal,
    .violation = no_violation};

}  // namespace slipbench::reference::first_order_filter
