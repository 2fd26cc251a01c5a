// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/base/text/history_error.hpp"
#include "driver/base/units/expression.hpp"
#include "driver/base/units/units.hpp"

namespace slipbench::driver::history {

// The value of one quantity within a step, as a function of the time t since the step's start,
// 0 <= t <= duration. Values are in the case's units, phases in radians.

/// The same value over the whole step; a quantity that had another value jumps at the step's start.
struct Constant {
  double value = 0.0;
};

/// Linear from the current value to `value` at the step's end.
struct LinearTo {
  double value = 0.0;
};

/// From the current value to `value` with zero rate and zero acceleration at both ends:
/// xi^3 (10 - 15 xi + 6 xi^2) of the way at xi = t/duration (the smooth step amplitude curve usual
/// in finite-element solvers).
struct SmoothTo {
  double value = 0.0;
};

enum class WaveShape { kSine, kTriangle, kSawtooth, kSquare };

/// mean + amplitude * shape(t/period + phase/(2 pi)). Every shape has period 1 and range [-1, 1],
/// and passes 0 upward at 0 (the square jumps there): the sine; the triangle, with its peak at 1/4
/// and its trough at 3/4; the sawtooth, which rises over the whole period and jumps down at 1/2;
/// the square, +1 in the first half, -1 in the second.
struct Wave {
  WaveShape shape = WaveShape::kSine;
  double amplitude = 1.0;
  double period = 1.0;  ///< > 0
  double mean = 0.0;
  double phase = 0.0;
};

/// Points in the order of their times, linear between them and held before the first and after the
/// last.
struct Tabular {
  std::vector<double> times;   ///< Strictly increasing, two or more.
  std::vector<double> values;  ///< One per time.
};

/// Two columns of a CSV file, linear between its rows, streamed. The rows must cover the step.
struct CsvColumn {
  base::DataSource data;
  std::string time_column;
  base::UnitConversion time_conversion;
  std::string value_column;
  base::UnitConversion value_conversion;
};

/// A formula in t (time in the step) and T (total time), compiled by `compile_profile`.
struct ExpressionProfile {
  base::Expression expression;
};

/// A formula in t, T and the six positions CP1 .. CPR3 of the same instant, in this order: a force
/// that follows the motion.
struct PositionFormula {
  base::Expression expression;
};

using Profile = std::variant<Constant, LinearTo, SmoothTo, Wave, Tabular, CsvColumn,
                             ExpressionProfile, PositionFormula>;

/// Number of positions that a PositionFormula knows.
inline constexpr std::size_t kPositions = 6;

/// Compiles a profile's formula over t, T and the case's parameters. Errors: those of
/// `Expression::compile`.
tl::expected<ExpressionProfile, base::ExpressionError> compile_profile(
    std::string_view text, const base::NamedNumbers& parameters);

/// Returns what is wrong with the points of `table` (too few, times not increasing, sizes that
/// differ, not finite), as a sentence; nothing when it is sound.
std::optional<std::string> violation(const Tabular& table);

/// Returns what is wrong with `wave` (a period that is not positive, anything not finite, a phase
/// of more than 1e9).
std::optional<std::string> violation(const Wave& wave);

/// Tells whether the table's times reach from the start of a step to its end at `duration`, apart
/// from the last digits of numbers in text (`kCoverageSlack`).
bool covers(const Tabular& table, double duration);

/// Times in text have finitely many digits: data that miss an end of the step by no more than this
/// part of its duration still cover it, and are held over the gap.
inline constexpr double kCoverageSlack = 1e-9;

/// Start of a step for one quantity.
struct StepStart {
  double duration = 1.0;       ///< > 0
  double current_value = 0.0;  ///< The value at the end of the step before, where LinearTo starts.
  double total_time = 0.0;     ///< Total time at the step's start.
  std::array<double, kPositions> position{};  ///< CP1 .. CPR3 there.
};

}  // namespace slipbench::driver::history
