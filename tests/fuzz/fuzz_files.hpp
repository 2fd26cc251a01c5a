// SPDX-License-Identifier: Apache-2.0
// Folder and files for readers that take a path.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace slipbench::fuzz {

/// Returns an empty folder of this process, in which it stands from the first call on: a relative
/// name leads nowhere else. In memory where the system has such a place.
const std::filesystem::path& own_folder();

/// Writes a file into the folder and returns its path.
std::filesystem::path own_file(std::string_view name, std::string_view bytes);

/// Copies the files of a folder of the sources, such as "cases/sweeps", into the folder; once.
void copy_of_sources(std::string_view folder);

}  // namespace slipbench::fuzz
