// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/text_lines.hpp"

#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::plot {
namespace {

constexpr std::string_view kGoesOn = " ...";

/// Bytes of the first `letters` letters.
std::size_t bytes_of(std::string_view text, std::size_t letters) {
  std::size_t i = 0;
  while (i < text.size()) {
    if (!base::continues_character(text[i]) && letters-- == 0) break;
    ++i;
  }
  return i;
}

/// The part of a text that a line of this length takes.
std::string_view line_of(std::string_view text, std::size_t length) {
  const std::size_t fits = bytes_of(text, length);
  if (fits == text.size()) return text;
  const std::size_t blank = text.rfind(' ', fits);
  return text.substr(0, blank == std::string_view::npos || blank == 0 ? fits : blank);
}

}  // namespace

std::vector<std::string> lines_of_length(std::string_view text, std::size_t length,
                                         std::size_t most) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < most) {
    std::string_view line = line_of(text, length);
    const bool cut = lines.size() + 1 == most && line.size() < text.size();
    if (cut) line = line_of(text, length - kGoesOn.size());
    lines.emplace_back(line);
    if (cut) lines.back() += kGoesOn;
    text.remove_prefix(line.size());
    if (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lines;
}

std::string one_line(std::string_view text, std::size_t length) {
  const std::vector<std::string> lines = lines_of_length(text, length, 1);
  return lines.empty() ? std::string() : lines.front();
}

}  // namespace slipbench::driver::plot
