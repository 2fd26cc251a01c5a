// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/import/abaqus/behavior.hpp"
#include "driver/import/abaqus/keyword_deck.hpp"

namespace slipbench::driver::abaqus {

/// Reads lines as rows of at most `most` numbers; one of more than eight goes on in the next line.
/// What is wrong is reported, with what is wanted; such a row is left out.
/// \param wanted in words: "mu, slip rate"
std::vector<Row> read_rows(const KeywordDeck& deck, const Block& block,
                           const std::vector<Items>& lines, std::size_t most,
                           std::string_view wanted);

/// Returns the one of some words that a parameter has as its value, which may be shortened; the
/// first of them where it is not given, or is none of them, which is reported.
std::string word_of(const KeywordDeck& deck, const Block& block, std::string_view name,
                    const std::vector<std::string_view>& words);

/// Reads the number of a component, 1 to 6; nothing if it is none.
std::optional<int> component_in(const KeywordDeck& deck, std::string_view item);

}  // namespace slipbench::driver::abaqus
