// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace slipbench::driver::import {

/// Programs whose decks are read.
enum class DeckKind : std::uint8_t { kUnknown, kAbaqus, kRadioss, kLsDyna, kOpenSees };

/// Returns whose deck a file is, by its first lines; kUnknown also where it cannot be read.
DeckKind kind_of_deck(const std::filesystem::path& file);

/// The same of the text of a deck.
DeckKind kind_of_text(std::string_view text);

}  // namespace slipbench::driver::import
