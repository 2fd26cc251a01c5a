// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// Tells whether the errors of a fit can be trusted, a sentence each, with what to do: no more
/// values than unknowns; responses of different noise without sigma; a robust loss whose threshold
/// is far below the noise; a bootstrap or profiles that were asked for and not made, or whose
/// refits failed.
std::vector<std::string> error_notes(const Fit& fit, const Calibration& calibration);

}  // namespace slipbench::driver::calibrate
