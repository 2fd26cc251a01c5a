// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::exports {

/// A title as a line of a deck by itself: one that begins as a keyword, a command or a comment of
/// some program does is none of these.
inline std::string title_line(std::string_view title) {
  const std::size_t first = title.find_first_not_of(' ');
  const bool begins =
      first != title.npos && std::string_view("*/#$").find(title[first]) != std::string_view::npos;
  return (begins ? "title: " : "") + base::printable(title);
}

/// A name between the quotes of a keyword's parameter.
inline std::string name_in_quotes(std::string_view name) {
  std::string text = base::printable(name);
  std::ranges::replace(text, '"', '\'');
  return '"' + text + '"';
}

}  // namespace slipbench::driver::exports
