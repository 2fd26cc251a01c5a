// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slipbench::driver::base {

/// Lines of a file that begin with '#', up to the first that does not, without their ends and the
/// byte-order mark that some editors put before a text; none of a file that cannot be read.
std::vector<std::string> comment_lines(const std::filesystem::path& file);

}  // namespace slipbench::driver::base
