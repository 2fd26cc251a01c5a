// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Returns where the numbers of a calibrated case come from, as lines that start with "# ":
/// program, fit, date (if the fit gives one), whether it converged, cost, data files with their
/// SHA-256, errors of the experiments, estimates with standard errors and intervals, what was never
/// visited. Without a date the same fit gives the same bytes.
/// \param experiments in Fit::experiments, those that the case stands for: the others are named
/// after them
/// \param unknowns that the case has, in Calibration::unknowns
std::string calibration_comment(const Fit& fit, const Calibration& calibration,
                                std::span<const std::size_t> experiments,
                                std::span<const std::size_t> unknowns);

}  // namespace slipbench::driver::calibrate
