// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>

namespace slipbench::live {

/// Reads a double as std::from_chars does.
std::from_chars_result read_number(const char* first, const char* last, double& value);

/// Writes a double as std::to_chars does: the shortest text that reads back to it, with a power of
/// ten where that is shorter.
std::to_chars_result write_number(char* first, char* last, double value);

}  // namespace slipbench::live
