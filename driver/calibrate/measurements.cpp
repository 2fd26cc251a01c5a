// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/files/sha256.hpp"
#include "driver/calibrate/cleaning/average_cycles.hpp"
#include "driver/calibrate/cleaning/data_rows.hpp"
#include "driver/calibrate/cleaning/dead_band.hpp"
#include "driver/calibrate/cleaning/resample.hpp"

namespace slipbench::driver::calibrate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double converted(const DataColumn& column, double number) {
  return column.factor * column.conversion(number) + column.offset;
}

/// "0.31 kN": a number as messages show it.
std::string amount(double value, const base::Dimension& dimension, const base::UnitSystem& units) {
  const std::string unit = base::unit_text(dimension, units);
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

/// "within 3 .. 5 s", "from 3 s on", "up to 5 s".
std::string range_words(const std::optional<double>& from, const std::optional<double>& to,
                        const base::UnitSystem& units) {
  if (!to) return "from " + amount(*from, base::kTime, units) + " on";
  if (!from) return "up to " + amount(*to, base::kTime, units);
  return fmt::format("within {:.4g} .. {}", *from, amount(*to, base::kTime, units));
}

std::string rows_word(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " row" : " rows");
}

/// Times that rows cover.
struct Span {
  double first = 0.0;
  double last = 0.0;
  double step = 0.0;  ///< between two rows, on average

  std::size_t whole_cycles(double period) const {
    return slipbench::driver::cleaning::whole_cycles(first, last, period, step);
  }
};

Span span_of(const std::vector<double>& time) {
  const auto intervals = static_cast<double>(time.size() - 1);
  const double extent = time.back() - time.front();
  return {time.front(), time.back(), time.size() > 1 ? extent / intervals : 0.0};
}

/// Reads and cleans one data file; each step works on what the last one left.
class Cleaner {
 public:
  explicit Cleaner(const ExperimentFit& experiment)
      : experiment_(experiment), units_(experiment.base.units) {}

  tl::expected<Measurements, base::HistoryError> clean() {
    if (auto read = read_rows(); !read) return tl::unexpected(std::move(read.error()));
    result_.rows_read = rows_.size();
    tell_conversions();
    in_file_ = span_of(rows_.time);
    keep_range();
    if (rows_.size() == 0) return refused("no row lies " + range());
    in_range_ = span_of(rows_.time);
    leave_out_slow_rows();
    if (rows_.size() == 0) return refused("every row is in the dead band");
    if (auto averaged = average(); !averaged) return tl::unexpected(std::move(averaged.error()));
    if (auto spread = resample(); !spread) return tl::unexpected(std::move(spread.error()));
    return split();
  }

