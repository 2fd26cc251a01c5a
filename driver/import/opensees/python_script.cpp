// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/import/opensees/script.hpp"

namespace slipbench::driver::opensees {
namespace {

constexpr auto kPython = import::FormulaLanguage::kPython;

/// Goes through the characters that stand outside of quotes; `take` ends it by returning false.
template <class Take>
void for_each_outside(std::string_view text, Take take) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
      continue;
    }
    if (c == '"' || c == '\'') quote = c;
    if (c == ']' || c == '}' || c == ')') --depth;
    if (!take(i, depth)) return;
    if (c == '[' || c == '{' || c == '(') ++depth;
  }
}

/// The first place of a character outside of quotes and brackets, or npos.
std::size_t find_outside(std::string_view text, char wanted) {
  std::size_t found = text.npos;
  for_each_outside(text, [&](std::size_t i, int depth) {
    if (depth <= 0 && text[i] == wanted) found = i;
    return found == text.npos;
  });
  return found;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = find_outside(text, separator);
    const std::string_view part = without_blanks(text.substr(0, at));
    if (!part.empty()) parts.push_back(part);
    if (at == text.npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// Fate of a block; open where its condition is no number.
enum class Runs { kYes, kNo, kOpen };

/// Block that lines with more blanks before them belong to.
struct Block {
  std::size_t indent = 0;
  Runs runs = Runs::kYes;
  std::optional<ScriptNames> outside = {};  ///< names outside of a function
};

class PythonReader {
 public:
  explicit PythonReader(Script& script) : script_(script) {}

  void read() {
    const base::SourceText& source = script_.texts[0];
    std::string whole;
    std::string_view where;
    std::size_t indent = 0;
    for (int number = 1; number <= source.line_count(); ++number) {
      const std::string_view line = source.line(number);
      const std::string_view text = without_blanks(without_comment(line));
      if (whole.empty()) {
        if (text.empty()) continue;
        where = line;
        indent = static_cast<std::size_t>(text.data() - line.data());
      }
      const bool goes_on = text.ends_with('\\');
      whole += std::string(text.substr(0, text.size() - (goes_on ? 1 : 0))) + " ";
      // A call goes on until its parenthesis closes.
      const bool open = is_call(whole) && std::count(whole.begin(), whole.end(), '(') >
                                              std::count(whole.begin(), whole.end(), ')');
      if ((goes_on || open) && number < source.line_count()) continue;
      leave_blocks(indent);
      take_line(without_blanks(whole), indent, where);
      whole.clear();
    }
  }

 private:
  static std::string_view without_comment(std::string_view line) {
    std::size_t end = line.size();
    for_each_outside(line, [&](std::size_t i, int) {
      if (line[i] == '#') end = i;
      return end == line.size();
    });
    return line.substr(0, end);
  }

  static bool is_call(std::string_view text) {
    return text.find("frictionModel(") != text.npos || text.find("element(") != text.npos;
  }

  void leave_blocks(std::size_t indent) {
    while (!blocks_.empty() && indent <= blocks_.back().indent) {
      if (blocks_.back().outside) names_ = std::move(*blocks_.back().outside);
      blocks_.pop_back();
    }
    branches_.erase(branches_.upper_bound(indent), branches_.end());
  }

  Runs now() const { return blocks_.empty() ? Runs::kYes : blocks_.back().runs; }

  void take_line(std::string_view text, std::size_t indent, std::string_view where) {
    const std::size_t end = std::min(text.find_first_of(" \t:("), text.size());
    const std::string_view word = text.substr(0, end);
    constexpr std::array<std::string_view, 11> kHeads{
        "if", "elif", "else", "for", "while", "def", "with", "try", "except", "finally", "class"};
    const std::size_t colon = find_outside(text, ':');
    if (colon == text.npos || std::find(kHeads.begin(), kHeads.end(), word) == kHeads.end()) {
      if (word != "elif" && word != "else") branches_.erase(indent);
      if (now() == Runs::kNo) return;
      for (const std::string_view one : split(text, ';')) take(one, where);
      return;
    }
    blocks_.push_back(block_of(word, without_blanks(text.substr(end, colon - end)), indent));
    if (now() == Runs::kNo) return;
    for (const std::string_view one : split(text.substr(colon + 1), ';')) take(one, where);
  }

  /// The block that a head begins.
  Block block_of(std::string_view word, std::string_view rest, std::size_t indent) {
    Block block{.indent = indent, .runs = now()};
    if (word == "if" || word == "elif" || word == "else") {
      if (word == "if") branches_[indent] = Runs::kNo;
      block.runs = joined(block.runs, branch(word, rest, branches_[indent]));
      return block;
    }
    branches_.erase(indent);
    if (word == "def" || word == "class") {
      block.outside = names_;
      const std::size_t open = rest.find('(');
      if (open == rest.npos) return block;
      const std::string_view arguments = rest.substr(open + 1, rest.rfind(')') - open - 1);
      for (const std::string_view one : split(arguments, ',')) {
        const std::string_view name = one.substr(0, one.find_first_of(" :="));
        names_.forget(std::string(name), "is an argument of a function");
      }
    } else if (word == "for" || word == "while" || word == "except") {
      const std::size_t in = rest.find(" in ");
      for (const std::string_view name : split(rest.substr(0, in == rest.npos ? 0 : in), ',')) {
        names_.forget(std::string(name), "goes through a list");
      }
      block.runs = joined(block.runs, Runs::kOpen);
    }
    return block;
  }

  static Runs joined(Runs outer, Runs inner) {
    if (outer == Runs::kNo || inner == Runs::kNo) return Runs::kNo;
    return outer == Runs::kOpen ? outer : inner;
  }

  /// Tells whether a branch is run; `before`: whether one above it is.
  Runs branch(std::string_view word, std::string_view condition, Runs& before) const {
    if (before == Runs::kYes) return Runs::kNo;
    Runs own = Runs::kYes;
    if (word != "else" && condition.find("__name__") == condition.npos) {
      const auto value = names_.value_of(condition, kPython);
      own = !value ? Runs::kOpen : value->value != 0.0 ? Runs::kYes : Runs::kNo;
    }
    if (own == Runs::kNo) return own;
    const Runs runs = before == Runs::kOpen ? Runs::kOpen : own;
    before = own == Runs::kYes ? Runs::kYes : Runs::kOpen;
    return runs;
  }

  void take(std::string_view text, std::string_view where) {
    if (is_call(text)) {
      record(text, where);
      return;
    }
    const std::size_t equals = find_outside(text, '=');
    if (equals == text.npos || equals == 0 || text.substr(equals + 1, 1) == "=") return;
    std::string_view left = text.substr(0, equals);
    const std::string value(without_blanks(text.substr(equals + 1)));
    if (std::string_view("<>!").find(left.back()) != std::string_view::npos) return;
    // `mu += 0.1`, `mu **= 2`: the marks of an operator before '='.
    const std::size_t mark = left.find_last_not_of("+-*/%&|^@");
    const std::string_view operation = left.substr(mark + 1);
    left = without_blanks(left.substr(0, mark + 1));
    if (!operation.empty()) {
      assign(std::string(left), fmt::format("{} {} ({})", left, operation, value));
      return;
    }
    const std::vector<std::string_view> names = split(left, ',');
    if (names.size() == 1) {
      assign(std::string(without_blanks(left.substr(0, left.find(':')))), value);
      return;
    }
    const std::vector<std::string_view> values = split(value, ',');
    std::vector<std::string> numbers;
    for (const std::string_view one : values) {
      // All are evaluated before any is set.
      const auto number = names_.value_of(one, kPython);
      numbers.push_back(number ? base::format_number(number->value) : std::string(one));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      assign(std::string(names[i]), names.size() == numbers.size() ? numbers[i] : value);
    }
  }

  void assign(const std::string& name, const std::string& value) {
    if (now() == Runs::kOpen) {
      names_.forget(name, "is set in a block that may not be run");
    } else {
      names_.assign(name, value, kPython);
    }
  }

  void record(std::string_view text, std::string_view where) {
    const std::size_t begin = text.find('(');
    const std::size_t end = text.rfind(')');
    if (end == text.npos || end < begin) return;
    std::string_view name = without_blanks(text.substr(0, begin));
    name.remove_prefix(name.rfind('.') + 1);
    if (!is_wanted(name)) return;
    ScriptCommand command{.words = {std::string(name)}, .where = where};
    for (const std::string_view one : split(text.substr(begin + 1, end - begin - 1), ',')) {
      const bool quoted = one.size() >= 2 && (one.front() == '"' || one.front() == '\'') &&
                          one.back() == one.front();
      std::string word(quoted ? one.substr(1, one.size() - 2) : one);
      if (!quoted) {
        if (const auto value = names_.value_of(one, kPython)) {
          word = base::format_number(value->value);
        } else {
          command.faults[command.words.size()] = value.error();
        }
      }
      command.words.push_back(std::move(word));
    }
    script_.commands.push_back(std::move(command));
  }

  Script& script_;
  ScriptNames names_;
  std::vector<Block> blocks_;
  std::map<std::size_t, Runs> branches_;  ///< by indent: whether one of an if was run
};

}  // namespace

void read_python(Script& script) { PythonReader(script).read(); }

}  // namespace slipbench::driver::opensees
