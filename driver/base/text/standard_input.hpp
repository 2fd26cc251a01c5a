// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace slipbench::driver::base {

/// The path that stands for standard input, and what it is called.
inline constexpr std::string_view kStandardInput = "-";
inline constexpr std::string_view kStandardInputName = "stdin";

/// Returns what the text of a path is called, in messages and in the names of results.
inline std::string source_name(const std::string& path) {
  return path == kStandardInput ? std::string(kStandardInputName) : path;
}

}  // namespace slipbench::driver::base
