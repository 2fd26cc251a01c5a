// SPDX-License-Identifier: Apache-2.0
// Points that do not belong to the noise of the others, and what helps against them.
#pragma once

#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Names the outliers of every response, at most five each. Of those that were fitted it says which
/// loss lets them count little: the fit is searched with it, which takes about as long again.
std::vector<std::string> outlier_notes(const Fit& fit, const Calibration& calibration);

}  // namespace slipbench::driver::calibrate