 private:
  tl::expected<void, base::HistoryError> read_rows() {
    columns_.push_back(&experiment_.time);
    for (const ResponseFit& response : experiment_.responses) {
      columns_.push_back(&response.column);
      if (response.over) columns_.push_back(&response.over_column);
    }
    if (experiment_.dead_band) columns_.push_back(&experiment_.dead_band->column);
    std::vector<std::string> names;
    for (const DataColumn* column : columns_) names.push_back(column->name);
    auto reader = base::CsvReader::open(
        base::DataSource{experiment_.data_path, experiment_.data_file, experiment_.data_format},
        names);
    if (!reader) return tl::unexpected(std::move(reader.error()));

    rows_.columns.resize(columns_.size());
    std::vector<double> row(columns_.size());
    double raw_before = 0.0;
    long line_before = 0;
    for (;;) {
      const auto more = reader->next(row);
      if (!more) return tl::unexpected(more.error());
      if (!*more) break;
      const double raw = row.front();
      // The comparison is made on the file's own numbers, which the user can look up.
      if (!rows_.time.empty() && !(raw > raw_before)) {
        return reader->error_here(
            fmt::format("the time '{}' does not increase: {} after {} in "
                        "line {}{}",
                        experiment_.time.name, raw, raw_before, line_before,
                        base::of_held_time(experiment_.data_format, raw, raw_before)));
      }
      bool finite = true;
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        row[c] = converted(*columns_[c], row[c]);
        finite &= std::isfinite(row[c]);
      }
      if (!finite) {
        return reader->error_here("a number exceeds the range of a double in the case's unit");
      }
      if (!rows_.time.empty() && !(row.front() > rows_.time.back())) {
        return reader->error_here(
            fmt::format("the times {} and {} are the same in the case's unit", raw_before, raw));
      }
      raw_before = raw;
      line_before = reader->line();
      rows_.time.push_back(row.front());
      rows_.columns.front().push_back(static_cast<double>(line_before));
      for (std::size_t c = 1; c < columns_.size(); ++c) rows_.columns[c].push_back(row[c]);
    }
    const base::MissingSample answer = experiment_.data_format.missing;
    if (std::string text = base::in_words(reader->missing(), answer); !text.empty()) {
      tell(std::move(text));
    }
    return {};
  }

  void tell_conversions() {
    for (const DataColumn* column : columns_) {
      if (column->factor == 1.0 && column->offset == 0.0) continue;
      std::string text = "'" + column->name + "'";
      if (column->factor != 1.0) text += fmt::format(" times {}", column->factor);
      if (column->offset != 0.0) {
        const std::string_view sign = column->offset > 0.0 ? "plus" : "minus";
        text += fmt::format(" {} {}", sign, std::abs(column->offset));
      }
      const auto& told = result_.cleaning;
      if (std::find(told.begin(), told.end(), text) == told.end()) tell(std::move(text));
    }
  }

  void tell(std::string text) { result_.cleaning.push_back(std::move(text)); }

  std::string range() const { return range_words(experiment_.from, experiment_.to, units_); }

  void keep_range() {
    if (!experiment_.from && !experiment_.to) return;
    const std::size_t before = rows_.size();
    const auto begin = std::lower_bound(rows_.time.begin(), rows_.time.end(),
                                        experiment_.from.value_or(-kInfinity));
    const auto end = std::upper_bound(begin, rows_.time.end(), experiment_.to.value_or(kInfinity));
    const auto cut = [first = begin - rows_.time.begin(),
                      last = end - rows_.time.begin()](std::vector<double>& numbers) {
      numbers = std::vector<double>(numbers.begin() + first, numbers.begin() + last);
    };
    for (std::vector<double>& column : rows_.columns) cut(column);
    cut(rows_.time);
    tell(fmt::format("{} of {} lie {}", rows_.size(), rows_word(before), range()));
  }

  void leave_out_slow_rows() {
    if (!experiment_.dead_band) return;
    const DeadBand& band = *experiment_.dead_band;
    const std::size_t before = rows_.size();
    std::vector<double> speed = rows_.columns.back();
    // A single row tells no speed.
    if (band.of_position)
      speed = before > 1 ? cleaning::slopes(rows_.time, speed) : std::vector(1, 0.0);
    rows_ = cleaning::without_slow_rows(rows_, speed, band.below);
    tell(fmt::format("{} with a speed below {} left out", rows_word(before - rows_.size()),
                     amount(band.below, band.speed, units_)));
  }

  tl::expected<void, base::HistoryError> average() {
    if (!experiment_.average_cycles) return {};
    const auto& [period, points] = *experiment_.average_cycles;
    const std::size_t cycles = in_range_.whole_cycles(period);
    const std::size_t all = in_file_.whole_cycles(period);
    if (cycles == 0) {
      return refused(fmt::format("there is no whole cycle of {} from {:.6g} to {}",
                                 amount(period, base::kTime, units_), in_range_.first,
                                 amount(in_range_.last, base::kTime, units_)));
    }
    constexpr double kMostAveraged = 4.0e7;
    if (static_cast<double>(cycles) * points > kMostAveraged) {
      return refused(fmt::format("average_cycles: {} points of {} cycles of {} are more than {:g}",
                                 points, cycles, amount(period, base::kTime, units_),
                                 kMostAveraged));
    }
    cleaning::MeanCycle mean = cleaning::mean_cycle(rows_, in_range_.first, period, cycles, points);
    rows_ = std::move(mean.rows);
    if (rows_.size() == 0) return refused("every row is in the dead band");
    const std::string of_all = all > cycles
                                   ? fmt::format("{} of {} cycles", cycles, all)
                                   : fmt::format("{} cycle{}", cycles, cycles == 1 ? "" : "s");
    if (cycles == 1) {
      tell(fmt::format("{} brought to {}", of_all, rows_word(rows_.size())));
      return {};
    }
    std::string scatter;
    std::size_t column = 1;
    for (const ResponseFit& response : experiment_.responses) {
      if (!scatter.empty()) scatter += ", ";
      if (experiment_.responses.size() > 1) scatter += response.quantity_text + " by ";
      scatter += response.dimension ? amount(mean.scatter[column], *response.dimension, units_)
                                    : fmt::format("{:.4g}", mean.scatter[column]);
      column += response.over ? 2 : 1;
    }
    tell(fmt::format("{} averaged to {}; they differ by {} rms", of_all, rows_word(rows_.size()),
                     scatter));
    return {};
  }

  tl::expected<void, base::HistoryError> resample() {
    if (!experiment_.resample) return {};
    const Resampling& resampling = *experiment_.resample;
    const double extent = rows_.time.back() - rows_.time.front();
    if (resampling.every && !(extent / *resampling.every < cleaning::kMostResampledRows)) {
      return refused(fmt::format(
          "resample: one row every {} makes {:.2g} of {}, more than {:.0e}: write a longer 'every'",
          amount(*resampling.every, base::kTime, units_), extent / *resampling.every,
          amount(extent, base::kTime, units_), cleaning::kMostResampledRows));
    }
    rows_ = resampling.every ? cleaning::resampled(rows_, *resampling.every)
                             : cleaning::resampled(rows_, resampling.points.value_or(2));
    tell(resampling.every ? fmt::format("resampled to {}, one every {}", rows_word(rows_.size()),
                                        amount(*resampling.every, base::kTime, units_))
                          : fmt::format("resampled to {}", rows_word(rows_.size())));
    return {};
  }

  tl::expected<Measurements, base::HistoryError> split() {
    std::size_t column = 1;
    for (const ResponseFit& response : experiment_.responses) {
      MeasuredSeries& series = result_.responses.emplace_back();
      const auto begin = std::lower_bound(rows_.time.begin(), rows_.time.end(),
                                          response.from.value_or(-kInfinity));
      const auto end = std::upper_bound(begin, rows_.time.end(), response.to.value_or(kInfinity));
      const auto first = begin - rows_.time.begin();
      const auto last = end - rows_.time.begin();
      const auto part = [&](const std::vector<double>& numbers) {
        return std::vector<double>(numbers.begin() + first, numbers.begin() + last);
      };
      series.time = part(rows_.time);
      series.value = part(rows_.columns[column++]);
      if (response.over) series.over = part(rows_.columns[column++]);
      const bool made = experiment_.average_cycles || experiment_.resample;
      if (!made) series.line = part(rows_.columns.front());
      result_.rows_used = std::max(result_.rows_used, series.time.size());
      if (!response.from && !response.to) continue;
      const std::string range = range_words(response.from, response.to, units_);
      if (series.time.empty()) {
        return refused("no row lies " + range + ", where " + response.quantity_text +
                       " is compared");
      }
      tell(fmt::format("{} is compared {}: {}", response.quantity_text, range,
                       rows_word(series.time.size())));
    }
    return std::move(result_);
  }

  tl::unexpected<base::HistoryError> refused(std::string message) const {
    return tl::unexpected(base::HistoryError{base::HistoryError::Kind::kInput,
                                             experiment_.data_file, 0, 0, std::move(message)});
  }

  const ExperimentFit& experiment_;
  const base::UnitSystem& units_;
  std::vector<const DataColumn*> columns_;  ///< the time first
  cleaning::DataRows rows_;                 ///< its first column is the line of the file
  Span in_file_;
  Span in_range_;
  Measurements result_;
};

}  // namespace

tl::expected<Measurements, base::HistoryError> read_measurements(const ExperimentFit& experiment,
                                                                 bool with_hash) {
  auto result = Cleaner(experiment).clean();
  if (!result || !with_hash) return result;
  auto hash = base::sha256_of_file(experiment.data_path);
  if (!hash) return tl::unexpected(std::move(hash.error()));
  result->hash = std::move(*hash);
  return result;
}

}  // namespace slipbench::driver::calibrate
