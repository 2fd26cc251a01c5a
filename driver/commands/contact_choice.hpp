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

/// Lists what a deck has, and makes the cases of what is meant. Errors of the deck end the import,
/// and so does a choice that is open.
ImportedDeck choose_contacts(const ImportOptions& options, std::vector<ContactChoice> choices,
                             const base::Diagnostics& diagnostics, const import::DeckTexts& texts,
                             const ChoiceWords& words);

}  // namespace slipbench::driver::commands
