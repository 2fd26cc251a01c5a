// SPDX-License-Identifier: Apache-2.0
#include "driver/base/units/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cassert>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "driver/base/text/letters.hpp"
#include "driver/base/text/utf8.hpp"

namespace slipbench::driver::base {
namespace {

bool begins_name(char c) { return is_letter(c) || c == '_'; }
bool is_name_char(char c) { return begins_name(c) || is_digit(c); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

int to_offset(std::size_t position) { return static_cast<int>(position); }

tl::unexpected<ExpressionError> failure(std::string message, std::size_t position,
                                        std::string unknown_name = {}) {
  return tl::unexpected(
      ExpressionError{std::move(message), to_offset(position), std::move(unknown_name)});
}

/// muParser's own number reader goes through a string stream and turns 1e-400 into 0 without a
/// word; this one is called before it.
int read_number(const char* text, int* position, double* value) {
  if (!is_digit(*text) && *text != '.') return 0;
  // No further than the number may go: a formula is mostly numbers.
  const char* end = text;
  while (is_name_char(*end) || *end == '.' ||
         ((*end == '+' || *end == '-') && (end[-1] == 'e' || end[-1] == 'E'))) {
    ++end;
  }
  const auto [stop, error] = std::from_chars(text, end, *value);
  if (error != std::errc{}) return 0;
  *position += static_cast<int>(stop - text);
  return 1;
}

/// A name in the text, and what follows it.
struct Mention {
  std::string name;
  std::size_t offset = 0;
  bool is_call = false;
};

/// End of the number that starts at `begin`; an error for what a case file does not accept.
tl::expected<std::size_t, ExpressionError> scan_number(std::string_view text, std::size_t begin) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + text.size(), value);
  std::size_t end = static_cast<std::size_t>(stop - text.data());
  const bool out_of_range = error == std::errc::result_out_of_range;
  const bool octal = text[begin] == '0' && begin + 1 < text.size() && is_digit(text[begin + 1]);
  const bool runs_on = end < text.size() && (is_name_char(text[end]) || text[end] == '.');
  if (error == std::errc{} && !octal && !runs_on) return end;
  while (end < text.size() && (is_name_char(text[end]) || text[end] == '.')) ++end;
  const std::string_view word = text.substr(begin, std::max(end, begin + 1) - begin);
  if (out_of_range) {
    return failure(fmt::format("the number {} is outside the range of a double", word), begin);
  }
  return failure(fmt::format("'{}' is not a number", word), begin);
}

/// Fault of a character that is not printable ASCII.
std::string odd_character(std::string_view rest) {
  const CodePoint point = decode_utf8(rest);
  const std::string shown =
      point.valid && point.value >= 0xA0
          ? fmt::format("'{}' (U+{:04X})", rest.substr(0, point.length), point.value)
          : fmt::format("the byte 0x{:02X}", static_cast<unsigned char>(rest[0]));
  return fmt::format("{}: an expression is written in printable ASCII characters", shown);
}

/// Reads the text once for what muParser would accept and a case must not contain, and for the
/// names in it. (muParser would also stop at the first NUL.)
tl::expected<std::vector<Mention>, ExpressionError> scan(std::string_view text) {
  std::vector<Mention> mentions;
  std::vector<bool> call_parentheses;
  bool after_function = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (is_blank(c)) {
      ++i;
      continue;
    }
    const bool opens_call = std::exchange(after_function, false);
    if (begins_name(c)) {
      std::size_t end = i + 1;
      while (end < text.size() && (is_name_char(text[end]) || text[end] == '.')) ++end;
      std::size_t next = end;
      while (next < text.size() && is_blank(text[next])) ++next;
      after_function = next < text.size() && text[next] == '(';
      mentions.push_back({std::string(text.substr(i, end - i)), i, after_function});
      i = end;
    } else if (is_digit(c) || (c == '.' && i + 1 < text.size() && is_digit(text[i + 1]))) {
      const auto end = scan_number(text, i);
      if (!end) return tl::unexpected(end.error());
      i = *end;
    } else if (c == '=' || c == '<' || c == '>' || c == '!') {
      const bool comparison = i + 1 < text.size() && text[i + 1] == '=';
      if (c == '=' && !comparison) {
        return failure("an expression cannot assign with '=' (a comparison is written '==')", i);
      }
      i += comparison ? 2 : 1;
    } else if (text.substr(i, 2) == "**") {
      return failure("a power is written '^', not '**'", i);
    } else if (c == '"' || c == '\'') {
      return failure("an expression has no strings", i);
    } else if (c == '(') {
      call_parentheses.push_back(opens_call);
      ++i;
    } else if (c == ')') {
      if (!call_parentheses.empty()) call_parentheses.pop_back();
      ++i;
    } else if (c == ',') {
      if (call_parentheses.empty() || !call_parentheses.back()) {
        return failure("',' only separates the arguments of a function (the decimal mark is '.')",
                       i);
      }
      ++i;
    } else if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) {
      return failure(odd_character(text.substr(i)), i);
    } else {
      ++i;
    }
  }
  return mentions;
}

