// SPDX-License-Identifier: Apache-2.0
#include "driver/import/radioss/starter_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/import/radioss/deck_line.hpp"

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
  constexpr std::array<std::string_view, 7> kWhole{"BEGIN", "FRICTION",  "FRIC_ORIENT", "GRPART",
                                                   "INTER", "PARAMETER", "UNIT"};
  constexpr std::array<std::string_view, 1> kKeywords{"PART"};
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

int integer_in(std::string_view word) {
  int id = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), id);
  return read.ec == std::errc{} && read.ptr == word.data() + word.size() && id >= 1 ? id : 0;
}

int id_of(const DeckBlock& block, std::size_t index) {
  return index >= block.words.size() ? 0 : integer_in(block.words[index]);
}

int with_offset(int id, int offset) {
  constexpr long long kLargest = std::numeric_limits<int>::max();
  // A sum outside the range of ids becomes its nearer end; 0 is none.
  const long long sum = static_cast<long long>(id) + offset;
  return id > 0 ? static_cast<int>(std::clamp(sum, 0LL, kLargest)) : id;
}

namespace {

constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 30U;
constexpr std::size_t kDeepestInclude = 15;

/// Goes through the texts of a deck, in the order in which they include each other.
class Splitter {
 public:
  Splitter(StarterDeck& deck, const import::DeckFolder& folder, base::Diagnostics& out)
      : deck_(deck),
        out_(out),
        open_files_(folder, std::string(deck.texts[0].name()), kDeepestInclude) {}

  void split(std::size_t file) {
    const base::SourceText source = deck_.texts[file];
    const std::string_view text = source.text();
    if (const std::size_t at = first_control(text); at != std::string_view::npos) {
      out_.error(source.name(), source.position(at), {},
                 "is no text: a starter deck has no control characters",
                 text[at] == '\r' ? "a carriage return stands without a line feed" : "");
      return;
    }
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = without_end_blanks(text.substr(begin, end - begin));
      begin = end + 1;
      const bool comment = !line.empty() && (line.front() == '#' || line.front() == '$');
      if (header_lines_ > 0 && !comment && (line.empty() || line.front() != '/')) {
        if (--header_lines_ == 0) take_offsets(line);
      } else if (line.empty()) {
        blank_ = line;
        // A card of an interface may have no numbers, and counts.
        if (open_ && deck_.blocks.back().words.front() == "INTER") {
          deck_.blocks.back().lines.push_back(line);
        }
      } else if (line.front() == '/') {
        if (!begin_block(line)) return;
      } else if (comment) {
        if (in_capitals(line.substr(0, 8)) == "#INCLUDE") include(line);
      } else if (open_) {
        DeckBlock& block = deck_.blocks.back();
        block.lines.push_back(line);
        if (!block.gap) block.gap = blank_;
      }
    }
  }

 private:
  /// Returns false at the end of the deck.
  bool begin_block(std::string_view line) {
    open_ = false;
    header_lines_ = 0;
    blank_.reset();
    std::vector<std::string> words = words_of(line);
    if (words.front() == "END") return false;
    // A keyword with two slashes has an empty first word.
    if (words.size() > 1 && words[0].empty()) {
      if (words[1] == "SUBMODEL") begin_submodel(words);
      if (words[1] == "ENDSUB") {
        submodel_ = {};
        in_submodel_ = false;
      }
      return true;
    }
    const Use use = use_of(words.front());
    if (use == Use::kNone) return true;
    if (in_submodel_ && words.front() == "BEGIN") submodel_.unit_id = -submodels_;
    deck_.blocks.push_back({std::move(words), line, {}, {}, submodel_});
    open_ = use == Use::kLines;
    return true;
  }

  /// Of //SUBMODEL/id/unit_ID/V2017 a title and the offsets follow.
  void begin_submodel(const std::vector<std::string>& words) {
    ++submodels_;
    in_submodel_ = true;
    submodel_ = {};
    if (words.size() > 3) submodel_.unit_id = integer_in(words[3]);
    if (words.size() > 4 && !words[4].empty()) submodel_.version = integer_in(words[4].substr(1));
    header_lines_ = 2;
  }

  void take_offsets(std::string_view line) {
    const auto field = [&](std::size_t column, const char* name) {
      const auto value = read_field(line, {column * 10, 10, name, true}, {});
      if (value) return static_cast<int>(*value);
      out_.error(deck_.texts.name(line), deck_.texts.position(value.error().text), "//SUBMODEL",
                 value.error().message);
      return 0;
    };
    submodel_.offset = field(0, "off_def");
    submodel_.part_offset = field(3, "off_part");
    if (submodel_.part_offset == 0) submodel_.part_offset = submodel_.offset;
  }

  void include(std::string_view line) {
    std::string_view name = line.substr(8);
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    auto source = open_files_.open(name, kDeckSizeLimit);
    if (source) {
      split(deck_.texts.add(std::move(*source)));
      open_files_.close();
    } else if (source.error().is_missing) {
      deck_.has_includes = true;
      out_.warning(deck_.texts.name(line), deck_.texts.position(line), "#include",
                   "the file cannot be read: what it has is missing here", source.error().hint);
    } else {
      out_.error(deck_.texts.name(line), deck_.texts.position(line), "#include",
                 source.error().message);
    }
  }

  StarterDeck& deck_;
  base::Diagnostics& out_;
  import::OpenFiles open_files_;
  bool open_ = false;
  bool in_submodel_ = false;
  Submodel submodel_;
  int submodels_ = 0;
  int header_lines_ = 0;  ///< of a //SUBMODEL, that are to come
  std::optional<std::string_view> blank_;
};

/// Takes the numbers of a /PARAMETER block: below the title a name and a number a line.
void take_parameters(const DeckBlock& block, StarterDeck& deck, base::Diagnostics& out) {
  for (std::size_t i = 1; i < block.lines.size(); ++i) {
    const std::string_view line = block.lines[i];
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    const std::size_t number = std::min(line.find_first_not_of(" \t", end), line.size());
    // Texts and formulas are parameters, too, and nobody asks for them as numbers.
    if (const auto value = parse_fortran_number(line.substr(number))) {
      const std::string_view name = line.substr(begin, end - begin);
      const auto [known, is_new] = deck.parameters.try_emplace(std::string(name), *value);
      if (is_new || known->second == *value) continue;
      out.error(deck.texts.name(name), deck.texts.position(name), "/PARAMETER",
                fmt::format("'{}' stands twice, with {} and {}", base::printable(name),
                            base::format_number(known->second), base::format_number(*value)));
    }
  }
}

}  // namespace

StarterDeck split_deck(const base::SourceText& source, const import::DeckFolder& folder,
                       base::Diagnostics& out) {
  StarterDeck deck{.texts = import::DeckTexts(source), .blocks = {}};
  Splitter(deck, folder, out).split(0);
  for (const DeckBlock& block : deck.blocks) {
    if (block.words.front() == "PARAMETER") take_parameters(block, deck, out);
  }
  return deck;
}

}  // namespace slipbench::driver::radioss
