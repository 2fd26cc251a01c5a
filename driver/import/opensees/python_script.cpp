// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/import/opensees/script.hpp"

namespace slipbench::driver::opensees {
namespace {

constexpr auto kPython = import::FormulaLanguage::kPython;

/// Line of a program: it goes on in brackets and behind a '\\'.
struct Line {
  std::string text;        ///< without comments; of strings, only letters, digits and marks
  std::string_view where;  ///< the first line of the file that it takes
  std::size_t indent = 0;
  bool sets_in_text = false;  ///< it has a string in which ':=' stands
};

/// Takes a script apart into the lines of the program.
class LineReader {
 public:
  LineReader(const Script& script, base::Diagnostics& out)
      : script_(script), out_(out), all_(script.texts[0].text()) {}

  std::vector<Line> read() {
    while (at_ < all_.size()) {
      const char c = all_[at_];
      if (c == '\n' && brackets_.empty()) {
        end_line();
        ++at_;
      } else if (c == '\\' && (all_.substr(at_ + 1).starts_with('\n') ||
                               all_.substr(at_ + 1).starts_with("\r\n"))) {
        at_ = all_.find('\n', at_) + 1;
        line_.text += ' ';
      } else if (c == '#') {
        at_ = std::min(all_.find('\n', at_), all_.size());
      } else if (c == '"' || c == '\'') {
        take_string(c);
      } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
        if (!line_.text.empty()) line_.text += ' ';
        ++at_;
      } else {
        take_code(c);
      }
    }
    end_line();
    if (!brackets_.empty()) fault(brackets_.front(), "this bracket is never closed");
    return std::move(lines_);
  }

 private:
  void fault(std::size_t at, const char* message) {
    const std::string_view piece = all_.substr(at, 1);
    out_.error(script_.texts.name(piece), script_.texts.position(piece), {}, message);
  }

  void begin_line() {
    if (!line_.text.empty()) return;
    const std::size_t before = at_ == 0 ? all_.npos : all_.rfind('\n', at_ - 1);
    const std::size_t begin = before == all_.npos ? 0 : before + 1;
    line_.indent = at_ - begin;
    line_.where =
        without_blanks(all_.substr(at_, std::min(all_.find('\n', at_), all_.size()) - at_));
  }

  void end_line() {
    line_.text = std::string(without_blanks(line_.text));
    if (!line_.text.empty()) lines_.push_back(std::move(line_));
    line_ = {};
  }

  void take_code(char c) {
    begin_line();
    if (c == '(' || c == '[' || c == '{') brackets_.push_back(at_);
    if ((c == ')' || c == ']' || c == '}') && !brackets_.empty()) brackets_.pop_back();
    line_.text += c;
    ++at_;
  }

  void take_string(char quote) {
    begin_line();
    const std::size_t begin = at_;
    const std::string three(3, quote);
    const bool is_long = all_.substr(at_).starts_with(three);
    const std::string_view mark = is_long ? std::string_view(three) : all_.substr(at_, 1);
    at_ += mark.size();
    line_.text += '"';
    while (at_ < all_.size() && !all_.substr(at_).starts_with(mark)) {
      if (!is_long && all_[at_] == '\n') break;
      if (all_[at_] == '\\') ++at_;
      if (at_ >= all_.size()) break;
      if (all_.substr(at_).starts_with(":=")) line_.sets_in_text = true;
      const char c = all_[at_];
      line_.text += is_in_name(c) || c == '-' || c == '.' ? c : '?';
      ++at_;
    }
    line_.text += '"';
    if (at_ >= all_.size() || !all_.substr(at_).starts_with(mark)) {
      fault(begin, "this quote is never closed");
      at_ = std::min(at_, all_.size());
    } else {
      at_ += mark.size();
    }
  }

  const Script& script_;
  base::Diagnostics& out_;
  std::string_view all_;
  std::size_t at_ = 0;
  std::vector<std::size_t> brackets_;  ///< that are open
  Line line_;
  std::vector<Line> lines_;
};

/// Goes through the characters that stand outside of quotes; `take` ends it by returning false.
template <class Take>
void for_each_outside(std::string_view text, Take take) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted || c == '"') continue;
    if (c == ']' || c == '}' || c == ')') --depth;
    if (!take(i, depth)) return;
    if (c == '[' || c == '{' || c == '(') ++depth;
  }
}

/// A text without what stands in quotes.
std::string without_strings(std::string_view text) {
  std::string code;
  for_each_outside(text, [&](std::size_t i, int) {
    code += text[i];
    return true;
  });
  return code;
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
  bool is_function = false;
};

