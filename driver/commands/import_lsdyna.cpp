// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/import_lsdyna.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/commands/contact_choice.hpp"
#include "driver/import/lsdyna/deck_friction.hpp"

namespace slipbench::driver::commands {

ImportedDeck import_lsdyna(const ImportOptions& options) {
  ImportedDeck imported;
  const auto source = source_of(options, imported);
  if (!source) return imported;
  base::Diagnostics diagnostics;
  const lsdyna::KeywordDeck deck = lsdyna::split_deck(
      *source, {std::filesystem::path(options.deck).parent_path().string(), options.allow_outside},
      diagnostics);
  std::vector<ContactChoice> choices;
  constexpr int kNone = std::numeric_limits<int>::min();
  std::optional<int> contact = options.interface;
  if (options.id && !contact) contact = kNone;
  for (lsdyna::Found& one : lsdyna::read_frictions(deck, diagnostics, contact)) {
    const bool meant = (!options.id && !options.interface) ||
                       (one.is_table ? options.id : options.interface) == one.id;
    choices.push_back({fmt::format("{}_{}", one.is_table ? "FRICTION" : "CONTACT", one.id),
                       std::move(one.friction), std::move(one.passed_over), meant});
  }
  return choose_contacts(options, std::move(choices), diagnostics, deck.texts,
                         {"contact", "--interface, or a *DEFINE_FRICTION with --id"});
}

}  // namespace slipbench::driver::commands
