// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

/// Reads a Radioss starter deck: a case of its interface with friction or its only /FRICTION, or of
/// those chosen.
ImportedDeck import_radioss(const ImportOptions& options);

}  // namespace slipbench::driver::commands
