// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/imported_deck.hpp"

#include <utility>

#include "driver/commands/import_abaqus.hpp"
#include "driver/commands/import_lsdyna.hpp"
#include "driver/commands/import_opensees.hpp"
#include "driver/commands/import_radioss.hpp"
#include "driver/import/deck_kind.hpp"

namespace slipbench::driver::commands {

ImportedDeck refused(ImportedDeck imported, const std::string& message, int code) {
  imported.messages += "slipbench: error: " + message + "\n";
  imported.cases.clear();
  imported.code = code;
  return imported;
}

std::optional<base::SourceText> source_of(const ImportOptions& options, ImportedDeck& imported) {
  // Decks carry the whole mesh.
  constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;
  if (options.text) return options.text;
  auto source = base::read_source(options.deck, kDeckSizeLimit);
  if (source) return std::move(*source);
  imported.messages += base::render(source.error().diagnostic);
  imported.code = source.error().failure == base::ReadFailure::kEnvironment ? base::kExitEnvironment
                                                                            : base::kExitBadInput;
  return std::nullopt;
}

ImportedDeck read_deck(const ImportOptions& options) {
  const import::DeckKind kind = options.text ? import::kind_of_text(options.text->text())
                                             : import::kind_of_deck(options.deck);
  switch (kind) {
    case import::DeckKind::kAbaqus:
      return import_abaqus(options);
    case import::DeckKind::kLsDyna:
      return import_lsdyna(options);
    case import::DeckKind::kOpenSees:
      return import_opensees(options);
    default:
      // Of a file that cannot be read, or is no deck, this reader tells what is wrong.
      return import_radioss(options);
  }
}

}  // namespace slipbench::driver::commands
