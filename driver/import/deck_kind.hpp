// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace slipbench::driver::import {

/// Programs whose decks are read.
enum class DeckKind : std::uint8_t { kUnknown, kAbaqus, kRadioss, kLsDyna, kOpenSees };

/// Returns whose deck a file is, by its first lines; kUnknown also where it cannot be read.
DeckKind kind_of_deck(const std::filesystem::path& file);

}  // namespace slipbench::driver::import
