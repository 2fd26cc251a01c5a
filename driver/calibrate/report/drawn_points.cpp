// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/report/drawn_points.hpp"

#include <array>
#include <cmath>

#include "driver/results/thinning.hpp"

namespace slipbench::driver::calibrate {
namespace {

const std::vector<double>& positions_of(const FittedResponse& response) {
  return response.over.empty() ? response.positions : response.abscissa;
}

/// A model that has no values, since it could not be run, has none of any point.
double value_at(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : std::nan("");
}

}  // namespace

LoopAxis loop_axis(const FittedResponse& response) {
  if (positions_of(response).size() != response.measured.size()) return {};
  if (!response.over.empty()) return {response.over, response.over_unit};
  return {response.position, response.position_unit};
}

DrawnPoints drawn_points(const FittedResponse& response, std::size_t limit) {
  // Columns: time, position, measured, before, after, residual before, residual after. Time only
  // rises; all others are watched.
  constexpr std::size_t kColumns = 7;
  constexpr std::array<std::size_t, 6> kWatched{1, 2, 3, 4, 5, 6};
  const bool loop = !loop_axis(response).name.empty();
  std::vector<double> table;
  for (std::size_t i = 0; i < response.measured.size(); ++i) {
    const double measured = response.measured[i];
    const double before = value_at(response.before, i);
    const double after = value_at(response.after, i);
    table.insert(table.end(), {value_at(response.time, i), loop ? positions_of(response)[i] : 0.0,
                               measured, before, after, before - measured, after - measured});
  }
  DrawnPoints drawn;
  const std::vector<std::size_t> rows = results::thinned_rows(table, kColumns, limit, kWatched);
  drawn.thinned = rows.size() < response.measured.size();
  for (const std::size_t row : rows) {
    const double* numbers = &table[row * kColumns];
    drawn.time.push_back(numbers[0]);
    if (loop) drawn.position.push_back(numbers[1]);
    drawn.measured.push_back(numbers[2]);
    drawn.before.push_back(numbers[3]);
    drawn.after.push_back(numbers[4]);
  }
  return drawn;
}

}  // namespace slipbench::driver::calibrate
