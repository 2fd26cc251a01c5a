// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/cleaning/dead_band.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slipbench::driver::cleaning {

std::vector<double> slopes(std::span<const double> time, std::span<const double> values) {
  const std::size_t rows = time.size();
  if (rows < 2) return {};
  constexpr auto kReach = static_cast<std::size_t>(kSlopeReach);
  std::vector<double> result(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    // At the ends the reach is what there is on one side.
    const std::size_t begin = i > kReach ? i - kReach : 0;
    const std::size_t end = std::min(rows, i + kReach + 1);
    double mean_time = 0.0;
    double mean_value = 0.0;
    const auto count = static_cast<double>(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      mean_time += (time[k] - time[i]) / count;
      mean_value += (values[k] - values[i]) / count;
    }
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const double t = time[k] - time[i] - mean_time;
      products += t * (values[k] - values[i] - mean_value);
      squares += t * t;
    }
    result[i] = products / squares;
  }
  return result;
}

DataRows without_slow_rows(const DataRows& rows, std::span<const double> speed, double below) {
  DataRows result;
  result.columns.resize(rows.columns.size());
  bool gap = false;
  bool any_gap = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    gap = gap || rows.gap_before(i);
    if (!(std::abs(speed[i]) >= below)) {
      gap = true;
      continue;
    }
    // What was left out before the first row that is kept is no gap in it.
    const bool inner = gap && !result.time.empty();
    any_gap = any_gap || inner;
    result.time.push_back(rows.time[i]);
    result.gap.push_back(inner ? 1 : 0);
    for (std::size_t c = 0; c < rows.columns.size(); ++c) {
      result.columns[c].push_back(rows.columns[c][i]);
    }
    gap = false;
  }
  if (!any_gap) result.gap.clear();
  return result;
}

}  // namespace slipbench::driver::cleaning
