// SPDX-License-Identifier: Apache-2.0
// Names in the formulas of a case, and what becomes of them there.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace slipbench::driver::exports {

/// Returns the names that a formula mentions, those of functions left out.
std::set<std::string> names_in(std::string_view formula);

/// Returns the names at whose values pieces of a formula may meet: those in an argument of abs,
/// max, min, rint or sign, or all where the formula has a comparison.
std::set<std::string> names_in_pieces(std::string_view formula);

}  // namespace slipbench::driver::exports
