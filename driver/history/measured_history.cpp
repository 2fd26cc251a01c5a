// SPDX-License-Identifier: Apache-2.0
#include "driver/history/measured_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace slipbench::driver::history {

double between_rows(double t0, double v0, double t1, double v1, double t, bool hold) {
  if (t >= t1) return v1;
  if (hold || t <= t0) return v0;
  return v0 + (v1 - v0) * ((t - t0) / (t1 - t0));
}

MeasuredHistory::MeasuredHistory(MeasuredSource source, base::CsvReader reader)
    : source_(std::move(source)),
      reader_(std::move(reader)),
      row_(source_.columns.size() + 1, 0.0) {}

tl::expected<MeasuredHistory, base::HistoryError> MeasuredHistory::open(MeasuredSource source) {
  std::vector<std::string> names = {source.time_column};
  for (const MeasuredColumn& column : source.columns) names.push_back(column.column);
  auto reader = base::CsvReader::open(source.data, names);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  return MeasuredHistory(std::move(source), std::move(*reader));
}

tl::expected<bool, base::HistoryError> MeasuredHistory::advance() {
  const double previous = row_.front();
  reader_.note_place(&before_.place);
  before_.raw_time = previous;
  before_.time = time_;
  before_.rows = rows_;
  const long previous_line = reader_.line();
  auto read = reader_.next(row_);
  if (!read) return read;
  if (!*read) {
    if (rows_ == 1) return error_here("there is one row; a history needs two or more");
    return false;
  }
  const double raw_time = row_.front();
  // The comparison is made on the file's own numbers, which the user can look up.
  if (rows_ > 0 && !(raw_time > previous)) {
    return error_here(fmt::format("the time '{}' does not increase: {} after {} in line {}{}",
                                  source_.time_column, raw_time, previous, previous_line,
                                  base::of_held_time(source_.data.format, raw_time, previous)));
  }
  const double time = source_.time_conversion(raw_time);
  bool finite = std::isfinite(time);
  for (std::size_t i = 0; i < source_.columns.size(); ++i) {
    double& value = row_[i + 1];
    value = source_.columns[i].conversion(value);
    finite &= std::isfinite(value);
  }
  if (!finite) return error_here("a number exceeds the range of a double in the case's unit");
  if (rows_ > 0 && !(time > time_)) {
    return error_here(
        fmt::format("the times {} and {} are the same in the case's unit", previous, raw_time));
  }
  time_ = time;
  ++rows_;
  if (time <= 0.0 && before_.rows > 0) start_ = last_;
  last_ = before_;
  return true;
}

tl::expected<void, base::HistoryError> MeasuredHistory::rewind() {
  if (start_.rows == 0) {
    rows_ = 0;
    return reader_.rewind();
  }
  row_.front() = start_.raw_time;
  time_ = start_.time;
  rows_ = start_.rows;
  return reader_.go_back(start_.place);
}

tl::unexpected<base::HistoryError> MeasuredHistory::error_here(std::string message) const {
  return reader_.error_here(std::move(message));
}

}  // namespace slipbench::driver::history
