// SPDX-License-Identifier: Apache-2.0
// Calibrations made by hand: what a fit would have found.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// A fit of unknowns with a Jacobian of as many columns, all of its rows compared.
inline Calibration calibration_of(const std::vector<std::pair<std::string, double>>& unknowns,
                                  std::vector<double> jacobian) {
  Calibration calibration;
  const std::size_t n = unknowns.size();
  for (const auto& [name, value] : unknowns) {
    FittedUnknown unknown;
    unknown.name = name;
    unknown.value = value;
    unknown.range.start = 1.0;
    unknown.range.lower = 0.0;
    calibration.unknowns.push_back(unknown);
    calibration.fit.x.push_back(value);
  }
  calibration.fit.jacobian = std::move(jacobian);
  calibration.problem.rows = calibration.fit.jacobian.size() / n;
  calibration.problem.data_rows = calibration.problem.rows;
  calibration.fit.frozen.assign(n, 0);
  calibration.fit.at_lower.assign(n, 0);
  calibration.fit.at_upper.assign(n, 0);
  calibration.fit.converged = true;
  calibration.fit.stop = fit::StopReason::kStep;
  calibration.fit.stop_sentence = "the steps have become negligible";
  calibration.fit.iterations = 7;
  fit::FitStatistics& statistics = calibration.statistics;
  statistics.data = calibration.problem.rows;
  statistics.unknowns = n;
  statistics.identifiable.assign(n, 1);
  for (const auto& [name, value] : unknowns) {
    statistics.standard_error.push_back(0.01 * std::abs(value));
    statistics.lower.push_back(value - 0.02 * std::abs(value));
    statistics.upper.push_back(value + 0.02 * std::abs(value));
  }
  statistics.correlation.assign(n * n, 0.0);
  statistics.covariance.assign(n * n, 0.0);
  for (std::size_t u = 0; u < n; ++u) statistics.correlation[u * n + u] = 1.0;
  return calibration;
}

/// The parameters as the fit names them.
inline Fit fit_of(const std::vector<std::string>& parameters) {
  Fit fit;
  fit.file = "fits/rig.yaml";
  fit.title = "rig";
  for (const std::string& name : parameters) fit.vary.push_back({name, {}, {}});
  return fit;
}

/// A table over slip_rate and temperature, its ordinates the unknowns from `first` on.
inline FittedTable grid_table(std::vector<double> rates, std::vector<double> temperatures,
                              std::size_t first) {
  FittedTable table;
  table.first_unknown = first;
  table.columns = {"slip_rate", "temperature"};
  table.units = {"mm/s", "degC"};
  for (const double temperature : temperatures) {
    for (const double rate : rates) table.points.push_back({rate, temperature});
  }
  table.count = table.points.size();
  for (std::size_t j = 0; j + 1 < temperatures.size(); ++j) {
    for (std::size_t i = 0; i + 1 < rates.size(); ++i) table.cells.push_back({"", 10});
  }
  return table;
}

}  // namespace slipbench::driver::calibrate
