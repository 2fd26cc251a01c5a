// SPDX-License-Identifier: Apache-2.0
#include "driver/history/profile_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver::history {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The corners or jumps of a wave, in periods from phase 0: first + k * spacing.
struct Corners {
  double first;
  double spacing;
};

Corners corners(WaveShape shape) {
  if (shape == WaveShape::kTriangle) return {0.25, 0.5};
  if (shape == WaveShape::kSawtooth) return {0.5, 1.0};
  return {0.0, 0.5};
}

/// Time of corner k: one multiplication from its number, so that it is as exact in the millionth
/// period as in the first.
double corner_time(const Wave& wave, double k) {
  const auto [first, spacing] = corners(wave.shape);
  return (first + k * spacing - wave.phase / (2.0 * std::numbers::pi)) * wave.period;
}

/// The last corner at or before `t`, up to rounding in either direction.
double corner_near(const Wave& wave, double t) {
  const auto [first, spacing] = corners(wave.shape);
  return std::floor((t / wave.period + wave.phase / (2.0 * std::numbers::pi) - first) / spacing);
}

/// The corner k that starts the piece to the left of `t`: corner k < t <= corner k+1.
double piece_before(const Wave& wave, double t, double merge) {
  double k = corner_near(wave, t);
  while (t > corner_time(wave, k + 1.0) + merge) ++k;
  while (t <= corner_time(wave, k) + merge) --k;
  return k;
}

/// The corner k that starts the piece to the right of `t`: corner k <= t < corner k+1.
double piece_after(const Wave& wave, double t, double merge) {
  double k = corner_near(wave, t);
  while (t >= corner_time(wave, k + 1.0) - merge) ++k;
  while (t < corner_time(wave, k) - merge) --k;
  return k;
}

double sine(const Wave& wave, double t) {
  return wave.mean +
         wave.amplitude * std::sin(2.0 * std::numbers::pi * (t / wave.period) + wave.phase);
}

}  // namespace

ProfileCursor::WavePiece ProfileCursor::WavePiece::starting_at(const Wave& wave, double corner) {
  return {corner_time(wave, corner), corner_time(wave, corner + 1.0),
          std::fmod(corner, 2.0) == 0.0 ? 1.0 : -1.0};
}

double ProfileCursor::WavePiece::value(const Wave& wave, double t) const {
  const double xi = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
  switch (wave.shape) {
    case WaveShape::kTriangle:
      return wave.mean + wave.amplitude * (sign * (1.0 - 2.0 * xi));
    case WaveShape::kSawtooth:
      return wave.mean + wave.amplitude * (2.0 * xi - 1.0);
    case WaveShape::kSquare:
      return wave.mean + wave.amplitude * sign;
    case WaveShape::kSine:
      break;
  }
  return sine(wave, t);
}

tl::expected<ProfileCursor, base::HistoryError> ProfileCursor::open(Profile profile) {
  if (const auto* wave = std::get_if<Wave>(&profile)) {
    if (auto fault = violation(*wave)) return base::input_error(std::move(*fault));
  }
  if (const auto* table = std::get_if<Tabular>(&profile)) {
    if (auto fault = violation(*table)) return base::input_error(std::move(*fault));
  }
  ProfileCursor cursor(std::move(profile));
  if (const auto* csv = std::get_if<CsvColumn>(&cursor.profile_)) {
    auto data = MeasuredHistory::open({csv->data,
                                       csv->time_column,
                                       csv->time_conversion,
                                       {{0, csv->value_column, csv->value_conversion}},
                                       false});
    if (!data) return tl::unexpected(std::move(data.error()));
    cursor.data_ = std::move(*data);
  }
  return cursor;
}

tl::expected<void, base::HistoryError> ProfileCursor::begin(const StepStart& start) {
  start_ = start;
  merge_ = kSameTime * start.duration;
  error_.reset();
  point_ = 0;
  piece_ = {};
  if (const auto* wave = std::get_if<Wave>(&profile_)) {
    constexpr double kMostPeriods = 1e9;
    if (start.duration / wave->period > kMostPeriods) {
      return base::input_error(
          fmt::format("a period of {} is less than a billionth of the step", wave->period));
    }
  }
  if (data_) {
    if (auto begun = begin_csv(); !begun) return begun;
  }
  start_value_ = value_after(0.0);
  if (error_) return tl::unexpected(*error_);
  return {};
}

double ProfileCursor::value(double t) {
  return std::visit([&](const auto& profile) { return value_of(profile, t); }, profile_);
}

void ProfileCursor::values(std::span<const double> times, std::span<double> values) {
  const auto* wave = std::get_if<Wave>(&profile_);
  if (wave != nullptr && wave->shape == WaveShape::kSine) {
    for (std::size_t k = 0; k < times.size(); ++k) values[k] = sine(*wave, times[k]);
    return;
  }
  std::visit(
      [&](const auto& profile) {
        for (std::size_t k = 0; k < times.size(); ++k) values[k] = value_of(profile, times[k]);
      },
      profile_);
}