class PythonReader {
 public:
  PythonReader(Script& script, base::Diagnostics& out) : script_(script), out_(out) {}

  void read() {
    lines_ = LineReader(script_, out_).read();
    constexpr std::array<std::string_view, 9> kReaching{"global", "nonlocal",  "globals",
                                                        "exec",   "setattr",   "__dict__",
                                                        "vars",   "importlib", "__import__"};
    for (const Line& line : lines_) {
      for_each_word(line.text, [&](std::string_view word) {
        if (is_in(kReaching, word)) reaches_ = true;
      });
    }
    for (index_ = 0; index_ < lines_.size() && !ended_; ++index_) {
      const Line& line = lines_[index_];
      leave_blocks(line.indent);
      if (line.sets_in_text) names_.forget_all();
      take_line(line.text, line.indent, line.where);
    }
  }

 private:
  void leave_blocks(std::size_t indent) {
    while (!blocks_.empty() && indent <= blocks_.back().indent) {
      if (blocks_.back().is_function) names_.leave();
      blocks_.pop_back();
    }
    branches_.erase(branches_.upper_bound(indent), branches_.end());
  }

  Runs now() const { return blocks_.empty() ? Runs::kYes : blocks_.back().runs; }

  void take_line(std::string_view text, std::size_t indent, std::string_view where) {
    if (text.starts_with("async ")) text = without_blanks(text.substr(6));
    const std::size_t end = std::min(text.find_first_of(" :([{\"*-"), text.size());
    const std::string_view word = text.substr(0, end);
    constexpr std::array<std::string_view, 13> kHeads{"if",    "elif",  "else", "for",    "while",
                                                      "def",   "with",  "try",  "except", "finally",
                                                      "class", "match", "case"};
    const std::size_t colon = head_end(text);
    const bool soft = word == "match" || word == "case";
    const bool head = colon != text.npos && is_in(kHeads, word) &&
                      (!soft || (colon > end && find_equals(text) == text.npos));
    if (!head) {
      if (word != "elif" && word != "else") branches_.erase(indent);
      if (now() == Runs::kNo) return;
      take_all(text, where);
      return;
    }
    blocks_.push_back(block_of(word, without_blanks(text.substr(end, colon - end)), indent, where));
    if (blocks_.back().runs == Runs::kNo) return;
    take_all(text.substr(colon + 1), where);
  }

  /// The ':' that ends a head: not one of a lambda or of ':='.
  static std::size_t head_end(std::string_view text) {
    std::size_t found = text.npos;
    std::size_t lambdas = 0;
    for_each_outside(text, [&](std::size_t i, int depth) {
      if (depth > 0) return true;
      const bool begins = i == 0 || !is_in_name(text[i - 1]);
      const std::string_view rest = text.substr(i);
      if (begins && rest.starts_with("lambda") && rest.size() > 6 && !is_in_name(rest[6])) {
        ++lambdas;
      }
      if (text[i] != ':' || text.substr(i + 1).starts_with('=')) return true;
      if (lambdas > 0) {
        --lambdas;
        return true;
      }
      found = i;
      return false;
    });
    return found;
  }

  void take_all(std::string_view text, std::string_view where) {
    for (const std::string_view one : split(text, ';')) {
      if (!ended_) take(one, where);
    }
  }

  /// The block that a head begins.
  Block block_of(std::string_view word, std::string_view rest, std::size_t indent,
                 std::string_view where) {
    Block block{.indent = indent, .runs = now()};
    if (block.runs == Runs::kNo) {
      branches_.erase(indent);
      return block;
    }
    settle(rest);
    if (word != "def") tell(rest, where);
    if (word == "class" && reaches_) names_.forget_all();
    const bool of_if = word == "if" || branches_.contains(indent);
    if (word == "if" || ((word == "elif" || word == "else") && of_if)) {
      if (word == "if") branches_[indent] = Runs::kNo;
      block.runs = joined(block.runs, branch(word, rest, branches_[indent]));
      return block;
    }
    branches_.erase(indent);
    if (word == "def" || word == "class") {
      const std::string_view name = rest.substr(0, rest.find_first_of("(: ["));
      own_.emplace(name);
      names_.forget(std::string(name), "is a function of the script");
      block.is_function = true;
      names_.enter();
      const std::size_t open = std::min(rest.find('('), rest.size());
      for_each_word(rest.substr(open), [&](std::string_view argument) {
        names_.forget(std::string(argument), "is an argument of a function");
      });
      return block;
    }
    if (word == "for" || word == "while") {
      forget_block(rest, indent);
      if (word == "for") {
        forget_named(rest.substr(0, rest.find(" in ")), "goes through a list");
      }
    } else if (word == "with" || word == "except" || word == "case") {
      forget_named(rest, kNotFollowed);
    }
    block.runs = joined(block.runs, Runs::kOpen);
    return block;
  }

