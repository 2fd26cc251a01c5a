// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/commands/deck_output.hpp"
#include "driver/commands/imported_deck.hpp"

namespace slipbench::driver::commands {

struct TranslateOptions {
  ImportOptions source;               ///< its `output` is not used
  std::vector<std::string> settings;  ///< --set NAME=VALUE: what the deck has no number for
  DeckOutputOptions deck;
};

/// Puts a joint or contact of a deck into a program's words; the difference is measured if all that
/// the case asks for is given.
/// \return a sentence where the program has no word for it, or its deck depends on what is not
/// given
tl::expected<DeckOutput, std::string> translated(const import::WrittenCase& of,
                                                 const std::vector<base::ParameterText>& settings,
                                                 const DeckOutputOptions& options);

/// `slipbench translate`: a joint or contact of a deck in the words of another program. Numbers
/// that the deck has not are asked for where the other deck depends on them. Returns the exit code.
int translate_command(const TranslateOptions& options);

}  // namespace slipbench::driver::commands
