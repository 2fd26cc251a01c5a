// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::reference {

/// A number, or a list of numbers, that a closed form needs before it can be evaluated.
///
/// `dimension` is written with F (force), L (length), T (time) and 1 (none; angles are radians; a
/// temperature is taken as it comes). The
/// admissible values lie in [lower, upper], in (lower, upper] if `lower_open`; for a list the
/// bounds hold for each entry. Without a default the parameter must be given.
struct Parameter {
  std::string_view name;
  std::string_view dimension;
  std::string_view text;
  std::optional<double> default_value = std::nullopt;
  bool list = false;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
};

/// A quantity read from, or compared with, one row of a result.
struct Signal {
  std::string_view name;
  std::string_view dimension;
  std::string_view text;
};

/// Of closed forms over time whose motion begins at an instant of its own.
inline constexpr Parameter kStartTime{.name = "start_time",
                                      .dimension = "T",
                                      .text = "time at which it begins",
                                      .default_value = 0.0};

/// Of closed forms that repeat themselves over time.
inline constexpr Parameter kPeriod{.name = "period",
                                   .dimension = "T",
                                   .text = "duration of a cycle",
                                   .lower = 0.0,
                                   .lower_open = true};

/// Streaming evaluation along a sampled path: called once a row, in order. `inputs` and `outputs`
/// have the sizes and the order of ClosedForm::inputs and ClosedForm::outputs. The first call is
/// the start of the path: the body is at rest and free of force there, and only differences of
/// motion count from then on, unless the closed form says otherwise. Time is that of the row; it
/// never falls.
using PathEvaluator =
    std::function<void(std::span<const double> inputs, std::span<double> outputs)>;

/// The phase 2 pi (t - start)/period [1].
inline double phase_at(double time, double start_time, double period) {
  return 2.0 * std::numbers::pi * ((time - start_time) / period);
}

/// Everything the catalogue knows of one closed form.
///
/// `make` returns a fresh evaluator for parameter values in the order of `parameters` (one entry
/// for a scalar); the values must lie within their bounds and keep `violation`. `violation` checks
/// the rules between parameters and returns a sentence if one is broken.
struct ClosedForm {
  std::string_view name;
  std::string_view title;
  std::string_view formula;
  std::string_view source;
  std::string_view range;
  std::span<const Parameter> parameters;
  std::span<const Signal> inputs;
  std::span<const Signal> outputs;
  PathEvaluator (*make)(std::span<const std::vector<double>> parameter_values);
  std::optional<std::string> (*violation)(std::span<const std::vector<double>> parameter_values);
};

/// The `violation` of a closed form whose parameters obey their own bounds only.
inline std::optional<std::string> no_violation(std::span<const std::vector<double>>) {
  return std::nullopt;
}

}  // namespace slipbench::reference
