// SPDX-License-Identifier: Apache-2.0
#include "driver/import/lsdyna/keyword_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "driver/import/radioss/deck_line.hpp"
#include "driver/import/script_formula.hpp"

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

std::string in_small_letters(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool is_read(std::string_view keyword) {
  constexpr std::array<std::string_view, 6> kRead{"CONTACT_",     "DEFINE_FRICTION", "DEFINE_TABLE",
                                                  "DEFINE_CURVE", "SET_PART",        "PARAMETER"};
  return std::any_of(kRead.begin(), kRead.end(),
                     [&](std::string_view one) { return keyword.starts_with(one); });
}

class Splitter {
 public:
  Splitter(KeywordDeck& deck, const import::DeckFolder& folder, base::Diagnostics& out)
      : deck_(deck),
        out_(out),
        open_files_(folder, std::string(deck.texts[0].name()), kDeepestInclude) {}

  void split(std::size_t file) {
    Cards cards = Cards::kNone;
    std::string name;
    std::string_view name_where;
    const base::SourceText source = deck_.texts[file];
    for (int number = 1; number <= source.line_count(); ++number) {
      std::string_view line = source.line(number);
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line.starts_with('$')) continue;
      if (line.starts_with('*')) {
        name.clear();
        cards = begin(line);
        if (ended_) return;
      } else if (cards == Cards::kRead) {
        deck_.blocks.back().cards.push_back(line);
      } else if (cards == Cards::kFiles && !trimmed(line).empty()) {
        if (name.empty()) name_where = trimmed(line);
        // A long name goes on in the next line.
        std::string_view part = trimmed(line);
        const bool goes_on = part.ends_with(" +");
        if (goes_on) part = trimmed(part.substr(0, part.size() - 1));
        name += part;
        if (goes_on) continue;
        include(name, name_where);
        name.clear();
      }
    }
  }

 private:
  /// Use of the cards below a keyword.
  enum class Cards { kNone, kRead, kFiles };

  Cards begin(std::string_view line) {
    std::string keyword = in_capitals(trimmed(line.substr(1)));
    if (keyword.empty()) return Cards::kNone;
    if (keyword == "END") {
      ended_ = true;
      return Cards::kNone;
    }
    if (keyword.starts_with("KEYWORD")) {
      long_ = keyword.find("LONG=Y") != keyword.npos || keyword.find("LONG=K") != keyword.npos;
      return Cards::kNone;
    }
    bool is_long = long_;
    const std::size_t end = std::min(keyword.find_first_of(kBlanks), keyword.size());
    const std::string rest(trimmed(keyword.substr(end)));
    keyword.resize(end);
    const char sign = rest.empty() ? keyword.back() : rest.front();
    if (sign == '+' || sign == '-') is_long = sign == '+';
    while (!keyword.empty() && (keyword.back() == '+' || keyword.back() == '-')) keyword.pop_back();
    const bool is_include = keyword == "INCLUDE";
    if ((is_include || is_read(keyword)) && rest.find_first_not_of("+-%$") == 0) {
      out_.error(deck_.texts.name(line), deck_.texts.position(trimmed(line)), "*" + keyword,
                 "text behind the keyword: what it means is not known",
                 "what belongs to it stands in the lines below; comments begin with '$'");
      return Cards::kNone;
    }
    if (is_include) return Cards::kFiles;
    if (keyword.starts_with("INCLUDE_")) {
      out_.warning(deck_.texts.name(line), deck_.texts.position(trimmed(line)), "*" + keyword,
                   "is not followed: what it brings is missing here",
                   "*INCLUDE is: give the file the ids and the units that it has in the deck");
      return Cards::kNone;
    }
    if (!is_read(keyword)) return Cards::kNone;
    deck_.blocks.push_back({std::move(keyword), line, {}, is_long});
    return Cards::kRead;
  }

  void include(const std::string& name, std::string_view where) {
    constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;
    auto source = open_files_.open(name, kDeckSizeLimit);
    if (source) {
      split(deck_.texts.add(std::move(*source)));
      open_files_.close();
      ended_ = false;
    } else if (source.error().is_missing) {
      out_.warning(deck_.texts.name(where), deck_.texts.position(where), "*INCLUDE",
                   "the file cannot be read: what it has is missing here", source.error().hint);
    } else {
      out_.error(deck_.texts.name(where), deck_.texts.position(where), "*INCLUDE",
                 source.error().message);
    }
  }

  static constexpr std::size_t kDeepestInclude = 20;
  KeywordDeck& deck_;
  base::Diagnostics& out_;
  import::OpenFiles open_files_;
  bool long_ = false;
  bool ended_ = false;
};

