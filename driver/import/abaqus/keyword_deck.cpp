// SPDX-License-Identifier: Apache-2.0
#include "driver/import/abaqus/keyword_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <utility>

#include "driver/base/text/suggestions.hpp"
#include "driver/import/abaqus/keyword_list.hpp"

namespace slipbench::driver::abaqus {
namespace {

namespace fs = std::filesystem;

// Decks carry the whole mesh.
constexpr std::size_t kDeckSizeLimit = std::size_t{1} << 32U;
constexpr std::size_t kDeepestInclude = 20;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\f\v";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == text.npos) return text.substr(text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// The first character that is no blank, or 0.
char first_mark(std::string_view line) {
  for (const char c : line) {
    if (c != ' ' && c != '\t') return c;
  }
  return 0;
}

bool is_comment(std::string_view line) { return trimmed(line).starts_with("**"); }

std::string small(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace

const Parameter* Block::find(std::string_view wanted) const {
  for (const Parameter& one : parameters) {
    if (folded(one.name) == folded(wanted)) return &one;
  }
  return nullptr;
}

std::string Block::value_of(std::string_view wanted) const {
  const Parameter* const one = find(wanted);
  return one == nullptr ? "" : std::string(one->value.value_or(""));
}

Items split_items(std::string_view line) {
  Items items;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != ',' || quoted) continue;
    items.push_back(trimmed(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  const std::string_view last = trimmed(line.substr(begin));
  if (!last.empty()) items.push_back(last);
  return items;
}

std::string label_of(std::string_view item) {
  if (item.find('"') == item.npos) return folded(item);
  return shown(item);
}

std::string shown(std::string_view item) {
  std::string out;
  for (const char c : item) {
    if (c != '"') out += c;
  }
  return out;
}

std::optional<KeywordDeck> KeywordDeck::read(const std::string& path, base::Diagnostics& out,
                                             bool& environment_failure, bool allow_outside) {
  auto source = base::read_source(path, kDeckSizeLimit);
  if (!source) {
    out.add(source.error().diagnostic);
    environment_failure = source.error().failure == base::ReadFailure::kEnvironment;
    return std::nullopt;
  }
  return read_text(std::move(*source), {fs::path(path).parent_path().string(), allow_outside}, out);
}

KeywordDeck KeywordDeck::read_text(base::SourceText text, const import::DeckFolder& folder,
                                   base::Diagnostics& out) {
  KeywordDeck deck(out, import::OpenFiles(folder, std::string(text.name()), kDeepestInclude));
  deck.files_.add(std::move(text));
  deck.scan(0, true);
  return deck;
}

/// Goes through the lines of a file. Those before its first keyword belong to the block that was
/// open where it was included.
void KeywordDeck::scan(std::size_t file, bool is_first) {
  const base::SourceText source = files_[file];
  int data = 1;
  const auto end_data = [&](int line) {
    if (!blocks_.empty() && line > data) blocks_.back().data.push_back({file, data, line});
    for (; blocks_.empty() && data < line; ++data) {
      const std::string_view text = trimmed(source.line(data));
      if (text.empty() || is_comment(text)) continue;
      out_->error(files_.name(text), files_.position(text), {}, "data before the first keyword",
                  "a keyword begins with '*'");
      break;
    }
  };
  for (int line = 1; line <= source.line_count(); ++line) {
    const std::string_view text = source.line(line);
    if (first_mark(text) != '*' || is_comment(text)) continue;
    end_data(line);
    begin_block(file, line);
    data = line + 1;
    if (blocks_.back().keyword != "INCLUDE") continue;
    const Block block = blocks_.back();
    blocks_.pop_back();
    include(block);
  }
  end_data(source.line_count() + 1);
  if (is_first) {
    for (const Block& block : blocks_) {
      if (block.keyword == "PARAMETER") read_parameters(block);
    }
  }
}

/// Reads a keyword line and those it goes on in; `line` becomes the last of them.
void KeywordDeck::begin_block(std::size_t file, int& line) {
  const base::SourceText& source = files_[file];
  std::string_view text = trimmed(source.line(line));
  Items items = split_items(text);
  Block block{.keyword = trimmed(items.front().substr(1)), .where = items.front()};
  const std::string_view comment = trimmed(source.line(line - 1));
  constexpr std::string_view kName = "** Name: ";
  if (comment.starts_with(kName)) block.name = trimmed(comment.substr(kName.size()));
  const FoundName keyword = find_keyword(block.keyword);
  if (!keyword.name.empty()) block.keyword = keyword.name;
  const auto rules = read_keywords();
  const auto rule = std::find_if(rules.begin(), rules.end(),
                                 [&](const KeywordRule& one) { return one.name == keyword.name; });
  const bool is_read = rule != rules.end();
  // A shortened name that might be one of those that are read must be known.
  if (keyword.name.empty() && !keyword.candidates.empty()) {
    const bool matters = std::any_of(
        keyword.candidates.begin(), keyword.candidates.end(), [&](std::string_view candidate) {
          return std::any_of(rules.begin(), rules.end(),
                             [&](const KeywordRule& one) { return one.name == candidate; });
        });
    if (matters) {
      error(block.where, block, "may mean " + base::in_words(keyword.candidates));
    }
  }
  // So would be one whose name has a letter too few or too many.
  if (keyword.name.empty() && keyword.candidates.empty()) {
    constexpr std::size_t kLongName = 8;
    constexpr std::size_t kSlips = 2;
    for (const KeywordRule& one : rules) {
      if (one.name.size() < kLongName || block.keyword.size() > one.name.size() + kSlips ||
          base::name_distance(block.keyword, one.name) > kSlips) {
        continue;
      }
      error(block.where, block, "is no keyword that is known",
            fmt::format("did you mean *{}?", one.name));
      break;
    }
  }
  bool first = true;
  while (true) {
    for (std::size_t i = first ? 1 : 0; i < items.size() && is_read; ++i) {
      const std::string_view item = items[i];
      if (item.empty()) continue;
      const std::size_t equals = item.find('=');
      Parameter one{.name = trimmed(item.substr(0, equals)), .where = item};
      if (equals != item.npos) one.value = trimmed(item.substr(equals + 1));
      if (!rule->parameters.empty()) {
        const FoundName name = find_name(one.name, rule->parameters);
        const bool is_other = rule->has_others && name.candidates.empty();
        if (name.name.empty() && !is_other) {
          error(item, block,
                name.candidates.empty() ? fmt::format("*{} has no parameter '{}'", rule->name,
                                                      base::printable(one.name))
                                        : fmt::format("'{}' may mean {}", base::printable(one.name),
                                                      base::in_words(name.candidates)));
          continue;
        }
        if (!name.name.empty()) one.name = name.name;
      }
      block.parameters.push_back(one);
    }
    if (!text.ends_with(',') || line >= source.line_count()) break;
    const std::string_view next = source.line(line + 1);
    if (first_mark(next) == '*') break;
    text = trimmed(next);
    items = split_items(text);
    first = false;
    ++line;
  }
  blocks_.push_back(std::move(block));
}

void KeywordDeck::include(const Block& block) {
  const Parameter* const input = block.find("INPUT");
  if (input == nullptr || !input->value) {
    error(block.where, block, "names no file: INPUT= is missing");
    return;
  }
  auto source = open_files_.open(shown(*input->value), kDeckSizeLimit);
  if (!source) {
    error(input->where, block, source.error().message, source.error().hint);
    return;
  }
  scan(files_.add(std::move(*source)), false);
  open_files_.close();
}

void KeywordDeck::read_parameters(const Block& block) {
  for_each_line(block, [&](std::string_view line) {
    const std::string_view text = trimmed(line.substr(0, line.find('#')));
    if (text.empty()) return;
    const std::size_t equals = text.find('=');
    if (equals == text.npos) {
      error(text, block, "wanted name = value");
      return;
    }
    const std::string name = small(trimmed(text.substr(0, equals)));
    std::string formula;
    for (std::size_t i = equals + 1; i < text.size(); ++i) {
      const bool power = text.substr(i, 2) == "**";
      formula += power ? '^' : text[i];
      i += power ? 1 : 0;
    }
    const auto compiled = base::Expression::compile(small(formula), {}, numbers_);
    const auto value = compiled ? (*compiled)({}) : tl::unexpected(compiled.error());
    if (!value) {
      error(text, block, value.error().message,
            "*PARAMETER is read as arithmetic of numbers and earlier names");
      return;
    }
    if (!numbers_.emplace(name, *value).second) error(text, block, "is stated twice");
  });
}

void KeywordDeck::for_each_line(const Block& block,
                                const std::function<void(std::string_view)>& take) const {
  for (const LineRange& range : block.data) {
    for (int line = range.first; line < range.end; ++line) {
      const std::string_view text = trimmed(files_[range.file].line(line));
      if (!text.empty() && !text.starts_with("**")) take(text);
    }
  }
}

std::vector<Items> KeywordDeck::lines(const Block& block) const {
  std::vector<Items> all;
  for_each_line(block, [&](std::string_view line) { all.push_back(split_items(line)); });
  return all;
}

tl::expected<double, std::string> KeywordDeck::number(std::string_view item) const {
  if (item.size() > 2 && item.front() == '<' && item.back() == '>') {
    const auto found = numbers_.find(small(trimmed(item.substr(1, item.size() - 2))));
    if (found != numbers_.end()) return found->second;
    return tl::unexpected(fmt::format("{} is no name of *PARAMETER", base::shortened(item, 60)));
  }
  std::string text(item);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  double value = 0.0;
  // Neither a second sign nor the words that from_chars knows.
  const bool plain = begin != end && (std::isdigit(static_cast<unsigned char>(*begin)) != 0 ||
                                      *begin == '.' || (*begin == '-' && begin == text.data()));
  const bool words = text.find_first_of("nNiI") != text.npos;
  const auto [stop, fault] = std::from_chars(begin, end, value);
  if (!plain || words || fault != std::errc() || stop != end) {
    return tl::unexpected(fmt::format("'{}' is no number", base::shortened(item, 60)));
  }
  return value;
}

long KeywordDeck::whole(std::string_view item, long otherwise) const {
  const auto value = number(item);
  if (!value || *value != std::floor(*value) || std::abs(*value) > 1e15) return otherwise;
  return static_cast<long>(*value);
}

void KeywordDeck::error(std::string_view piece, const Block& block, std::string message,
                        std::string hint) const {
  out_->error(files_.name(piece), files_.position(piece), "*" + std::string(block.keyword),
              std::move(message), std::move(hint));
}

void KeywordDeck::warning(std::string_view piece, const Block& block, std::string message,
                          std::string hint) const {
  out_->warning(files_.name(piece), files_.position(piece), "*" + std::string(block.keyword),
                std::move(message), std::move(hint));
}

}  // namespace slipbench::driver::abaqus
