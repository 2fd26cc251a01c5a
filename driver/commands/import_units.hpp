// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/units/units.hpp"

namespace slipbench::driver::commands {

/// Splits a text at blanks and commas.
std::vector<std::string> words_of(const std::string& text);

/// Reads "mm N s", the units of length, force and time of a deck. Error: a sentence.
tl::expected<base::UnitSystem, std::string> parse_units(const std::string& text);

}  // namespace slipbench::driver::commands
