// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/imported_deck.hpp"
#include "driver/import/contact/contact_case.hpp"
#include "driver/import/deck_texts.hpp"

namespace slipbench::driver::commands {

/// Statement of friction of a deck, to be taken over or passed over.
struct ContactChoice {
  std::string stem;  ///< of the name of its file, behind that of the deck
  import::ContactFriction friction;
  std::optional<std::string> passed_over;  ///< why no case can be made of it
  bool meant = true;                       ///< by the options
};

/// Words of a program for what is chosen.
struct ChoiceWords {
  std::string_view what;    ///< "contact"
  std::string_view option;  ///< "--interface"
};

/// Tells whether the cases of a deck list more parts together than are written at once.
/// \param parts of the cases before, to which those of this one are added
bool lists_too_many_parts(const import::ContactFriction& friction, std::size_t& parts);
/// The same as a refusal.
ImportedDeck refused_for_parts(ImportedDeck imported, const std::string& deck,
                               std::string_view option);

/// Lists what a deck has, and makes the cases of what is meant. Errors of the deck end the import,
/// and so does a choice that is open.
ImportedDeck choose_contacts(const ImportOptions& options, std::vector<ContactChoice> choices,
                             const base::Diagnostics& diagnostics, const import::DeckTexts& texts,
                             const ChoiceWords& words);

}  // namespace slipbench::driver::commands