  /// Forgets the names in a loop, as the first of its lines may be run after the last.
  void forget_block(std::string_view rest, std::size_t indent) {
    if (now() == Runs::kOpen) return;
    names_.forget_words(rest);
    names_.forget_words(lines_[index_].text);
    for (std::size_t i = index_ + 1; i < lines_.size() && lines_[i].indent > indent; ++i) {
      names_.forget_words(lines_[i].text);
    }
  }

  /// Forgets the names in a text, whether they have a number or not.
  void forget_named(std::string_view text, const std::string& why) {
    for_each_word(text, [&](std::string_view name) { names_.forget(std::string(name), why); });
  }

  static Runs joined(Runs outer, Runs inner) {
    if (outer == Runs::kNo || inner == Runs::kNo) return Runs::kNo;
    return outer == Runs::kOpen ? outer : inner;
  }

  /// Tells whether a branch is run; `before`: whether one above it is.
  Runs branch(std::string_view word, std::string_view condition, Runs& before) const {
    if (before == Runs::kYes) return Runs::kNo;
    Runs own = Runs::kYes;
    const bool is_main = condition.starts_with("__name__") && condition.ends_with("\"__main__\"") &&
                         condition.find_first_of("!&|") == condition.npos &&
                         std::count(condition.begin(), condition.end(), '=') == 2 &&
                         !mentions(condition, "and") && !mentions(condition, "or");
    if (word != "else" && !is_main) {
      const auto value = value_of(condition);
      own = !value ? Runs::kOpen : value->value != 0.0 ? Runs::kYes : Runs::kNo;
    }
    if (own == Runs::kNo) return own;
    const Runs runs = before == Runs::kOpen ? Runs::kOpen : own;
    before = own == Runs::kYes ? Runs::kYes : Runs::kOpen;
    return runs;
  }

  void warn(std::string_view where, std::string message) {
    out_.warning(script_.texts.name(where), script_.texts.position(where), {}, std::move(message));
  }

  /// Tells of friction models in a statement that is not followed.
  void tell(std::string_view text, std::string_view where) {
    if (!mentions(text, "frictionModel")) return;
    warn(where, "frictionModel in a way that is not followed here: its models are not read");
  }

  /// Forgets what an expression may set beside its value.
  void settle(std::string_view text) {
    constexpr std::array<std::string_view, 12> kAny{
        "exec",    "eval",     "globals", "locals",   "vars",      "setattr",
        "delattr", "__dict__", "global",  "nonlocal", "importlib", "__import__"};
    const std::string code = without_strings(text);
    bool any = false;
    for_each_word(code, [&](std::string_view word) {
      any = any || own_.contains(word) || is_in(kAny, word);
    });
    if (any || (reaches_ && calls_unknown(code))) {
      names_.forget_all();
    }
    if (text.find(":=") != text.npos) forget_targets(text);
  }

  /// Forgets the names before each ':='.
  void forget_targets(std::string_view text) {
    for (std::size_t at = text.find(":="); at != text.npos; at = text.find(":=", at + 2)) {
      const std::string_view before = without_blanks(text.substr(0, at));
      std::size_t begin = before.size();
      while (begin > 0 && is_in_name(before[begin - 1])) --begin;
      names_.forget(std::string(before.substr(begin)), kNotFollowed);
    }
  }

  /// Tells whether a text calls a function that is none of Python, math or OpenSees.
  static bool calls_unknown(std::string_view code) {
    for (std::size_t at = code.find('('); at != code.npos; at = code.find('(', at + 1)) {
      const std::string_view before = without_blanks(code.substr(0, at));
      std::size_t begin = before.size();
      while (begin > 0 && is_in_name(before[begin - 1])) --begin;
      const std::string_view name = before.substr(begin);
      const bool other = !before.empty() && (before.back() == ')' || before.back() == ']');
      if (other || (!name.empty() && !sets_nothing(name))) return true;
    }
    return false;
  }

  /// The first '=' that sets a name.
  static std::size_t find_equals(std::string_view text) {
    std::size_t found = text.npos;
    for_each_outside(text, [&](std::size_t i, int depth) {
      const bool single = text[i] == '=' && i > 0 && !text.substr(i + 1).starts_with('=') &&
                          std::string_view("=!:").find(text[i - 1]) == std::string_view::npos;
      const bool compares = i > 0 && (text[i - 1] == '<' || text[i - 1] == '>') &&
                            (i < 2 || text[i - 2] != text[i - 1]);
      if (depth <= 0 && single && !compares) found = i;
      return found == text.npos;
    });
    return found;
  }

