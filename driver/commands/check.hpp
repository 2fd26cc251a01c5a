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
  std::vector<std::string> filters;  ///< a case is taken if its name matches one of them
  bool failed_first = false;         ///< begin with those that did not pass last time
  bool fail_fast = false;            ///< stop at the first that does not pass
  bool quiet = false;                ///< of the table, only what does not pass
  std::string junit;                 ///< files to write; empty for none
  std::string json;
  std::string report;
};

/// `slipbench check`: runs all cases and prints a verdict on each as soon as all before it are
/// done; writes the files asked for, and nothing else but the memory of `failed_first`. The output
/// does not depend on the number of threads. Folders are searched recursively for *.yaml files,
/// except in folders named `bad` and hidden ones. Returns the exit code: that of the worst case, or
/// of a file that could not be written.
int check_command(const CheckOptions& options);

}  // namespace slipbench::driver
