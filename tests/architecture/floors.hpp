// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/architecture/source_file.hpp"

namespace slipbench::architecture {

/// A folder of law/ or driver/ without its subfolders, and its namespace below slipbench.
struct Room {
  std::string_view folder;  ///< from the root: "driver/base/text"
  std::string_view name;    ///< "driver::base"
};

/// The rooms of law/ and driver/, from the ground up.
std::span<const Room> floors();

/// Finds what a C++ file of law/ or driver/ does against the order of the rooms: a header of
/// a room above its own, or lies in no room. Files of other folders have no violations.
std::vector<Violation> floor_violations(const SourceFile& file);

/// Finds where a C++ file of law/ or driver/ opens a namespace that is neither its room's nor that
/// of a room below it, such as the one of a template that it specialises. Files of other folders
/// have no violations.
std::vector<Violation> namespace_violations(const SourceFile& file);

}  // namespace slipbench::architecture
