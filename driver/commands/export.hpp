// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/commands/deck_output.hpp"

namespace slipbench::driver::commands {

struct ExportCommandOptions {
  std::string file;                   ///< the case
  std::vector<std::string> settings;  ///< --set NAME=VALUE
  bool allow_outside = false;
  DeckOutputOptions deck;
};

/// `slipbench export`: writes a case as a deck, and tells on standard error what is kept,
/// approximated and dropped. Returns the exit code.
int export_command(const ExportCommandOptions& options);

}  // namespace slipbench::driver::commands
