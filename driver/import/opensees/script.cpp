// SPDX-License-Identifier: Apache-2.0
#include "driver/import/opensees/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/number.hpp"

namespace slipbench::driver::opensees {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

/// Splits at separators that stand outside of quotes and brackets.
template <class IsSeparator>
std::vector<std::string> split(std::string_view text, IsSeparator is_separator) {
  std::vector<std::string> parts;
  std::string part;
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{' || c == '(') {
      ++depth;
    } else if (c == ']' || c == '}' || c == ')') {
      --depth;
    } else if (depth <= 0 && is_separator(c)) {
      if (!trimmed(part).empty()) parts.push_back(trimmed(part));
      part.clear();
      continue;
    }
    part += c;
  }
  if (!trimmed(part).empty()) parts.push_back(trimmed(part));
  return parts;
}

std::string without_quotes(std::string word) {
  const auto pair = [&](char open, char close) {
    return word.size() >= 2 && word.front() == open && word.back() == close;
  };
  if (pair('"', '"') || pair('\'', '\'') || pair('{', '}')) word = word.substr(1, word.size() - 2);
  return trimmed(word);
}

bool is_name(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// Replaces all of one text by another.
void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Writes pow(a, b) as (a)^(b).
void replace_powers(std::string& text) {
  constexpr std::string_view kPower = "pow(";
  for (std::size_t at = text.find(kPower); at != text.npos; at = text.find(kPower)) {
    std::size_t comma = text.npos;
    std::size_t end = at + kPower.size();
    for (int depth = 1; end < text.size(); ++end) {
      if (text[end] == '(') ++depth;
      if (text[end] == ')' && --depth == 0) break;
      if (text[end] == ',' && depth == 1) comma = end;
    }
    if (comma == text.npos || end == text.size()) return;
    const std::size_t first = at + kPower.size();
    text = text.substr(0, at) + "((" + text.substr(first, comma - first) + ")^(" +
           text.substr(comma + 1, end - comma - 1) + "))" + text.substr(end + 1);
  }
}

bool is_wanted(std::string_view name) { return name == "frictionModel" || name == "element"; }

class Reader {
 public:
  explicit Reader(Script& script) : script_(script) {}

  void read() {
    const base::SourceText& source = script_.texts[0];
    std::string whole;
    std::string_view where;
    for (int number = 1; number <= source.line_count(); ++number) {
      const std::string_view line = source.line(number);
      if (whole.empty()) where = line;
      std::string text = trimmed(line.substr(0, comment(line)));
      const bool goes_on = text.ends_with('\\');
      if (goes_on) text.pop_back();
      whole += text + " ";
      // A call in Python goes on until its parenthesis closes.
      const bool open = is_call(whole) && std::count(whole.begin(), whole.end(), '(') >
                                              std::count(whole.begin(), whole.end(), ')');
      if ((goes_on || open) && number < source.line_count()) continue;
      for (const std::string& one : split(whole, [](char c) { return c == ';'; })) {
        take(one, where);
      }
      whole.clear();
    }
  }

 private:
  /// The place of a comment, outside of quotes.
  static std::size_t comment(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (quote != 0) {
        if (line[i] == quote) quote = 0;
      } else if (line[i] == '"' || line[i] == '\'') {
        quote = line[i];
      } else if (line[i] == '#') {
        return i;
      }
    }
    return line.size();
  }

  static bool is_call(std::string_view text) {
    return text.find("frictionModel(") != text.npos || text.find("element(") != text.npos;
  }

  void take(const std::string& text, std::string_view where) {
    if (is_call(text)) {
      const std::size_t begin = text.find('(');
      const std::size_t end = text.rfind(')');
      if (end == text.npos || end < begin) return;
      std::string name = trimmed(std::string_view(text).substr(0, begin));
      name.erase(0, name.rfind('.') + 1);
      if (!is_wanted(name)) return;
      std::vector<std::string> words{name};
      for (const std::string& word :
           split(std::string_view(text).substr(begin + 1, end - begin - 1),
                 [](char c) { return c == ','; })) {
        words.push_back(without_quotes(word));
      }
      script_.commands.push_back({std::move(words), where});
      return;
    }
    std::vector<std::string> words = split(text, is_blank);
    if (words.empty()) return;
    if (is_wanted(words.front())) {
      for (std::string& word : words) word = without_quotes(std::move(word));
      script_.commands.push_back({std::move(words), where});
    } else if (words.front() == "set" && words.size() == 3) {
      assign(words[1], without_quotes(words[2]));
    } else {
      const std::size_t equals = text.find('=');
      if (equals == text.npos || text.find("==") != text.npos) return;
      assign(trimmed(std::string_view(text).substr(0, equals)),
             trimmed(std::string_view(text).substr(equals + 1)));
    }
  }

  void assign(const std::string& name, const std::string& value) {
    if (!is_name(name)) return;
    const auto number = number_of(script_, value);
    if (number) {
      script_.numbers[name] = *number;
    } else {
      // What it was is not what it is.
      script_.numbers.erase(name);
      script_.unread[name] = value;
    }
  }

  Script& script_;
};

}  // namespace

Script read_script(const base::SourceText& source) {
  Script script{.texts = import::DeckTexts(source)};
  Reader(script).read();
  return script;
}

tl::expected<double, std::string> number_of(const Script& script, std::string_view word) {
  if (const auto number = base::parse_number(word)) return *number;
  std::string text(word);
  replace_all(text, "[expr", "(");
  replace_all(text, "]", ")");
  replace_all(text, "**", "^");
  replace_powers(text);
  // Braces group what is evaluated, a dollar stands before a name.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '{' || c == '}' || c == '$'; }, ' ');
  const auto compiled = base::Expression::compile(text, {}, script.numbers);
  const auto value = compiled ? (*compiled)({}) : tl::unexpected(compiled.error());
  if (value) return *value;
  const auto unread = script.unread.find(value.error().unknown_name);
  if (unread != script.unread.end()) {
    return tl::unexpected(fmt::format("'{}': {} is set to '{}', which is not read as a number",
                                      word, unread->first, base::printable(unread->second)));
  }
  return tl::unexpected(fmt::format("'{}': {}", word, value.error().message));
}

}  // namespace slipbench::driver::opensees
