// SPDX-License-Identifier: Apache-2.0
#include "driver/import/script_formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/expression.hpp"

namespace slipbench::driver::import {
namespace {

constexpr int kDeepest = 200;
constexpr double kMostWhole = 9007199254740991.0;  ///< 2^53 - 1: a double has all integers up to it
constexpr double kMostWholeFortran = 2147483647.0;  ///< of four bytes

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool begins_name(char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0; }

using OneArgument = double (*)(double);

double absolute(double x) { return std::abs(x); }

constexpr std::array<std::pair<std::string_view, OneArgument>, 17> kFunctions{{
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"fabs", absolute},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
}};

/// Reads a formula from left to right, by descent into what binds more strongly.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const ScriptNumbers& numbers, FormulaLanguage language)
      : text_(text), numbers_(numbers), language_(language) {}

  tl::expected<ScriptNumber, FormulaFault> read() {
    const ScriptNumber value = choice();
    skip_blanks();
    if (sound_ && at_ < text_.size()) {
      fail(fmt::format("'{}' is not understood", base::printable(text_.substr(at_, 1))));
    }
    if (sound_ && !std::isfinite(value.value)) fail("the result is no number");
    if (!sound_) return tl::unexpected(std::move(fault_));
    return value;
  }

 private:
  void fail(std::string message, std::string unknown = {}) {
    if (!sound_) return;
    sound_ = false;
    fault_ = {std::move(message), at_, std::move(unknown)};
    at_ = text_.size();
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  /// Takes a mark that is not the beginning of a longer one.
  bool take(std::string_view mark, std::string_view not_before = {}) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(mark)) return false;
    const std::size_t end = at_ + mark.size();
    if (end < text_.size() && not_before.find(text_[end]) != not_before.npos) return false;
    at_ = end;
    return true;
  }

  /// Refuses an integer that the program may have otherwise.
  ScriptNumber exact(const ScriptNumber& value) {
    if (!std::isfinite(value.value)) fail("the result is no number");
    const double most = language_ == FormulaLanguage::kFortran ? kMostWholeFortran : kMostWhole;
    if (value.whole && !(std::abs(value.value) <= most)) {
      fail("this integer is too large to be sure of: write it with a decimal point");
    }
    return value;
  }

  ScriptNumber choice() {
    if (++depth_ > kDeepest) fail("is nested too deeply");
    ScriptNumber value = any();
    if (sound_ && language_ != FormulaLanguage::kPython && take("?")) {
      const ScriptNumber yes = choice();
      if (!take(":")) fail("wanted ':'");
      const ScriptNumber no = choice();
      value = value.value != 0.0 ? yes : no;
    }
    --depth_;
    return value;
  }

  static ScriptNumber truth(bool is) { return {is ? 1.0 : 0.0, true}; }

  ScriptNumber any() {
    ScriptNumber value = all();
    while (sound_ && language_ != FormulaLanguage::kPython && take("||")) {
      const ScriptNumber other = all();
      value = truth(value.value != 0.0 || other.value != 0.0);
    }
    return value;
  }

  ScriptNumber all() {
    ScriptNumber value = compared();
    while (sound_ && language_ != FormulaLanguage::kPython && take("&&")) {
      const ScriptNumber other = compared();
      value = truth(value.value != 0.0 && other.value != 0.0);
    }
    return value;
  }

  ScriptNumber compared() {
    ScriptNumber value = sum();
    // The languages differ on 1 < 2 < 3, and on whether == binds less than <.
    for (int count = 0; sound_; ++count) {
      const std::size_t before = at_;
      if (take("==")) {
        value = truth(value.value == sum().value);
      } else if (take("!=")) {
        value = truth(value.value != sum().value);
      } else if (take("<=")) {
        value = truth(value.value <= sum().value);
      } else if (take(">=")) {
        value = truth(value.value >= sum().value);
      } else if (take("<")) {
        value = truth(value.value < sum().value);
      } else if (take(">")) {
        value = truth(value.value > sum().value);
      } else {
        break;
      }
      if (count > 0) {
        at_ = before;
        fail("compares more than two numbers: write parentheses");
      }
    }
    return value;
  }

  ScriptNumber sum() {
    ScriptNumber value = product();
    while (sound_) {
      const bool plus = take("+");
      if (!plus && !take("-")) break;
      const ScriptNumber other = product();
      value = exact({plus ? value.value + other.value : value.value - other.value,
                     value.whole && other.whole});
    }
    return value;
  }

  ScriptNumber product() {
    ScriptNumber value = sign();
    while (sound_) {
      if (take("*", "*")) {
        const ScriptNumber other = sign();
        value = exact({value.value * other.value, value.whole && other.whole});
      } else if (language_ == FormulaLanguage::kPython && take("//")) {
        value = divided(value, sign(), true);
      } else if (take("/", "/")) {
        value = divided(value, sign(), false);
      } else if (take("%")) {
        const ScriptNumber other = sign();
        if (language_ != FormulaLanguage::kPython && !(value.whole && other.whole)) {
          fail("'%' takes whole numbers");
        }
        const double whole = divided(value, other, true).value;
        value = {value.value - whole * other.value, value.whole && other.whole};
      } else {
        break;
      }
    }
    return value;
  }

  ScriptNumber divided(const ScriptNumber& a, const ScriptNumber& b, bool floor) {
    if (b.value == 0.0) {
      fail("division by zero");
      return {};
    }
    const double ratio = a.value / b.value;
    const bool whole = a.whole && b.whole;
    if (floor) return {std::floor(ratio), whole};
    if (!whole || language_ == FormulaLanguage::kPython) return {ratio, false};
    return {language_ == FormulaLanguage::kTcl ? std::floor(ratio) : std::trunc(ratio), true};
  }

  /// A sign binds less than ** does, but in Tcl more.
  ScriptNumber sign() {
    const bool tight = language_ == FormulaLanguage::kTcl;
    const ScriptNumber value = signed_number(tight);
    return tight ? power(value) : value;
  }

  ScriptNumber signed_number(bool tight) {
    if (++depth_ > kDeepest) fail("is nested too deeply");
    ScriptNumber value;
    if (take("-")) {
      value = signed_number(tight);
      value.value = -value.value;
    } else if (take("+")) {
      value = signed_number(tight);
    } else if (language_ != FormulaLanguage::kPython && take("!", "=")) {
      value = truth(signed_number(tight).value == 0.0);
    } else if (sound_) {
      value = tight ? atom() : power(atom());
    }
    --depth_;
    return value;
  }

  ScriptNumber power(const ScriptNumber& base) {
    if (!sound_ || !take("**")) return base;
    if (++depth_ > kDeepest) fail("is nested too deeply");
    const ScriptNumber exponent = sign();
    --depth_;
    return raised(base, exponent);
  }

  ScriptNumber raised(const ScriptNumber& base, const ScriptNumber& exponent) {
    const double value = std::pow(base.value, exponent.value);
    const bool whole = base.whole && exponent.whole;
    if (!whole || exponent.value >= 0.0) return exact({value, whole});
    if (base.value == 0.0) fail("division by zero");
    // Integers stay integers: 2**-1 is cut off to 0.
    if (language_ == FormulaLanguage::kPython) return {value, false};
    return {std::trunc(value), true};
  }

  ScriptNumber atom() {
    skip_blanks();
    if (take("(")) {
      const ScriptNumber value = choice();
      if (!take(")")) fail("wanted ')'");
      return value;
    }
    if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) return literal();
    const bool dollar = take("$");
    if (dollar) take("::");
    if (at_ < text_.size() && begins_name(text_[at_])) return named(dollar);
    fail(at_ < text_.size()
             ? fmt::format("wanted a number, found '{}'", base::printable(text_.substr(at_, 1)))
             : "a number is missing");
    return {};
  }

  ScriptNumber literal() {
    double value = 0.0;
    const std::string_view rest = text_.substr(at_);
    std::size_t end = std::min(rest.find_first_not_of("0123456789."), rest.size());
    std::string copy(rest.substr(0, end));
    // Fortran writes the exponent of a double with a D.
    const bool fortran = language_ == FormulaLanguage::kFortran;
    if (end < rest.size() &&
        std::string_view(fortran ? "eEdD" : "eE").find(rest[end]) != rest.npos) {
      copy += 'e';
      ++end;
      if (end < rest.size() && (rest[end] == '+' || rest[end] == '-')) copy += rest[end++];
      while (end < rest.size() && is_digit(rest[end])) copy += rest[end++];
    }
    const auto read = std::from_chars(copy.data(), copy.data() + copy.size(), value);
    if (read.ec != std::errc{}) {
      fail("is no number");
      return {};
    }
    const auto length = static_cast<std::size_t>(read.ptr - copy.data());
    const bool whole = is_whole_literal(rest.substr(0, length));
    if (whole && length > 1 && rest.front() == '0' && language_ != FormulaLanguage::kFortran) {
      fail("an integer that begins with 0 is octal in Tcl 8: write it without the 0");
      return {};
    }
    at_ += length;
    return exact({value, whole});
  }

  ScriptNumber named(bool dollar) {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (begins_name(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.')) {
      ++at_;
    }
    const std::string_view whole = text_.substr(begin, at_ - begin);
    const std::string_view name = whole.substr(whole.rfind('.') + 1);
    skip_blanks();
    if (!dollar && at_ < text_.size() && text_[at_] == '(') {
      const bool own = name.size() == whole.size();
      const bool python = language_ == FormulaLanguage::kPython;
      return called(own || (python && is_mathematics(whole)) ? name : whole, begin);
    }
    const bool tcl = language_ == FormulaLanguage::kTcl;
    // A word without '$' is no variable of Tcl.
    if (const auto found = numbers_.find(whole); found != numbers_.end() && (dollar || !tcl)) {
      return found->second;
    }
    const bool python = language_ == FormulaLanguage::kPython;
    if (name == "pi" && (python ? is_mathematics(whole) : !tcl && !dollar)) {
      return {std::numbers::pi, false};
    }
    if (!dollar && whole == (python ? "True" : "true")) return truth(true);
    if (!dollar && whole == (python ? "False" : "false")) return truth(false);
    at_ = begin;
    fail(fmt::format("unknown name '{}'", base::shortened(whole, 60)), std::string(whole));
    return {};
  }

  /// Returns whether a name with a module is one of math or numpy.
  static bool is_mathematics(std::string_view whole) {
    const std::string_view module = whole.substr(0, std::min(whole.find('.'), whole.size()));
    return module.size() < whole.size() && whole.find('.', module.size() + 1) == whole.npos &&
           (module == "math" || module == "np" || module == "numpy");
  }

  /// Returns whether the language has a function of this name.
  bool has_function(std::string_view name) const {
    constexpr std::array<std::string_view, 4> kFortranOnly{"ln", "nint", "dble", "mod"};
    constexpr std::array<std::string_view, 3> kTclOnly{"wide", "entier", "double"};
    const auto in = [&](const auto& list) {
      return std::find(list.begin(), list.end(), name) != list.end();
    };
    if (language_ == FormulaLanguage::kTcl)
      return !in(kFortranOnly) && name != "fabs" && name != "float";
    if (language_ == FormulaLanguage::kPython) return !in(kFortranOnly) && !in(kTclOnly);
    return true;
  }

  /// Refuses integers as arguments of functions whose result in Fortran may be one or not.
  void refuse_whole(std::string_view name) {
    fail(fmt::format("whether '{}' of whole numbers is whole is not certain: write a decimal point",
                     name));
  }

  /// Applies a function; nothing if it is not known.
  std::optional<ScriptNumber> result(std::string_view name,
                                     const std::vector<ScriptNumber>& arguments) {
    const bool fortran = language_ == FormulaLanguage::kFortran;
    const double x = arguments.front().value;
    const auto whole_ones = std::count_if(arguments.begin(), arguments.end(),
                                          [](const auto& one) { return one.whole; });
    const bool all_whole = whole_ones == static_cast<std::ptrdiff_t>(arguments.size());
    if (arguments.size() == 1) {
      if (fortran && (name == "floor" || name == "ceil")) refuse_whole(name);
      for (const auto& [known, function] : kFunctions) {
        if (known == name) return ScriptNumber{function(x), false};
      }
      if (name == "abs") return ScriptNumber{std::abs(x), all_whole};
      if (name == "int" || name == "wide" || name == "entier") {
        return ScriptNumber{std::trunc(x), true};
      }
      if (name == "round" || name == "nint") {
        // Python rounds a half to the even neighbour, as nearbyint does.
        const bool even = language_ == FormulaLanguage::kPython;
        return ScriptNumber{even ? std::nearbyint(x) : std::round(x), true};
      }
      if (name == "double" || name == "float" || name == "dble") return ScriptNumber{x, false};
    }
    if (arguments.size() == 2) {
      const double y = arguments[1].value;
      if (name == "pow") {
        if (fortran && all_whole) refuse_whole(name);
        return ScriptNumber{std::pow(x, y), false};
      }
      if (name == "atan2") return ScriptNumber{std::atan2(x, y), false};
      if (name == "hypot") return ScriptNumber{std::hypot(x, y), false};
      if (name == "mod" && fortran) return ScriptNumber{std::fmod(x, y), all_whole};
      if (name == "fmod") {
        if (fortran && all_whole) refuse_whole(name);
        return ScriptNumber{std::fmod(x, y), false};
      }
    }
    if (name == "min" || name == "max") return chosen(name == "min", arguments, whole_ones);
    return std::nullopt;
  }

  /// Takes the least or largest argument, which keeps its type.
  ScriptNumber chosen(bool least, const std::vector<ScriptNumber>& arguments,
                      std::ptrdiff_t whole_ones) {
    const bool mixed =
        whole_ones != 0 && whole_ones != static_cast<std::ptrdiff_t>(arguments.size());
    if (mixed && language_ == FormulaLanguage::kFortran) refuse_whole(least ? "min" : "max");
    ScriptNumber value = arguments.front();
    for (const ScriptNumber& one : arguments) {
      if (least ? one.value < value.value : one.value > value.value) value = one;
    }
    // Which of two equal ones is taken is not the same in all versions.
    for (const ScriptNumber& one : arguments) {
      if (one.value == value.value && one.whole != value.whole &&
          language_ == FormulaLanguage::kTcl) {
        fail("whether the result is whole is not certain: write a decimal point");
      }
    }
    return value;
  }

  ScriptNumber called(std::string_view name, std::size_t begin) {
    take("(");
    std::vector<ScriptNumber> arguments;
    do {
      arguments.push_back(choice());
    } while (sound_ && take(","));
    if (!take(")")) fail("wanted ')'");
    if (!sound_) return {};
    if (has_function(name)) {
      if (const auto value = result(name, arguments)) return exact(*value);
    }
    at_ = begin;
    fail(fmt::format("there is no function '{}' of {} number{}", base::shortened(name, 60),
                     arguments.size(), arguments.size() == 1 ? "" : "s"),
         std::string(name));
    return {};
  }

  std::string_view text_;
  const ScriptNumbers& numbers_;
  FormulaLanguage language_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool sound_ = true;
  FormulaFault fault_;
};

}  // namespace

tl::expected<ScriptNumber, FormulaFault> evaluate_formula(std::string_view text,
                                                          const ScriptNumbers& numbers,
                                                          FormulaLanguage language) {
  if (text.size() > base::kLongestFormula) {
    return tl::unexpected(FormulaFault{
        fmt::format("the formula has more than {} characters", base::kLongestFormula), 0, {}});
  }
  return FormulaReader(text, numbers, language).read();
}

bool is_whole_literal(std::string_view text) {
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

}  // namespace slipbench::driver::import
