// SPDX-License-Identifier: Apache-2.0
// Arguments of the command line, and the files that they name.
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::commands {

/// The case that is named: the path as it is, or, if there is nothing of that name, the file
/// that is called so with .yaml or .yml, as tables show it; with a warning if both are there.
std::string named_case(const std::string& path);

/// Returns why `-o` names no folder: it is a file by its ending, or "-". A sentence, or nothing.
/// \param whose of what the files in it bear the name: "case"
std::string folder_fault(const std::string& folder, std::string_view whose);

}  // namespace slipbench::driver::commands