double ProfileCursor::value_after(double t) {
  if (const auto* wave = std::get_if<Wave>(&profile_); wave && wave->shape != WaveShape::kSine) {
    return WavePiece::starting_at(*wave, piece_after(*wave, t, merge_)).value(*wave, t);
  }
  return value(t);
}

double ProfileCursor::value_of(const Constant& profile, double /*t*/) { return profile.value; }

double ProfileCursor::value_of(const LinearTo& profile, double t) {
  if (t >= start_.duration) return profile.value;
  return start_.current_value + (profile.value - start_.current_value) * (t / start_.duration);
}

double ProfileCursor::value_of(const SmoothTo& profile, double t) {
  if (t >= start_.duration) return profile.value;
  const double xi = t / start_.duration;
  const double part = xi * xi * xi * (10.0 + xi * (6.0 * xi - 15.0));
  return start_.current_value + (profile.value - start_.current_value) * part;
}

double ProfileCursor::value_of(const Wave& profile, double t) {
  if (profile.shape == WaveShape::kSine) return sine(profile, t);
  if (!(t > piece_.begin + merge_ && t <= piece_.end + merge_)) {
    piece_ = WavePiece::starting_at(profile, piece_before(profile, t, merge_));
  }
  return piece_.value(profile, t);
}

double ProfileCursor::value_of(const Tabular& profile, double t) {
  const std::size_t last = profile.times.size() - 1;
  while (point_ < last && profile.times[point_] < t) ++point_;
  const std::size_t i = point_;
  if (i == 0 || t >= profile.times[i]) return profile.values[i];
  return between_rows(profile.times[i - 1], profile.values[i - 1], profile.times[i],
                      profile.values[i], t, false);
}

double ProfileCursor::value_of(const CsvColumn& /*profile*/, double t) {
  while (later_.time < t && !data_ended_) {
    if (!read_row()) return kNaN;
  }
  if (error_) return kNaN;
  if (t > later_.time + kCoverageSlack * start_.duration) {
    return fail(data_
                    ->error_here(fmt::format("the data end at t = {}; the step lasts to t = {}",
                                             later_.time, start_.duration))
                    .value());
  }
  return between_rows(earlier_.time, earlier_.value, later_.time, later_.value, t, false);
}

double ProfileCursor::value_of(const ExpressionProfile& profile, double t) {
  return value_of(profile.expression, std::array{t, start_.total_time + t});
}

double ProfileCursor::value_of(const PositionFormula& profile, double t) {
  std::array<double, 2 + kPositions> values{t, start_.total_time + t};
  std::copy(start_.position.begin(), start_.position.end(), values.begin() + 2);
  return value_of(profile.expression, values);
}

double ProfileCursor::value_of(const base::Expression& expression,
                               std::span<const double> variables) {
  auto value = expression(variables);
  if (value) return *value;
  return fail({base::HistoryError::Kind::kInput, {}, 0, 0, std::move(value.error().message)});
}

double ProfileCursor::next_breakpoint(double t) {
  if (const auto* wave = std::get_if<Wave>(&profile_)) {
    if (wave->shape == WaveShape::kSine) return kNoBreakpoint;
    if (t >= piece_.begin - merge_ && t < piece_.end - merge_) return piece_.end;
    return corner_time(*wave, piece_after(*wave, t, merge_) + 1.0);
  }
  if (const auto* table = std::get_if<Tabular>(&profile_)) {
    std::size_t i = point_;
    while (i < table->times.size() && table->times[i] <= t + merge_) ++i;
    return i < table->times.size() ? table->times[i] : kNoBreakpoint;
  }
  if (data_) {
    while (later_.time <= t + merge_ && !data_ended_) {
      if (!read_row()) return kNoBreakpoint;
    }
    return later_.time > t + merge_ ? later_.time : kNoBreakpoint;
  }
  return kNoBreakpoint;
}

/// Reads the file anew up to the first row after the step's start.
tl::expected<void, base::HistoryError> ProfileCursor::begin_csv() {
  data_ended_ = false;
  if (auto rewound = data_->rewind(); !rewound) return rewound;
  for (int rows = 0; rows < 2 && !data_ended_; ++rows) {
    if (!read_row()) return tl::unexpected(*error_);
    if (rows == 0 && later_.time > kCoverageSlack * start_.duration) {
      return data_->error_here(
          fmt::format("the data start at t = {}; the step starts at t = 0", later_.time));
    }
  }
  return {};
}

/// Moves the pair of rows on by one, or notes the end of the data; false after an error.
bool ProfileCursor::read_row() {
  if (error_) return false;
  auto row = data_->advance();
  if (!row) {
    fail(std::move(row.error()));
    return false;
  }
  if (!*row) {
    data_ended_ = true;
    return true;
  }
  earlier_ = std::exchange(later_, {data_->time(), data_->values().front()});
  return true;
}

double ProfileCursor::fail(base::HistoryError error) {
  if (!error_) error_ = std::move(error);
  return kNaN;
}

double next_breakpoint(std::span<ProfileCursor> cursors, double t) {
  double first = kNoBreakpoint;
  for (ProfileCursor& cursor : cursors) first = std::min(first, cursor.next_breakpoint(t));
  return first;
}

}  // namespace slipbench::driver::history
