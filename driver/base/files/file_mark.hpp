// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace slipbench::driver::base {

/// Mark in a file that this program wrote for one purpose, so that the next one like it may
/// take its place.
struct FileMark {
  std::string owner = {};         ///< whose file it is, for messages: "a result of shock.yaml"
  std::string start = {};         ///< its first bytes
  std::string text = {};          ///< stands in its first or last kMarkedBytes
  bool text_ends_line_1 = false;  ///< stands where the first line ends, and nowhere else
  bool sealed = false;            ///< has not changed since `sealed` made it
};

inline constexpr std::size_t kMarkedBytes = 4096;

/// A YAML text, which people go on to work on, with a last line by which it is known whether it was
/// changed since: only an unchanged one carries a mark that is sealed.
std::string sealed(std::string text);

/// Returns whether a file carries a mark; a mark without bytes is carried by none, nor is one
/// carried by a file that cannot be read.
bool carries(const std::filesystem::path& file, const FileMark& mark);

}  // namespace slipbench::driver::base
