// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Returns what a calibration found, for a terminal: why it stopped, errors of fit and hold-out,
/// starts, the parameters with standard errors, intervals and bounds, the ordinates of tables,
/// correlations that matter, errors before and after of every experiment, and the calibration's
/// notes. Ends with a line feed; at most 80 columns unless names are long.
std::string fit_summary(const Fit& fit, const Calibration& calibration);

}  // namespace slipbench::driver::calibrate
