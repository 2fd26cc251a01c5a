// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct MergeOptions {
  std::string file;                   ///< the sweep file
  std::vector<std::string> parts;     ///< files of rows and journals; none: those in `folder`
  std::string folder = ".";           ///< where the result goes
  std::vector<std::string> settings;  ///< --set, as they were for the parts
  bool allow_outside = false;
  std::string report;          ///< --report: the page to write
  std::string format = "csv";  ///< --format of the rows
  bool force = false;          ///< --force: replace a file that is no result of the sweep
};

/// `slipbench merge`: joins the parts of a sweep into SWEEP.csv, as one run would have written it,
/// and tells what that would have told. The parts stay. Returns the exit code: 2 if they do not
/// belong together or are not all there.
int merge_command(const MergeOptions& options);

}  // namespace slipbench::driver::commands
