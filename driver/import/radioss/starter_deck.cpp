// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/starter_deck.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace slipbench::driver::radioss {
namespace {

std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

std::string_view without_end_blanks(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// "/FRICTION/7 " to {"FRICTION", "7"}.
std::vector<std::string> words_of(std::string_view keyword) {
  std::vector<std::string> words;
  std::size_t begin = 1;
  while (begin <= keyword.size()) {
    const std::size_t end = std::min(keyword.find('/', begin), keyword.size());
    words.push_back(in_capitals(without_end_blanks(keyword.substr(begin, end - begin))));
    begin = end + 1;
  }
  return words;
}

/// Use of a block: none, that it is there, or its lines.
enum class Use { kNone, kKeyword, kLines };

Use use_of(std::string_view word) {
  constexpr std::array<std::string_view, 4> kWhole{"BEGIN", "FRICTION", "FRIC_ORIENT", "GRPART"};
  constexpr std::array<std::string_view, 2> kKeywords{"INTER", "PART"};
  if (std::find(kWhole.begin(), kWhole.end(), word) != kWhole.end()) return Use::kLines;
  const bool keyword = std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
  return keyword ? Use::kKeyword : Use::kNone;
}

/// The first byte that no text has, or npos.
std::size_t first_control(std::string_view text) {
  const auto at = std::find_if(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F;
  });
  return at == text.end() ? std::string_view::npos
                          : static_cast<std::size_t>(std::distance(text.begin(), at));
}

}  // namespace

base::SourcePosition position_of(const base::SourceText& source, std::string_view piece) {
  const auto offset = static_cast<std::size_t>(piece.data() - source.text().data());
  return source.position(offset, std::max<std::size_t>(1, piece.size()));
}

int id_of(const DeckBlock& block, std::size_t index) {
  if (index >= block.words.size()) return 0;
  const std::string& word = block.words[index];
  int id = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), id);
  return read.ec == std::errc{} && read.ptr == word.data() + word.size() && id >= 1 ? id : 0;
}

StarterDeck split_deck(const base::SourceText& source, base::Diagnostics& out) {
  StarterDeck deck{source, {}, false, false};
  const std::string_view text = source.text();
  if (const std::size_t at = first_control(text); at != std::string_view::npos) {
    out.error(source.name(), source.position(at), {},
              "is no text: a starter deck has no control characters",
              text[at] == '\r' ? "a carriage return stands without a line feed" : "");
    return deck;
  }
  DeckBlock* open = nullptr;
  std::optional<std::string_view> blank;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = without_end_blanks(text.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty()) {
      blank = line;
      continue;
    }
    if (line.front() == '/') {
      open = nullptr;
      blank.reset();
      std::vector<std::string> words = words_of(line);
      if (words.front() == "END") break;
      // A keyword with two slashes has an empty first word.
      const bool submodel = words.size() > 1 && words[0].empty() && words[1] == "SUBMODEL";
      deck.has_submodels = deck.has_submodels || submodel;
      const Use use = use_of(words.front());
      if (use == Use::kNone) continue;
      deck.blocks.push_back({std::move(words), line, {}, {}});
      if (use == Use::kLines) open = &deck.blocks.back();
    } else if (line.front() == '#' || line.front() == '$') {
      deck.has_includes = deck.has_includes || in_capitals(line.substr(0, 8)) == "#INCLUDE";
    } else if (open != nullptr) {
      open->lines.push_back(line);
      if (!open->gap) open->gap = blank;
    }
  }
  return deck;
}

}  // namespace slipbench::driver::radioss
