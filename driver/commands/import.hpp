// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

/// `slipbench import`: a case of each joint or contact of a deck that is chosen. Messages go to
/// standard error with file, line and column; if one is an error, nothing is written. Returns the
/// exit code.
int import_command(const ImportOptions& options);

}  // namespace slipbench::driver::commands
