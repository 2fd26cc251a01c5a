// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/import.hpp"

namespace slipbench::driver::commands {

/// Makes a case of the friction of a Radioss starter deck. Returns the exit code.
int import_radioss(const ImportOptions& options);

}  // namespace slipbench::driver::commands
