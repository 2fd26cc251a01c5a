// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct CheckOptions {
  std::vector<std::string> paths;     ///< case files, or folders that are searched for them
  std::vector<std::string> settings;  ///< --set, as typed
  int jobs = 0;                       ///< threads; 0 for as many as there are cores
  bool allow_outside = false;
  std::vector<std::string> filters;  ///< a case is taken if its name matches one of them
  bool failed_first = false;         ///< begin with those that did not pass last time
  bool fail_fast = false;            ///< stop at the first that does not pass
  bool quiet = false;                ///< of the table, only what does not pass
  std::optional<int> durations;      ///< also tell so many of the slowest cases; 0 for all
  bool strict = false;               ///< a warning fails its case
  std::string junit;                 ///< files to write; empty for none
  std::string json;
  std::string report;
  bool force = false;  ///< --force: replace files that are no verdicts
};

/// `slipbench check`: runs all cases and prints a verdict on each as soon as all before it are
/// done; writes the files asked for, none of which replaces a file that is read, and nothing else
/// but the memory for `failed_first`, which is kept of every suite of more than one case (see
/// LastFailed): of the cases that were run, those that did not pass are added and those that passed
/// are removed. The output does not depend on the number of threads, and the files but for the page
/// not on the order in which the cases are run. Folders are searched recursively for *.yaml and
/// *.yml files, except for hidden ones and in folders that are hidden or named `bad`. Returns the
/// exit code: that of the worst case, or of a file that could not be written.
int check_command(const CheckOptions& options);

}  // namespace slipbench::driver::commands