/// Finds names in a list.
class NameSearch {
 public:
  NameSearch(std::span<const std::string> names, std::size_t searches) : names_(names) {
    // To put a name into a map takes as long as to compare it some thirty times.
    constexpr std::size_t kFewSearches = 30;
    if (searches <= kFewSearches) return;
    for (std::size_t i = 0; i < names.size(); ++i) by_name_.try_emplace(names[i], i);
  }

  std::optional<std::size_t> find(std::string_view name) const {
    if (!by_name_.empty()) {
      const auto it = by_name_.find(name);
      return it == by_name_.end() ? std::nullopt : std::optional(it->second);
    }
    const auto it = std::find(names_.begin(), names_.end(), name);
    if (it == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(it - names_.begin());
  }

 private:
  std::span<const std::string> names_;
  std::unordered_map<std::string_view, std::size_t> by_name_;
};

std::string syntax_message(const mu::ParserError& error) {
  const std::string& token = error.GetToken();
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
      return "the expression ends too early";
    case mu::ecMISSING_PARENS:
      return "a ')' is missing";
    case mu::ecUNEXPECTED_PARENS:
      return fmt::format("unexpected '{}'", token);
    case mu::ecEXPRESSION_TOO_LONG:
      return fmt::format("the expression is longer than {} characters", kLongestFormula);
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("too few arguments for the function {}", token);
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("too many arguments for the function {}", token);
    case mu::ecUNEXPECTED_OPERATOR:
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      return fmt::format("unexpected '{}'", token);
    default:
      break;
  }
  std::string message = error.GetMsg();
  while (!message.empty() && message.back() == '.') message.pop_back();
  return message;
}

/// Makes muParser read a name, once in all. Its own number reader tries each, in a stream, and
/// libstdc++ notes what the stream's locale says of numbers at the first use: other threads must
/// not come upon that while it is written.
void look_up_locale_once() {
  [[maybe_unused]] static const double kRead = [] {
    double x = 0.0;
    mu::Parser parser;
    parser.DefineVar("x", &x);
    parser.SetExpr("x");
    return parser.Eval();
  }();
}

}  // namespace

/// Needs of a copy to compile again, the compiled formula and the numbers it reads. muParser
/// holds pointers into `numbers`, so a program never moves.
struct Expression::Program {
  struct Slot {
    std::string name;
    std::size_t variable = 0;  ///< Index into the values of an evaluation.
    bool is_variable = false;
  };

  std::string text;
  std::size_t formula_begin = 0;  ///< Where the formula starts in `text`, behind the '='.
  std::vector<Slot> slots;
  std::vector<double> numbers;  ///< One per slot.
  std::vector<std::string> used;
  std::size_t variable_count = 0;
  mu::Parser parser;

  Program() = default;
  Program(const Program& other)
      : text(other.text),
        formula_begin(other.formula_begin),
        slots(other.slots),
        numbers(other.numbers),
        used(other.used),
        variable_count(other.variable_count) {
    load();
  }
  Program& operator=(const Program&) = delete;

  /// Hands the text and the slots to muParser. Throws mu::ParserError.
  void load() {
    // Folding constants would hide a division by zero among them from the evaluation; it gains
    // nothing measurable for formulas of a case's size.
    parser.EnableOptimizer(false);
    parser.AddValIdent(read_number);
    parser.ClearConst();
    const std::string name_characters = std::string(parser.ValidNameChars()) + '.';
    parser.DefineNameChars(name_characters.c_str());
    // With letters among them, as by default, '+t+t+t' is one run that is looked through again for
    // each of its operators. All that a formula may have are built in.
    parser.DefineOprtChars("+-");
    parser.DefineInfixOprtChars("+-");
    for (std::size_t i = 0; i < slots.size(); ++i) parser.DefineVar(slots[i].name, &numbers[i]);
    parser.SetExpr(text.substr(formula_begin));
  }
};

