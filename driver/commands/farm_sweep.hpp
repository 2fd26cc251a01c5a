// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/farm/run_farm.hpp"

namespace slipbench::driver::commands {

struct FarmSweepOptions {
  std::string file;
  std::string folder = ".";           ///< all ranks must see it
  std::vector<std::string> settings;  ///< --set NAME=VALUE
  bool allow_outside = false;
  std::string report;          ///< --report: the page to write
  std::string format = "csv";  ///< --format of the rows
  bool no_rows = false;        ///< --no-rows: write only summaries
  bool force = false;          ///< begin anew, and replace a file that is no result of the sweep
};

/// `slipbench-mpi sweep`, of every rank: runs its share of the samples into a journal (without rows
/// a tally) of its own, goes on from those of earlier runs by however many ranks, and writes as
/// rank 0 what `slipbench sweep` would have written.
int farm_sweep_command(const FarmSweepOptions& options, const farm::Farm& farm);

}  // namespace slipbench::driver::commands
