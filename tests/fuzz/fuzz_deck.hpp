// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "driver/commands/imported_deck.hpp"

namespace slipbench::fuzz {

/// Reads the text of a deck, and the cases that are made of it, of which some are run.
void try_deck(std::string_view input,
              driver::commands::ImportedDeck (*import)(const driver::commands::ImportOptions&));

}  // namespace slipbench::fuzz