  void take(std::string_view text, std::string_view where) {
    const std::size_t end = std::min(text.find_first_of(" ([{.\",;=*"), text.size());
    const std::string_view word = text.substr(0, end);
    if (word == "import" || word == "from") {
      take_import(text, where);
      return;
    }
    if (is_call(text)) {
      settle(text);
      record(text, where);
      return;
    }
    settle(text);
    const std::size_t equals = find_equals(text);
    if (equals != text.npos) {
      take_assignment(text, equals, where);
      return;
    }
    // A text that stands alone is a comment.
    if (without_blanks(without_strings(text)).size() <= 1 && text.ends_with('"')) return;
    constexpr std::array<std::string_view, 7> kPlain{"pass",  "break",  "continue", "return",
                                                     "yield", "assert", "raise"};
    constexpr std::array<std::string_view, 3> kEnds{"exit", "quit", "sys.exit"};
    const std::string_view callee = without_blanks(text.substr(0, text.find('(')));
    if (is_in(kEnds, callee) && text.ends_with(')')) {
      if (now() == Runs::kYes && !in_function()) end_behind(where);
      return;
    }
    const std::string_view name = callee.substr(callee.rfind('.') + 1);
    if (word == "print") return;
    tell(text, where);
    if (word == "del") {
      forget_named(text, kNotFollowed);
    } else if (!is_in(kPlain, word) && !(sets_nothing(name) && !calls_unknown(text))) {
      names_.forget_words(text);
    }
  }

  bool in_function() const {
    return std::any_of(blocks_.begin(), blocks_.end(),
                       [](const Block& one) { return one.is_function; });
  }

  /// Ends the script, and tells of models that stand behind the end.
  void end_behind(std::string_view where) {
    ended_ = true;
    for (std::size_t i = index_ + 1; i < lines_.size(); ++i) {
      if (!mentions(lines_[i].text, "frictionModel")) continue;
      warn(where, "the script ends here: what stands below is not read");
      return;
    }
  }

  /// Forgets the names that an import sets, unless it is one of math, numpy or OpenSees.
  void take_import(std::string_view text, std::string_view where) {
    std::string_view rest =
        without_blanks(text.substr(std::min(text.find_first_of(" ("), text.size())));
    if (text.starts_with("from")) {
      const std::string_view module = rest.substr(0, rest.find(' '));
      const bool mathematics = module == "math" || module == "numpy";
      const bool opensees = module.starts_with("openseespy");
      const std::size_t at = rest.find(" import");
      const std::string_view names = at == rest.npos ? rest : rest.substr(at + 7);
      const bool renamed = mentions(names, "as");
      if (mathematics && !renamed) {
        if (names.find('*') != names.npos) names_.forget_all();
        names_.forget_words(names);
        if (mentions(names, "pi") || names.find('*') != names.npos) {
          names_.assign("pi", base::format_number(std::numbers::pi), kPython);
          if (now() == Runs::kOpen) names_.forget("pi", kNotFollowed);
        }
        return;
      }
      if (opensees && !renamed) {
        names_.forget_all();
        return;
      }
      names_.forget_all();
      if (names.find('*') != names.npos) functions_open_ = true;
      forget_named(names, "is imported: write its number");
      tell(names, where);
      return;
    }
    for (const std::string_view one : split(rest, ',')) {
      const std::size_t as = one.find(" as ");
      const std::string_view module = one.substr(0, one.find(' '));
      const std::string_view name =
          as == one.npos ? module.substr(0, module.find('.')) : without_blanks(one.substr(as + 4));
      const bool known = (module == "math" && name == "math") ||
                         (module == "numpy" && (name == "np" || name == "numpy"));
      if (!known) names_.forget(std::string(name), "is a module");
    }
  }