/// Gives a parameter a number, under its name as it is and in capitals and small letters. One that
/// has a number keeps it, which is told: *PARAMETER_DUPLICATION, which may say otherwise, is not
/// read.
void set_parameter(std::string_view name, const import::ScriptNumber& number, KeywordDeck& deck,
                   import::ScriptNumbers& typed, base::Diagnostics& out) {
  const std::string small = in_small_letters(name);
  const auto [known, is_new] = typed.try_emplace(small, number);
  if (!is_new && known->second.value != number.value) {
    out.warning(deck.texts.name(name), deck.texts.position(name), "*PARAMETER",
                fmt::format("'{}' stands twice: it keeps its first number", base::printable(name)));
  }
  for (const std::string& spelt : {std::string(name), in_capitals(name), small}) {
    deck.parameters[spelt] = known->second.value;
  }
}

/// Takes the numbers of *PARAMETER: pairs of "R name" and a value. Names know no case.
void take_parameters(KeywordDeck& deck, const Block& block, import::ScriptNumbers& typed,
                     base::Diagnostics& out) {
  const CardReader reader(deck, block, out);
  for (std::size_t card = 0; card < reader.count(); ++card) {
    for (std::size_t field = 0; field < 8; field += 2) {
      const std::string_view word = reader.text(card, field);
      const std::string type = in_capitals(word.substr(0, 1));
      if (type != "R" && type != "I") continue;
      const auto value = radioss::parse_fortran_number(reader.text(card, field + 1));
      if (!value) continue;
      set_parameter(trimmed(word.substr(1)), {*value, type == "I"}, deck, typed, out);
    }
  }
}

/// Takes the numbers of *PARAMETER_EXPRESSION: "R name" in 10 columns, or up to a comma, and a
/// formula, which goes on in lines that begin with 10 blanks. Whole numbers divide as integers.
void take_expressions(KeywordDeck& deck, const Block& block, import::ScriptNumbers& typed,
                      base::Diagnostics& out) {
  constexpr std::size_t kName = 10;
  const auto split = [&](std::string_view card) {
    const std::size_t comma = std::min(card.find(','), card.size());
    // A comma behind the name, not one between the arguments of a function.
    const bool free = card.substr(0, comma).find('(') == card.npos && comma < card.size();
    const std::size_t end = std::min(free ? comma : kName, card.size());
    return std::pair(trimmed(card.substr(0, end)),
                     card.substr(std::min(end + (free ? 1 : 0), card.size())));
  };
  for (std::size_t i = 0; i < block.cards.size(); ++i) {
    const auto [word, first] = split(block.cards[i]);
    const std::string type = in_capitals(word.substr(0, 1));
    if (type != "R" && type != "I") continue;
    std::string formula = in_small_letters(first);
    for (; i + 1 < block.cards.size() && trimmed(block.cards[i + 1].substr(0, kName)).empty();
         ++i) {
      formula += " " + in_small_letters(trimmed(block.cards[i + 1]));
    }
    std::replace(formula.begin(), formula.end(), '&', ' ');
    const auto value = import::evaluate_formula(formula, typed, import::FormulaLanguage::kFortran);
    if (!value) {
      const std::string_view piece =
          first.substr(std::min(value.error().offset, first.size() - (first.empty() ? 0 : 1)));
      out.error(deck.texts.name(piece), deck.texts.position(piece.substr(0, 1)),
                "*PARAMETER_EXPRESSION", value.error().message);
      continue;
    }
    const bool whole = type == "I";
    set_parameter(trimmed(word.substr(1)), {whole ? std::trunc(value->value) : value->value, whole},
                  deck, typed, out);
  }
}

}  // namespace

KeywordDeck split_deck(const base::SourceText& source, const import::DeckFolder& folder,
                       base::Diagnostics& out) {
  KeywordDeck deck{.texts = import::DeckTexts(source)};
  Splitter(deck, folder, out).split(0);
  import::ScriptNumbers typed;
  for (const Block& block : deck.blocks) {
    if (block.keyword.starts_with("PARAMETER_EXPRESSION")) {
      take_expressions(deck, block, typed, out);
    } else if (block.keyword.starts_with("PARAMETER")) {
      take_parameters(deck, block, typed, out);
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

bool CardReader::is_blank(std::size_t card) const {
  return card >= block_.cards.size() || trimmed(block_.cards[card]).empty();
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
