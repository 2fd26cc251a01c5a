// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/cleaning/resample.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slipbench::driver::cleaning {
namespace {

/// Rows at `count` times.
template <class TimeOf>
DataRows rows_at(const DataRows& rows, std::size_t count, TimeOf time_of) {
  DataRows result;
  result.columns.resize(rows.columns.size());
  result.time.reserve(count);
  for (std::vector<double>& column : result.columns) column.reserve(count);
  RowCursor cursor(rows);
  bool gap = false;
  bool any_gap = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = time_of(i);
    if (!cursor.seek(time)) {
      gap = any_gap = true;
      continue;
    }
    result.time.push_back(time);
    result.gap.push_back(gap ? 1 : 0);
    gap = false;
    for (std::size_t c = 0; c < rows.columns.size(); ++c) {
      result.columns[c].push_back(cursor.value(c));
    }
  }
  if (!any_gap) result.gap.clear();
  return result;
}

}  // namespace

bool RowCursor::seek(double time) {
  const std::vector<double>& times = rows_->time;
  if (times.empty() || !(time >= times.front()) || !(time <= times.back())) return false;
  while (row_ + 1 < times.size() && times[row_ + 1] <= time) ++row_;
  fraction_ = 0.0;
  if (time == times[row_]) return true;
  if (rows_->gap_before(row_ + 1)) return false;
  fraction_ = (time - times[row_]) / (times[row_ + 1] - times[row_]);
  return true;
}

double RowCursor::value(std::size_t column) const {
  const std::vector<double>& values = rows_->columns[column];
  if (fraction_ == 0.0) return values[row_];
  return values[row_] + fraction_ * (values[row_ + 1] - values[row_]);
}

DataRows resampled(const DataRows& rows, double every) {
  if (rows.size() == 0) return rows;
  const double first = rows.time.front();
  const double last = rows.time.back();
  // The last one is not lost to rounding.
  const auto steps = static_cast<std::size_t>(std::floor((last - first) / every * (1.0 + 1e-12)));
  return rows_at(rows, steps + 1, [&](std::size_t i) {
    return std::min(first + static_cast<double>(i) * every, last);
  });
}

DataRows resampled(const DataRows& rows, int points) {
  if (rows.size() == 0) return rows;
  const double first = rows.time.front();
  const double last = rows.time.back();
  const auto count = static_cast<std::size_t>(points);
  const double intervals = static_cast<double>(points - 1);
  return rows_at(rows, count, [&](std::size_t i) {
    return i + 1 == count ? last : first + (last - first) * (static_cast<double>(i) / intervals);
  });
}

}  // namespace slipbench::driver::cleaning
