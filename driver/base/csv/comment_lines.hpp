// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slipbench::driver::base {

/// Lines of a file that begin with '#', up to the first that does not, without their ends and the
/// byte-order mark that some editors put before a text; none of a file that cannot be read.
std::vector<std::string> comment_lines(const std::filesystem::path& file);

/// Beginning of the line in which a file of the program states the units of its columns.
inline constexpr std::string_view kColumnsMark = "# columns: ";

/// Names and units in such a line, "# columns: t [s], MU []"; the unit is empty where there is
/// none.
std::vector<std::pair<std::string, std::string>> column_units(std::string_view line);

}  // namespace slipbench::driver::base
