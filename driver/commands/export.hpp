// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct ExportCommandOptions {
  std::string file;                   ///< the case
  std::string to;                     ///< the program: a word of kExportTargets
  std::string part;                   ///< "behaviour": only the block to paste
  std::string output;                 ///< empty: standard output
  std::vector<std::string> settings;  ///< --set NAME=VALUE
  bool allow_outside = false;
  int digits = 0;  ///< --digits: to which numbers are rounded; 0: all
  bool force = false;
  bool json = false;  ///< --json: what is kept, approximated and dropped, for machines
};

/// `slipbench export`: writes a case as a deck, and tells on standard error what is kept,
/// approximated and dropped. Returns the exit code.
int export_command(const ExportCommandOptions& options);

}  // namespace slipbench::driver::commands
