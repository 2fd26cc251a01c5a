// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/import.hpp"

namespace slipbench::driver::commands {

/// Lists the connectors of an Abaqus input deck and makes cases of those with friction that are
/// meant. Returns the exit code.
int import_abaqus(const ImportOptions& options);

}  // namespace slipbench::driver::commands
