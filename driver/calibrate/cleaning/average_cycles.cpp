// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/cleaning/average_cycles.hpp"

#include <cmath>

#include "driver/calibrate/cleaning/resample.hpp"

namespace slipbench::driver::cleaning {

std::size_t whole_cycles(double first, double last, double period, double step) {
  const double cycles = (last - first + step) / period * (1.0 + 1e-9);
  return cycles >= 1.0 ? static_cast<std::size_t>(cycles) : 0;
}

MeanCycle mean_cycle(const DataRows& rows, double first, double period, std::size_t cycles,
                     int points) {
  MeanCycle result;
  const auto phases = static_cast<std::size_t>(points);
  const std::size_t columns = rows.columns.size();
  std::vector<std::size_t> counts(phases, 0);
  // Mean and sum of squared deviations are updated cycle by cycle (Welford 1962): nothing is lost
  // where the scatter is small against the mean.
  std::vector<double> mean(phases * columns, 0.0);
  std::vector<double> squares(phases * columns, 0.0);
  RowCursor cursor(rows);
  for (std::size_t cycle = 0; cycle < cycles; ++cycle) {
    for (std::size_t phase = 0; phase < phases; ++phase) {
      const double part = static_cast<double>(phase) / static_cast<double>(phases);
      if (!cursor.seek(first + (static_cast<double>(cycle) + part) * period)) continue;
      const double count = static_cast<double>(++counts[phase]);
      for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t i = phase * columns + c;
        const double difference = cursor.value(c) - mean[i];
        mean[i] += difference / count;
        squares[i] += difference * (cursor.value(c) - mean[i]);
      }
    }
  }

  result.rows.columns.resize(columns);
  result.scatter.assign(columns, 0.0);
  std::size_t total = 0;
  bool gap = false;
  bool any_gap = false;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    if (counts[phase] == 0) {
      gap = any_gap = true;
      continue;
    }
    total += counts[phase];
    const double part = static_cast<double>(phase) / static_cast<double>(phases);
    result.rows.time.push_back(first + part * period);
    result.rows.gap.push_back(gap ? 1 : 0);
    gap = false;
    for (std::size_t c = 0; c < columns; ++c) {
      result.rows.columns[c].push_back(mean[phase * columns + c]);
      result.scatter[c] += squares[phase * columns + c];
    }
  }
  if (!any_gap) result.rows.gap.clear();
  for (double& scatter : result.scatter) {
    scatter = total == 0 ? 0.0 : std::sqrt(scatter / static_cast<double>(total));
  }
  return result;
}

}  // namespace slipbench::driver::cleaning
