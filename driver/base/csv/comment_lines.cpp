// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/comment_lines.hpp"

#include <fstream>
#include <utility>

namespace slipbench::driver::base {

std::vector<std::string> comment_lines(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  for (const int byte : {0xEF, 0xBB, 0xBF}) {
    if (stream.peek() == byte) stream.get();
  }
  std::vector<std::string> lines;
  for (std::string line; stream.peek() == '#' && std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace slipbench::driver::base
