// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <tl/expected.hpp>

namespace slipbench::driver::base {

/// Opens a file to be read. Errors, with the name of the file: it cannot be read, and why; or it is
/// no regular file: the end of a pipe or a device may never come.
tl::expected<std::ifstream, std::string> open_regular(const std::filesystem::path& file);

}  // namespace slipbench::driver::base
