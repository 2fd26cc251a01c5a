// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <utility>

#include "driver/base/text/history_error.hpp"
#include "driver/history/measured_history.hpp"
#include "driver/history/profile.hpp"

namespace slipbench::driver::history {

/// The breakpoint of a profile that has none left.
inline constexpr double kNoBreakpoint = std::numeric_limits<double>::infinity();

/// Walks through a profile as a step goes on. `open` once, `begin` at each start of the step (a
/// repeated step begins anew), then ask with times that never decrease within the step. Asking
/// allocates nothing.
///
/// Times within kSameTime*duration of a jump count as the jump itself: `value` is then the value
/// before it, `value_after` the one behind it.
///
/// A formula that has no value, and data that turn out faulty or too short, show only on the way:
/// `value` is then NaN, and `error` says why from then on.
class ProfileCursor {
 public:
  /// Prepares to walk through `profile`. Errors: an unsound wave or table (`violation`); those of
  /// `MeasuredHistory::open` for a CSV file.
  static tl::expected<ProfileCursor, base::HistoryError> open(Profile profile);

  /// Goes to the start of a step. Errors: a CSV file that starts later than the step, or whose
  /// first rows are faulty; a formula without value at t = 0; a wave with more than a billion
  /// periods in the step.
  tl::expected<void, base::HistoryError> begin(const StepStart& start);

  /// The value at `t`; where the profile jumps, its limit from the left.
  double value(double t);
  /// The same at several times, ascending and up to the next breakpoint.
  /// \param values as many as times
  void values(std::span<const double> times, std::span<double> values);

  /// The value just after `t`: the limit from the right where the profile jumps, else `value(t)`.
  double value_after(double t);

  /// Tells whether the value depends on where the connector is.
  bool follows_position() const { return std::holds_alternative<PositionFormula>(profile_); }

  /// Says where the connector is at the times that are asked for next, CP1 .. CPR3; `begin` takes
  /// the position of the step's start. Such values may be asked for in any order of times.
  void set_position(std::span<const double, kPositions> position) {
    std::copy(position.begin(), position.end(), start_.position.begin());
  }

  /// The value just after the step's start, 0. (A `Constant` has jumped there.)
  double start_value() const { return start_value_; }

  /// The first corner, jump, point of a table or row of a file after `t`; kNoBreakpoint if none.
  double next_breakpoint(double t);

  /// Returns what went wrong since `begin`, if anything.
  const std::optional<base::HistoryError>& error() const { return error_; }

 private:
  explicit ProfileCursor(Profile profile) : profile_(std::move(profile)) {}

  /// A wave between two of its corners or jumps.
  struct WavePiece {
    double begin = 0.0;
    double end = -1.0;  ///< Before `begin`: no piece.
    double sign = 1.0;  ///< Of the value at its begin (triangle) or all along (square).

    /// The piece from corner number `corner` to the next.
    static WavePiece starting_at(const Wave& wave, double corner);
    double value(const Wave& wave, double t) const;
  };

  struct Row {
    double time = 0.0;
    double value = 0.0;
  };

  double value_of(const Constant& profile, double t);
  double value_of(const LinearTo& profile, double t);
  double value_of(const SmoothTo& profile, double t);
  double value_of(const Wave& profile, double t);
  double value_of(const Tabular& profile, double t);
  double value_of(const CsvColumn& profile, double t);
  double value_of(const ExpressionProfile& profile, double t);
  double value_of(const PositionFormula& profile, double t);
  double value_of(const base::Expression& expression, std::span<const double> variables);

  tl::expected<void, base::HistoryError> begin_csv();
  bool read_row();
  double fail(base::HistoryError error);

  Profile profile_;
  StepStart start_;     ///< Its position is that of the times asked for.
  double merge_ = 0.0;  ///< Times this close are the same.
  double start_value_ = 0.0;
  std::optional<base::HistoryError> error_;

  WavePiece piece_;  ///< Wave: where the last value asked for lay.

  std::size_t point_ = 0;  ///< Tabular: the first point not before the last time asked for.

  std::optional<MeasuredHistory> data_;  ///< CsvColumn: the file, and its rows around t.
  Row earlier_;
  Row later_;
  bool data_ended_ = false;
};

/// The first breakpoint of any of the profiles after `t`; kNoBreakpoint if none.
double next_breakpoint(std::span<ProfileCursor> cursors, double t);

}  // namespace slipbench::driver::history
