// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/file_mark.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "driver/base/text/hash.hpp"

namespace slipbench::driver::base {
namespace {

constexpr std::string_view kSeal = "# slipbench replaces this file as long as it is unchanged: ";

bool is_sealed(const std::string& text) {
  const std::size_t seal = text.rfind(kSeal);
  return seal != std::string::npos && sealed(text.substr(0, seal)) == text;
}

std::string read_piece(std::ifstream& stream, std::size_t size) {
  std::string piece(size, '\0');
  stream.read(piece.data(), static_cast<std::streamsize>(size));
  piece.resize(static_cast<std::size_t>(stream.gcount()));
  return piece;
}

}  // namespace

std::string sealed(std::string text) {
  const char* end = text.ends_with("\r\n") ? "\r\n" : "\n";
  if (!text.ends_with('\n')) text += '\n';
  return text + fmt::format("{}{:016x}{}", kSeal, hash(text), end);
}

bool carries(const std::filesystem::path& file, const FileMark& mark) {
  if (mark.start.empty() && mark.text.empty()) return false;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  const std::string head = read_piece(stream, kMarkedBytes);
  if (error || !head.starts_with(mark.start)) return false;
  if (mark.text_ends_line_1) {
    const std::size_t end = head.find('\n');
    return end != std::string::npos && head.compare(end, mark.text.size(), mark.text) == 0;
  }
  bool found = head.find(mark.text) != std::string::npos;
  stream.clear();
  if (!found) {
    stream.seekg(-static_cast<std::streamoff>(std::min<std::uintmax_t>(size, kMarkedBytes)),
                 std::ios::end);
    found = read_piece(stream, kMarkedBytes).find(mark.text) != std::string::npos;
  }
  if (!found || !mark.sealed) return found;
  stream.clear();
  stream.seekg(0);
  return is_sealed({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()});
}

}  // namespace slipbench::driver::base
