// SPDX-License-Identifier: Apache-2.0
// Names in the formulas of a case, and what becomes of them there.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace slipbench::driver::exports {

/// Returns the names that a formula mentions, those of functions left out.
std::set<std::string> names_in(std::string_view formula);

/// Tells whether a formula may have pieces that meet at values of these names: one of them stands
/// in an argument of abs, max, min, rint or sign, or in a formula with a comparison.
bool has_pieces_of(std::string_view formula, const std::set<std::string>& names);

}  // namespace slipbench::driver::exports
