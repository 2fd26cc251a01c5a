// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/comment_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <utility>

namespace slipbench::driver::base {

std::vector<std::string> comment_lines(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  for (const int byte : {0xEF, 0xBB, 0xBF}) {
    if (stream.peek() == byte) stream.get();
  }
  const auto is_blank = [](int byte) {
    return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n';
  };
  std::vector<std::string> lines;
  for (std::string line;;) {
    while (is_blank(stream.peek())) stream.get();
    if (stream.peek() != '#' || !std::getline(stream, line)) return lines;
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(std::move(line));
  }
}

std::vector<std::pair<std::string, std::string>> column_units(std::string_view line) {
  constexpr std::string_view kBetween = ", ";
  std::vector<std::pair<std::string, std::string>> units;
  line.remove_prefix(std::min(kColumnsMark.size(), line.size()));
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(kBetween), line.size());
    const std::string_view entry = line.substr(0, end);
    const std::size_t bracket = std::min(entry.find(" ["), entry.size());
    std::string_view unit = entry.substr(std::min(bracket + 2, entry.size()));
    if (unit.ends_with(']')) unit.remove_suffix(1);
    units.emplace_back(entry.substr(0, bracket), unit);
    line.remove_prefix(std::min(end + kBetween.size(), line.size()));
  }
  return units;
}

}  // namespace slipbench::driver::base
