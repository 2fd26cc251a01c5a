// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

/// Reads an LS-DYNA keyword deck: a case of its contact with friction, or of those chosen.
ImportedDeck import_lsdyna(const ImportOptions& options);

}  // namespace slipbench::driver::commands
