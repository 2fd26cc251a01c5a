// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/commands/exported_case.hpp"
#include "driver/commands/loss_report.hpp"

namespace slipbench::driver::commands {

/// Form of a deck, and where it goes.
struct DeckOutputOptions {
  std::string to;      ///< the program: a word of kExportTargets
  std::string part;    ///< "behaviour": only the block to paste
  std::string output;  ///< empty: standard output
  int digits = 0;      ///< --digits: to which numbers are rounded; 0: all
  bool force = false;
  bool json = false;  ///< --json: what is kept, approximated and dropped, for machines
};

/// Deck of a case, with the costs of the translation.
struct DeckOutput {
  std::string output;  ///< file; empty or "-": standard output
  exports::ExportedDeck deck;
  MeasuredDifference difference;
};

/// Writes a case as a deck and measures what that changes.
/// \return a sentence where the program has no word for it
tl::expected<DeckOutput, std::string> deck_of_case(const cases::Case& problem,
                                                   const read::CaseText& written,
                                                   const DeckOutputOptions& options);

/// Writes a deck and tells its losses, for machines into `document`. Returns the exit code.
/// \param source the file it is made of, which is not overwritten
/// \param document null where they are told on standard error
int write_deck(const DeckOutput& made, const std::string& source, bool force,
               base::json::Value* document);

/// Tells why --json cannot go where the deck goes; empty if it can.
std::string json_fault(const DeckOutputOptions& options);

}  // namespace slipbench::driver::commands
