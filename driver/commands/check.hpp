// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver {

struct CheckOptions {
  std::vector<std::string> paths;     ///< case files, or folders that are searched for them
  std::vector<std::string> settings;  ///< --set, as typed
  int jobs = 0;                       ///< threads; 0 for as many as there are cores
  bool allow_outside = false;
};

/// `slipbench check`: runs all cases, writes no files, and prints a verdict on each. The output
/// does not depend on the number of threads. Folders are searched recursively for *.yaml files,
/// except in folders named `bad` and hidden ones. Returns the exit code: that of the worst case.
int check_command(const CheckOptions& options);

}  // namespace slipbench::driver
