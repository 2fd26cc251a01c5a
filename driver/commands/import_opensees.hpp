// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

/// Reads an OpenSees script: a case of its friction model, or of those chosen.
ImportedDeck import_opensees(const ImportOptions& options);

}  // namespace slipbench::driver::commands
