// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/calibrate.hpp"
#include "driver/farm/run_farm.hpp"

namespace slipbench::driver::commands {

/// `slipbench-mpi calibrate`, of every rank: all do the same fit and share its starts, resamplings
/// and profiles, one at a time; rank 0 writes and tells what `slipbench calibrate` would have.
int farm_calibrate_command(CalibrateOptions options, const farm::Farm& farm);

}  // namespace slipbench::driver::commands
