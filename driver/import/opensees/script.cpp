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

/// Replaces all of one text by another.
void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Tells a script in Python by its imports and calls.
bool is_python(const base::SourceText& source) {
  if (source.name().ends_with(".py")) return true;
  if (source.name().ends_with(".tcl")) return false;
  for (int number = 1; number <= source.line_count(); ++number) {
    const std::string_view line = without_blanks(source.line(number));
    if (line.starts_with("import ") || line.starts_with("from ")) return true;
    for (const std::string_view call : {"frictionModel", "element"}) {
      const std::size_t at = line.starts_with('#') ? line.npos : line.find(call);
      if (at != line.npos && without_blanks(line.substr(at + call.size())).starts_with('(')) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool is_wanted(std::string_view name) { return name == "frictionModel" || name == "element"; }

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == text.npos) return text.substr(text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool is_name(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

tl::expected<import::ScriptNumber, std::string> ScriptNames::value_of(
    std::string_view word, import::FormulaLanguage language) const {
  if (const auto number = base::parse_number(word)) {
    return import::ScriptNumber{*number, import::is_whole_literal(word)};
  }
  std::string text(word);
  if (language == import::FormulaLanguage::kTcl) {
    replace_all(text, "[expr", "(");
    replace_all(text, "]", ")");
    // Braces and quotes group what is evaluated.
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '{' || c == '}' || c == '"'; }, ' ');
    replace_all(text, "$ ", "$");  // of ${name}
  }
  const auto value = import::evaluate_formula(text, numbers, language);
  if (value) return *value;
  const auto found = unread.find(value.error().unknown_name);
  const std::string shown = base::printable(word);
  return tl::unexpected(found != unread.end()
                            ? fmt::format("'{}': {} {}", shown, found->first, found->second)
                            : fmt::format("'{}': {}", shown, value.error().message));
}

void ScriptNames::assign(const std::string& name, const std::string& word,
                         import::FormulaLanguage language) {
  if (!is_name(name)) return;
  if (const auto number = value_of(word, language)) {
    numbers[name] = *number;
    unread.erase(name);
  } else {
    forget(name,
           fmt::format("is set to '{}', which is not read as a number", base::printable(word)));
  }
}

void ScriptNames::forget(const std::string& name, std::string why) {
  if (!is_name(name)) return;
  numbers.erase(name);
  unread[name] = std::move(why);
}

Script read_script(const base::SourceText& source, base::Diagnostics& out) {
  Script script{.texts = import::DeckTexts(source)};
  if (is_python(source)) {
    read_python(script);
  } else {
    read_tcl(script, out);
  }
  return script;
}

tl::expected<double, std::string> number_of(const ScriptCommand& command, std::size_t index) {
  if (const auto fault = command.faults.find(index); fault != command.faults.end()) {
    return tl::unexpected(fault->second);
  }
  const std::string& word = command.words[index];
  if (const auto number = base::parse_number(word)) return *number;
  return tl::unexpected(fmt::format("'{}' is no number", base::printable(word)));
}

}  // namespace slipbench::driver::opensees
