// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/calibrate.hpp"

#include "driver/calibrate/calibration.hpp"
#include "driver/commands/shared.hpp"
#include "driver/exit_code.hpp"

namespace slipbench::driver {

int calibrate_command(const CalibrateOptions& options) {
  return refuse(kExitInternal, "calibrate " + options.file + ": not linked");
}

}  // namespace slipbench::driver
