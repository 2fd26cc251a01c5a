// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/architecture/source_file.hpp"

namespace slipbench::architecture {

/// The rooms of law/ and driver/, from the ground up. A room is a folder without its subfolders.
std::span<const std::string_view> floors();

/// What a C++ file of law/ or driver/ does against the order of the rooms: it includes a header of
/// a room above its own, or lies in no room. Files of other folders have no violations.
std::vector<Violation> floor_violations(const SourceFile& file);

}  // namespace slipbench::architecture
