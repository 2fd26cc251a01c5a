// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct SweepOptions {
  std::string file;                   ///< the sweep file
  std::string folder = ".";           ///< where the result goes
  std::vector<std::string> settings;  ///< --set, for all samples
  bool allow_outside = false;
  std::string report;          ///< --report: the page to write
  std::string format = "csv";  ///< --format of the rows
  bool no_rows = false;        ///< --no-rows: write only summaries, of a part its tally
  bool no_output = false;      ///< write no file, only tell what was found
  bool force = false;          ///< --force: replace a file that is no result of the sweep
  int threads = 0;             ///< 0: as many as the machine has cores
  std::string part;            ///< "2/8": only this part of the samples
  std::string emit;            ///< "slurm": write a script that runs the sweep there, run nothing
  double rate = 0.0;  ///< samples a second and core, for `emit`; 0: a few are run to find it
};

/// `slipbench sweep`: runs a case with many values of its parameters, writes SWEEP.csv (a row a
/// sample) and tells how what was collected spreads. Returns the exit code: 3 if a sample failed.
int sweep_command(const SweepOptions& options);

}  // namespace slipbench::driver::commands