  void take_assignment(std::string_view text, std::size_t equals, std::string_view where) {
    tell(text, where);
    std::string_view left = text.substr(0, equals);
    std::string_view value = without_blanks(text.substr(equals + 1));
    // `mu += 0.1`, `mu **= 2`: the marks of an operator before '='.
    const std::size_t mark = left.find_last_not_of("+-*/%&|^@<>");
    const std::string_view operation = left.substr(std::min(mark + 1, left.size()));
    left = without_blanks(left.substr(0, mark + 1));
    if (!operation.empty()) {
      if (is_name(left)) {
        assign(std::string(left), fmt::format("{} {} ({})", left, operation, value));
      } else {
        forget_named(left, kNotFollowed);
      }
      return;
    }
    std::vector<std::string_view> targets{left};
    for (std::size_t next = find_equals(value); next != value.npos; next = find_equals(value)) {
      targets.push_back(without_blanks(value.substr(0, next)));
      value = without_blanks(value.substr(next + 1));
    }
    if (targets.size() == 1 && take_pairs(left, value)) return;
    // All take the value that it has before any of them is set.
    const auto number = value_of(value);
    const std::string word = number ? base::format_number(number->value) : std::string(value);
    for (const std::string_view target : targets) {
      const std::string_view name = without_blanks(target.substr(0, find_outside(target, ':')));
      if (is_name(name)) {
        assign(std::string(name), word);
        if (mentions(text, "lambda")) own_.emplace(name);
      } else {
        forget_named(target, kNotFollowed);
      }
    }
  }

  /// Takes `mu, k = 0.1, 2`, with as many names as numbers.
  bool take_pairs(std::string_view left, std::string_view value) {
    const std::vector<std::string_view> names = split(left, ',');
    const std::vector<std::string_view> values = split(value, ',');
    if (names.size() < 2 || names.size() != values.size() ||
        !std::all_of(names.begin(), names.end(), is_name)) {
      return false;
    }
    std::vector<std::string> numbers;
    for (const std::string_view one : values) {
      // All are evaluated before any is set.
      const auto number = value_of(one);
      numbers.push_back(number ? base::format_number(number->value)
                               : fmt::format("\"{}\"", without_strings(one)));
    }
    for (std::size_t i = 0; i < names.size(); ++i) assign(std::string(names[i]), numbers[i]);
    return true;
  }

  tl::expected<import::ScriptNumber, std::string> value_of(std::string_view text) const {
    if (functions_open_ && text.find('(') != text.npos) {
      return tl::unexpected(fmt::format("'{}': its functions may be imported: write its number",
                                        base::shortened(text, 60)));
    }
    return names_.value_of(text, kPython);
  }

  void assign(const std::string& name, const std::string& value) {
    if (now() == Runs::kOpen) {
      names_.forget(name, "is set in a block that may not be run");
    } else if (functions_open_ && value.find('(') != value.npos) {
      names_.forget(name, kNotFollowed);
    } else {
      names_.assign(name, value, kPython);
    }
  }

  /// Returns whether a statement is a call of frictionModel or element, and nothing else.
  bool is_call(std::string_view text) const {
    const std::size_t begin = text.find('(');
    if (begin == text.npos || !text.ends_with(')')) return false;
    std::string_view callee = without_blanks(text.substr(0, begin));
    for (const char c : callee) {
      if (!is_in_name(c) && c != '.' && c != ' ') return false;
    }
    callee = without_blanks(callee.substr(callee.rfind('.') + 1));
    if (!is_wanted(callee) || own_.contains(callee)) return false;
    // The parenthesis that closes the first one ends the statement.
    std::size_t end = text.npos;
    for_each_outside(text, [&](std::size_t i, int depth) {
      if (i > begin && depth == 0 && text[i] == ')') end = i;
      return end == text.npos;
    });
    return end == text.size() - 1;
  }

  void record(std::string_view text, std::string_view where) {
    const std::size_t begin = text.find('(');
    std::string_view name = without_blanks(text.substr(0, begin));
    name = without_blanks(name.substr(name.rfind('.') + 1));
    ScriptCommand command{.words = {std::string(name)}, .where = where};
    for (const std::string_view one : split(text.substr(begin + 1, text.size() - begin - 2), ',')) {
      const bool quoted = one.size() >= 2 && one.front() == '"' && one.back() == '"';
      std::string word(quoted ? one.substr(1, one.size() - 2) : one);
      if (!quoted) {
        const auto value = value_of(one);
        if (value) {
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
  base::Diagnostics& out_;
  std::vector<Line> lines_;
  std::size_t index_ = 0;                   ///< of the line that is read
  std::set<std::string, std::less<>> own_;  ///< functions and classes of the script
  bool reaches_ = false;                    ///< a function may set a name outside of it
  bool functions_open_ = false;             ///< functions may be imported under any name
  bool ended_ = false;
  ScriptNames names_;
  std::vector<Block> blocks_;
  std::map<std::size_t, Runs> branches_;  ///< by indent: whether one of an if was run
};

}  // namespace

void read_python(Script& script, base::Diagnostics& out) { PythonReader(script, out).read(); }

}  // namespace slipbench::driver::opensees
