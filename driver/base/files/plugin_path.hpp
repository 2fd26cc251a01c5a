// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace slipbench::driver::base {

/// Returns where a library is that comes with the program: beside it where it was built, under
/// lib/slipbench where it is installed; nothing if it is in neither.
std::optional<std::filesystem::path> plugin_path(std::string_view name);

}  // namespace slipbench::driver::base
