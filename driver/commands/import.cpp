// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import.hpp"

#include "driver/commands/import_abaqus.hpp"
#include "driver/commands/import_radioss.hpp"
#include "driver/import/deck_kind.hpp"

namespace slipbench::driver::commands {

int import_command(const ImportOptions& options) {
  // Of a file that cannot be read, or is no deck, either reader tells what is wrong.
  return import::kind_of_deck(options.deck) == import::DeckKind::kAbaqus ? import_abaqus(options)
                                                                         : import_radioss(options);
}

}  // namespace slipbench::driver::commands
