// SPDX-License-Identifier: Apache-2.0
#include "driver/import/deck_kind.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace slipbench::driver::import {
namespace {

/// The part of a file that tells: what stands before it are comments.
constexpr std::size_t kHead = std::size_t{1} << 16U;

std::string word_of(std::string_view line) {
  std::string word;
  for (const char c : line) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',') break;
    word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return word;
}

DeckKind kind_of_line(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos) return DeckKind::kUnknown;
  const std::string_view text = std::string_view(line).substr(begin);
  const std::string word = word_of(text);
  if (text.starts_with("#RADIOSS") ||
      (text.size() > 1 && text.front() == '/' && std::isupper(text[1]) != 0)) {
    return DeckKind::kRadioss;
  }
  // Words of LS-DYNA are joined by '_', those of Abaqus by blanks.
  if (word.starts_with("*KEYWORD") || word.starts_with("*DEFINE_") ||
      word.starts_with("*CONTROL_") || word.starts_with("*CONTACT_")) {
    return DeckKind::kLsDyna;
  }
  if (word.size() > 1 && word.front() == '*' &&
      std::isalpha(static_cast<unsigned char>(word[1])) != 0) {
    return DeckKind::kAbaqus;
  }
  if (word == "FRICTIONMODEL" || word == "WIPE" || word == "MODEL" || word == "IMPORT" ||
      word == "FROM" || word.find("OPS.") == 0 || line.find("frictionModel") != line.npos) {
    return DeckKind::kOpenSees;
  }
  return DeckKind::kUnknown;
}

}  // namespace

DeckKind kind_of_text(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::istringstream lines{std::string(text.substr(0, kHead))};
  for (std::string line; std::getline(lines, line);) {
    const DeckKind kind = kind_of_line(line);
    if (kind != DeckKind::kUnknown) return kind;
  }
  return DeckKind::kUnknown;
}

DeckKind kind_of_deck(const std::filesystem::path& file) {
  // To open a pipe would wait for its writer.
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return DeckKind::kUnknown;
  std::ifstream stream(file, std::ios::binary);
  std::string head(kHead, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return kind_of_text(head);
}

}  // namespace slipbench::driver::import
