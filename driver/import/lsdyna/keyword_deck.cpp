// SPDX-License-Identifier: Apache-2.0
#include "driver/import/lsdyna/keyword_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "driver/import/radioss/deck_line.hpp"

namespace slipbench::driver::lsdyna {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return text.substr(0, 0);
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string in_capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

bool is_read(std::string_view keyword) {
  constexpr std::array<std::string_view, 7> kRead{"CONTACT_",     "DEFINE_FRICTION", "DEFINE_TABLE",
                                                  "DEFINE_CURVE", "SET_PART",        "PARAMETER",
                                                  "INCLUDE"};
  return std::any_of(kRead.begin(), kRead.end(),
                     [&](std::string_view one) { return keyword.starts_with(one); });
}

class Splitter {
 public:
  Splitter(KeywordDeck& deck, const std::string& folder, base::Diagnostics& out)
      : deck_(deck), folder_(folder), out_(out), open_files_{std::string(deck.texts[0].name())} {}

  void split(std::size_t file, int depth) {
    bool open = false;
    const base::SourceText& source = deck_.texts[file];
    for (int number = 1; number <= source.line_count(); ++number) {
      std::string_view line = source.line(number);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line.starts_with('$')) continue;
      if (!line.starts_with('*')) {
        if (!open) continue;
        if (deck_.blocks.back().keyword == "INCLUDE") {
          include(trimmed(line), depth);
          // Its cards are file names.
          open = false;
        } else {
          deck_.blocks.back().cards.push_back(line);
        }
        continue;
      }
      open = begin(line);
      if (ended_) return;
    }
  }

 private:
  bool begin(std::string_view line) {
    std::string keyword = in_capitals(trimmed(line.substr(1)));
    if (keyword == "END") {
      ended_ = true;
      return false;
    }
    if (keyword.starts_with("KEYWORD")) {
      long_ = keyword.find("LONG=Y") != keyword.npos || keyword.find("LONG=K") != keyword.npos;
      return false;
    }
    bool is_long = long_;
    while (!keyword.empty() && (keyword.back() == '+' || keyword.back() == '-')) {
      is_long = keyword.back() == '+';
      keyword.pop_back();
    }
    keyword = std::string(trimmed(keyword));
    if (!is_read(keyword)) return false;
    deck_.blocks.push_back({std::move(keyword), line, {}, is_long});
    return true;
  }

  void include(std::string_view name, int depth) {
    constexpr int kDeepestInclude = 20;
    constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;
    const std::string path = (std::filesystem::path(folder_) / name).string();
    if (depth >= kDeepestInclude || import::is_open(open_files_, path)) {
      out_.error(deck_.texts.name(name), deck_.texts.position(name), "*INCLUDE",
                 "files include each other without end");
      return;
    }
    if (auto source = base::read_source(path, kDeckSizeLimit)) {
      open_files_.push_back(path);
      split(deck_.texts.add(std::move(*source)), depth + 1);
      open_files_.pop_back();
      ended_ = false;
      return;
    }
    out_.warning(deck_.texts.name(name), deck_.texts.position(name), "*INCLUDE",
                 "the file cannot be read: what it has is missing here",
                 "files that a deck includes are looked for in its folder");
  }

  KeywordDeck& deck_;
  const std::string& folder_;
  base::Diagnostics& out_;
  std::vector<std::string> open_files_;  ///< those that are being read, each included by the last
  bool long_ = false;
  bool ended_ = false;
};

/// Takes the numbers of *PARAMETER: pairs of "R name" and a value. Names know no case.
void take_parameters(const KeywordDeck& deck, const Block& block, base::NamedNumbers& parameters,
                     base::Diagnostics& out) {
  const CardReader reader(deck, block, out);
  for (std::size_t card = 0; card < reader.count(); ++card) {
    for (std::size_t field = 0; field < 8; field += 2) {
      const std::string_view word = reader.text(card, field);
      const std::string type = in_capitals(word.substr(0, 1));
      if (type != "R" && type != "I") continue;
      const auto value = radioss::parse_fortran_number(reader.text(card, field + 1));
      if (!value) continue;
      const std::string name = in_capitals(trimmed(word.substr(1)));
      std::string small = name;
      std::transform(small.begin(), small.end(), small.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      parameters[std::string(trimmed(word.substr(1)))] = *value;
      parameters[name] = *value;
      parameters[small] = *value;
    }
  }
}

}  // namespace

KeywordDeck split_deck(const base::SourceText& source, const std::string& folder,
                       base::Diagnostics& out) {
  KeywordDeck deck{.texts = import::DeckTexts(source)};
  Splitter(deck, folder, out).split(0, 0);
  for (const Block& block : deck.blocks) {
    if (block.keyword.starts_with("PARAMETER")) {
      take_parameters(deck, block, deck.parameters, out);
    }
  }
  return deck;
}

std::string_view CardReader::text(std::size_t card, std::size_t field, std::size_t columns) const {
  if (card >= block_.cards.size()) return block_.where.substr(block_.where.size());
  std::string_view line = block_.cards[card];
  if (line.find(',') != line.npos) {
    for (; field > 0 && !line.empty(); --field) {
      const std::size_t comma = line.find(',');
      line.remove_prefix(comma == line.npos ? line.size() : comma + 1);
    }
    return trimmed(line.substr(0, line.find(',')));
  }
  // Long format widens fields of 10 columns; those of curves are 20 wide in both.
  const std::size_t width = block_.is_long ? std::max<std::size_t>(columns, 20) : columns;
  return trimmed(line.substr(std::min(field * width, line.size()), width));
}

double CardReader::number(std::size_t card, std::size_t field, std::string_view name,
                          std::size_t columns) {
  if (!sound_) return 0.0;
  const std::string_view piece = text(card, field, columns);
  const auto value = radioss::read_field(
      piece, {0, std::max<std::size_t>(1, piece.size()), name, false}, deck_.parameters);
  if (value) return *value;
  fault(piece, value.error().message);
  return 0.0;
}

int CardReader::id(std::size_t card, std::size_t field, std::string_view name,
                   std::size_t columns) {
  const double value = number(card, field, name, columns);
  if (value == std::trunc(value) && std::abs(value) <= std::numeric_limits<int>::max()) {
    return static_cast<int>(value);
  }
  fault(text(card, field, columns), fmt::format("{}: wanted an integer", name));
  return 0;
}

void CardReader::fault(std::string_view piece, const std::string& message) {
  sound_ = false;
  out_.error(deck_.texts.name(piece), deck_.texts.position(piece),
             radioss::shortened(trimmed(block_.where), 60), message);
}

}  // namespace slipbench::driver::lsdyna
