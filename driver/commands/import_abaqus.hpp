// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

/// Reads an Abaqus input deck: a case of each of its connectors with friction, or of those chosen.
ImportedDeck import_abaqus(const ImportOptions& options);

}  // namespace slipbench::driver::commands