Expression::Expression(std::unique_ptr<Program> program) : program_(std::move(program)) {}
Expression::Expression(const Expression& other)
    : program_(std::make_unique<Program>(*other.program_)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(const Expression& other) {
  if (this != &other) program_ = std::make_unique<Program>(*other.program_);
  return *this;
}
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

tl::expected<Expression, ExpressionError> Expression::compile(
    std::string_view text, std::span<const std::string> variables, const NamedNumbers& constants) {
  auto program = std::make_unique<Program>();
  program->text = text;
  program->variable_count = variables.size();

  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  if (begin < text.size() && text[begin] == '=') ++begin;
  program->formula_begin = begin;
  if (std::all_of(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), is_blank)) {
    return failure("the expression is empty", begin);
  }

  auto mentions = scan(text.substr(begin));
  if (!mentions) {
    mentions.error().offset += to_offset(begin);
    return tl::unexpected(mentions.error());
  }
  std::unordered_set<std::string_view> seen;
  const NameSearch search(variables, mentions->size());
  for (const Mention& mention : *mentions) {
    const std::size_t offset = begin + mention.offset;
    const bool is_function =
        std::binary_search(function_names().begin(), function_names().end(), mention.name);
    if (is_function && mention.is_call) continue;
    if (!seen.insert(mention.name).second) continue;

    Program::Slot slot{mention.name, 0, false};
    double number = 0.0;
    if (const auto place = search.find(mention.name)) {
      slot.is_variable = true;
      slot.variable = *place;
      program->used.push_back(mention.name);
    } else if (const auto constant = constants.find(mention.name); constant != constants.end()) {
      number = constant->second;
    } else if (mention.name == "pi" || mention.name == "_pi") {
      number = std::numbers::pi;
    } else if (mention.name == "_e") {
      number = std::numbers::e;
    } else if (is_function) {
      return failure(fmt::format("{0} is a function: write {0}(...)", mention.name), offset);
    } else {
      return failure(
          fmt::format("unknown {} '{}'", mention.is_call ? "function" : "name", mention.name),
          offset, mention.name);
    }
    program->slots.push_back(std::move(slot));
    program->numbers.push_back(number);
  }

  look_up_locale_once();
  try {
    program->load();
    // muParser parses at the first evaluation; do it now, for the errors' sake.
    program->parser.Eval();
    if (program->parser.GetNumResults() != 1) return failure("more than one result", begin);
  } catch (const mu::ParserError& error) {
    const int position = error.GetPos();
    const std::size_t offset =
        position < 0 ? begin : std::min(begin + static_cast<std::size_t>(position), text.size());
    return failure(syntax_message(error), offset);
  }
  return Expression(std::move(program));
}

tl::expected<double, ExpressionError> Expression::operator()(std::span<const double> values) const {
  Program& program = *program_;
  assert(values.size() == program.variable_count);
  for (std::size_t i = 0; i < program.slots.size(); ++i) {
    if (program.slots[i].is_variable) program.numbers[i] = values[program.slots[i].variable];
  }
  // The processor's flags also see the division by zero of 1/(1 + 1/x) at x = 0, whose result is
  // finite. Testing is much cheaper than clearing.
  constexpr int kFaults = FE_DIVBYZERO | FE_INVALID;
  if (std::fetestexcept(kFaults) != 0) std::feclearexcept(kFaults);
  double result = 0.0;
  try {
    result = program.parser.Eval();
  } catch (const mu::ParserError& error) {
    return tl::unexpected(ExpressionError{syntax_message(error), -1, {}});
  }
  const int faults = std::fetestexcept(kFaults);
  if (faults == 0 && std::isfinite(result)) return result;

  std::string where;
  for (std::size_t i = 0; i < program.slots.size(); ++i) {
    if (!program.slots[i].is_variable) continue;
    where += fmt::format("{}{} = {}", where.empty() ? " at " : ", ", program.slots[i].name,
                         program.numbers[i]);
  }
  const std::string_view formula = std::string_view(program.text).substr(program.formula_begin);
  const std::size_t first = formula.find_first_not_of(" \t\r\n");
  const std::size_t last = formula.find_last_not_of(" \t\r\n");
  std::string_view reason = "exceeds the range of a double";
  if ((faults & FE_INVALID) != 0 || std::isnan(result)) {
    reason = "is not defined (0/0, or a root or logarithm of a negative number)";
  }
  if ((faults & FE_DIVBYZERO) != 0) {
    // The logarithm of 0 raises the same flag.
    const bool divides = formula.find_first_of("/^") != std::string_view::npos;
    reason = divides ? "divides by zero" : "is infinite (the logarithm of 0?)";
  }
  return tl::unexpected(ExpressionError{
      fmt::format("{} {}{}", formula.substr(first, last - first + 1), reason, where), -1, {}});
}

bool Expression::uses(std::string_view name) const {
  return std::find(program_->used.begin(), program_->used.end(), name) != program_->used.end();
}

std::span<const std::string> Expression::used_variables() const { return program_->used; }

const std::string& Expression::text() const { return program_->text; }

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    const mu::Parser parser;
    for (const auto& entry : parser.GetFunDef()) result.push_back(entry.first);
    return result;
  }();
  return names;
}

bool is_identifier(std::string_view name) {
  return !name.empty() && begins_name(name.front()) &&
         std::all_of(name.begin(), name.end(), is_name_char);
}

bool is_reserved_name(std::string_view name) {
  return name == "pi" || name == "_pi" || name == "_e" || name == "t" || name == "T" ||
         std::binary_search(function_names().begin(), function_names().end(), name);
}

}  // namespace slipbench::driver::base
