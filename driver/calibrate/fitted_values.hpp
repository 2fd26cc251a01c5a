// SPDX-License-Identifier: Apache-2.0
// Experiments before and after a fit, and what to tell of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"
#include "driver/calibrate/experiment_model.hpp"

namespace slipbench::driver::calibrate {

/// An experiment with the model's values at the start and at the optimum, row for row, and their
/// errors. The share of the cost is left at 0.
/// \param before, after of all points of the model; empty: the model has no value there (NaN)
FittedExperiment fitted_experiment(const ExperimentModel& model, std::size_t index,
                                   std::span<const double> before, std::span<const double> after);

/// The correlation of what is left of a response from one point to the next: near 0 of noise, near
/// 1 of a trend.
double lag_one_autocorrelation(std::span<const double> residuals);

/// Returns what the user should look at, a sentence each: unknowns at their bounds, residuals that
/// are a trend and no noise, hold-outs that are met worse than the fitted data, other minima,
/// points that a robust loss gives little weight. (Identifiability has its own.)
std::vector<std::string> calibration_notes(const Fit& fit, const Calibration& calibration);

}  // namespace slipbench::driver::calibrate
