// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::plot {

/// A text in at most `most` lines of at most `length` letters, broken at blanks; a word that is
/// longer is broken anywhere. The last line of a text that does not fit ends in " ...". Letters are
/// those of UTF-8. `length` is at least 5.
std::vector<std::string> lines_of_length(std::string_view text, std::size_t length,
                                         std::size_t most);

/// The same in one line; empty for an empty text.
std::string one_line(std::string_view text, std::size_t length);

/// Letters of a definition's name that a picture has room for.
inline constexpr std::size_t kNameLength = 48;

}  // namespace slipbench::driver::plot
