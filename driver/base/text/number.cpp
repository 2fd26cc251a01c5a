// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/number.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/letters.hpp"

namespace slipbench::driver::base {
namespace {

bool is_sign(char c) { return c == '+' || c == '-'; }

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

std::string_view without_sign(std::string_view text) {
  if (!text.empty() && is_sign(text.front())) text.remove_prefix(1);
  return text;
}

// Long texts would drown the message.
std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  return text.size() <= kLongest ? fmt::format("'{}'", text)
                                 : fmt::format("'{}...'", text.substr(0, kLongest));
}

std::size_t count_digits(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n])) ++n;
  return n;
}

// Returns how many characters at the front are a decimal number; 0 if there is none.
std::size_t number_prefix(std::string_view text) {
  std::size_t i = !text.empty() && is_sign(text.front()) ? 1 : 0;
  const std::size_t whole = count_digits(text.substr(i));
  i += whole;
  std::size_t fraction = 0;
  if (i < text.size() && text[i] == '.') {
    fraction = count_digits(text.substr(i + 1));
    if (whole + fraction > 0) i += 1 + fraction;
  }
  if (whole + fraction == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t j = i + 1;
    if (j < text.size() && is_sign(text[j])) ++j;
    const std::size_t exponent = count_digits(text.substr(j));
    if (exponent > 0) i = j + exponent;
  }
  return i;
}

bool is_number(std::string_view text) {
  return !text.empty() && number_prefix(text) == text.size();
}

bool has_leading_zero(std::string_view number) {
  const std::string_view digits = without_sign(number);
  return digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
}

std::string without_leading_zeros(std::string_view number) {
  const std::string_view unsigned_part = without_sign(number);
  std::string_view digits = unsigned_part;
  while (digits.size() > 1 && digits[0] == '0' && is_digit(digits[1])) digits.remove_prefix(1);
  return std::string(number.substr(0, number.size() - unsigned_part.size())) + std::string(digits);
}

// The digits that matter: of the mantissa, without zeros at either end.
std::string significant_digits(std::string_view number) {
  std::string digits;
  for (const char c : number) {
    if (c == 'e' || c == 'E') break;
    if (is_digit(c) && !(digits.empty() && c == '0')) digits += c;
  }
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return digits;
}

// A number whose magnitude is no double's: tells large from small by its decimal exponent.
bool is_too_small(std::string_view number) {
  const std::size_t e = number.find_first_of("eE");
  const std::string_view mantissa = without_sign(number.substr(0, e));
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  const auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (e == std::string_view::npos) return place < 0;
  const std::string_view exponent = number.substr(e + 1);
  std::int64_t power = 0;
  const std::string_view digits = without_sign(exponent);
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), power);
  if (result.ec != std::errc{}) power = std::numeric_limits<std::int64_t>::max() / 2;
  if (exponent.front() == '-') power = -power;
  return power + place < 0;
}

tl::unexpected<std::string> wrong(std::string message) {
  return tl::make_unexpected(std::move(message));
}

std::string remove_all(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) == std::string_view::npos) result += c;
  }
  return result;
}

// Thousands in groups of three behind the first `mark`: "1,234,567".
bool are_thousands(std::string_view text, char mark) {
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark)) {
    text.remove_prefix(at + 1);
    if (count_digits(text) != 3) return false;
  }
  return true;
}

// A text of the form "whole,fraction" or with thousands marked by something.
std::optional<std::string> explain_separator(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma != std::string_view::npos) {
    // "1.234,5" is 1234.5 where the comma is the decimal mark.
    const bool last = text.find('.') < comma && are_thousands(text.substr(0, comma), '.');
    std::string with_point = last ? remove_all(text, ".") : std::string(text);
    with_point[with_point.find(',')] = '.';
    const std::string joined = remove_all(text, ",");
    const bool like_thousands = are_thousands(text, ',') && is_number(joined) && !last;
    if (is_number(with_point)) {
      return like_thousands
                 ? fmt::format("{}: a number has no ','; write {} or {}", quoted(text), with_point,
                               joined)
                 : fmt::format("{}: the decimal mark is '.'; write {}", quoted(text), with_point);
    }
    if (like_thousands)
      return fmt::format("{}: a number has no ','; write {}", quoted(text), joined);
  }
  if (text.find(' ') != std::string_view::npos && is_number(remove_all(text, " "))) {
    return fmt::format("{}: a number has no blanks; write {}, or put ',' between two numbers",
                       quoted(text), remove_all(text, " "));
  }
  if (text.find_first_of("_'") != std::string_view::npos) {
    const std::string joined = remove_all(text, "_'");
    if (is_number(joined))
      return fmt::format("{}: a number has digits only; write {}", quoted(text), joined);
  }
  return std::nullopt;
}

std::optional<std::string> explain_other_base(std::string_view text) {
  const std::string small = lower(without_sign(text));
  if (small.size() < 3 || small[0] != '0') return std::nullopt;
  const int base = small[1] == 'x' ? 16 : small[1] == 'o' ? 8 : small[1] == 'b' ? 2 : 0;
  if (base == 0) return std::nullopt;
  std::uint64_t value = 0;
  const char* const end = small.data() + small.size();
  const auto result = std::from_chars(small.data() + 2, end, value, base);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return fmt::format("{}: numbers are decimal; write {}{}", quoted(text),
                     text.front() == '-' ? "-" : "", value);
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::optional<std::string> explain_word(std::string_view text) {
  const std::string word = lower(text);
  const std::string_view bare = without_sign(word);
  if (text.empty()) return "nothing where a number is wanted";
  if (is_one_of(bare, {"nan", ".nan", "inf", ".inf", "infinity"}))
    return fmt::format("{}: a finite number is wanted", quoted(text));
  if (is_one_of(word, {"yes", "no", "true", "false", "on", "off"}))
    return fmt::format("{} is a truth value where a number is wanted", quoted(text));
  if (is_one_of(word, {"null", "~"}))
    return fmt::format("{} where a number is wanted", quoted(text));
  if (text.front() == '=')
    return fmt::format("the expression {} where a plain number is wanted", quoted(text));
  return std::nullopt;
}

// A number with what ends a statement or begins a comment in another language.
std::optional<std::string> explain_end(std::string_view text) {
  const std::size_t end = text.find_last_not_of("0123456789.eE+-");
  const std::size_t begin = std::min(text.find_first_of(";/!"), text.size());
  const std::string_view number = text.substr(0, text.find_last_not_of(' ', begin - 1) + 1);
  if (end == std::string_view::npos || begin == text.size() || !is_number(number)) {
    return std::nullopt;
  }
  if (begin + 1 == text.size() && text[begin] == ';')
    return fmt::format("{}: nothing stands behind a number; write {}", quoted(text), number);
  if (text[begin] == '!' || text.substr(begin).starts_with("//"))
    return fmt::format("{}: a comment begins with ' #'; write {} # ..", quoted(text), number);
  return std::nullopt;
}

std::string_view trimmed_left(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

// "1d3", which Fortran writes for 1e3; empty if the text is none.
std::string fortran_exponent(std::string_view number, std::string_view rest) {
  const bool marked = !rest.empty() && (rest[0] == 'd' || rest[0] == 'D') &&
                      number.find_first_of("eE") == std::string_view::npos;
  std::string with_e = marked ? fmt::format("{}e{}", number, rest.substr(1)) : "";
  return is_number(with_e) ? with_e : "";
}

// Returns what begins like a number and goes on as something else.
std::optional<std::string> explain_rest(std::string_view text) {
  const std::size_t length = number_prefix(text);
  if (length == 0) return std::nullopt;
  const std::string_view number = text.substr(0, length);
  const std::string_view rest = text.substr(length);
  if (const std::string with_e = fortran_exponent(number, rest); !with_e.empty())
    return fmt::format("{}: write {}", quoted(text), with_e);
  if (trimmed_left(rest) == "%") {
    if (const auto value = parse_number(number))
      return fmt::format("{}: write the fraction {}", quoted(text), format_number(*value / 100.0));
  }
  if (is_one_of(lower(rest), {"e", "e+", "e-"}))
    return fmt::format("{}: the exponent has no digits", quoted(text));
  const bool arithmetic = rest.find_first_of("+-*/^()") != std::string_view::npos &&
                          rest.find_first_not_of("0123456789.eE+-*/^() ") == std::string_view::npos;
  if (arithmetic)
    return fmt::format("{}: an expression begins with '='; write '= {}'", quoted(text), text);
  if (rest[0] == '.' && count_digits(rest.substr(1)) > 0)
    return fmt::format("{} has two decimal points", quoted(text));
  if (split_unit(text))
    return fmt::format("{}: a number without a unit is wanted here", quoted(text));
  return std::nullopt;
}

std::string explain(std::string_view text) {
  constexpr std::string_view kMinusSign = "\xE2\x88\x92";
  if (auto reason = explain_word(text)) return *reason;
  if (auto reason = explain_end(text)) return *reason;
  if (auto reason = explain_separator(text)) return *reason;
  if (auto reason = explain_other_base(text)) return *reason;
  if (auto reason = explain_rest(text)) return *reason;
  // "1,5 mm": the number in front of the unit is what is wrong.
  if (const auto blank = text.rfind(' '); blank != std::string_view::npos && blank > 0) {
    if (is_letter(text[blank + 1 < text.size() ? blank + 1 : blank])) {
      if (auto reason = explain_separator(text.substr(0, blank))) return *reason;
    }
  }
  if (text.starts_with(kMinusSign)) return fmt::format("{}: write the sign as '-'", quoted(text));
  const bool like_name = is_letter(text.front()) && text.find(' ') == std::string_view::npos;
  if (like_name && text.size() < 40)
    return fmt::format("{} is not a number; a parameter is written '= {}'", quoted(text), text);
  return fmt::format("{} is not a number", quoted(text));
}

}  // namespace

std::optional<NumberAndUnit> split_unit(std::string_view text) {
  const std::size_t length = number_prefix(text);
  if (length == 0 || explain_other_base(text)) return std::nullopt;
  const std::string_view number = text.substr(0, length);
  const std::string_view rest = text.substr(length);
  const std::string_view unit = trimmed_left(rest);
  if (!fortran_exponent(number, rest).empty() || is_one_of(lower(rest), {"e", "e+", "e-"}))
    return std::nullopt;
  // The two bytes begin the micro sign and the degree sign.
  const bool like_unit = !unit.empty() && (is_letter(unit[0]) || unit[0] == '\xC2' ||
                                           unit[0] == '\xCE' || unit.starts_with("1/"));
  if (!like_unit) return std::nullopt;
  return NumberAndUnit{number, unit};
}

tl::expected<double, std::string> parse_number(std::string_view text) {
  if (!is_number(text)) return wrong(explain(text));
  if (has_leading_zero(text))
    return wrong(
        fmt::format("{} has a leading zero; write {}", quoted(text), without_leading_zeros(text)));
  const std::string_view digits = text.front() == '+' ? text.substr(1) : text;
  double value = 0.0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const auto is_zero = [&] {
    return text.substr(0, text.find_first_of("eE")).find_first_of("123456789") ==
           std::string_view::npos;
  };
  const bool out_of_range = result.ec != std::errc{} || std::isinf(value);
  if ((out_of_range || value == 0.0) && !is_zero()) {
    return wrong(is_too_small(text)
                     ? fmt::format("{} is too small for a double; write 0 or at least 2.3e-308",
                                   quoted(text))
                     : fmt::format("{} is too large for a double (at most 1.7e308)", quoted(text)));
  }
  // A zero may carry any exponent.
  if (out_of_range) return text.front() == '-' ? -0.0 : 0.0;
  const bool denormal = value != 0.0 && std::abs(value) < std::numeric_limits<double>::min();
  if (denormal && significant_digits(text) != significant_digits(format_number(value))) {
    return wrong(fmt::format("{} loses digits as a double; below 2.3e-308 there are fewer than 16",
                             quoted(text)));
  }
  return value;
}

tl::expected<long long, std::string> parse_integer(std::string_view text) {
  const std::string_view digits = without_sign(text);
  const bool plain = !digits.empty() && count_digits(digits) == digits.size();
  if (plain && !has_leading_zero(text)) {
    const std::string_view readable = text.front() == '+' ? digits : text;
    long long value = 0;
    const auto result = std::from_chars(readable.data(), readable.data() + readable.size(), value);
    if (result.ec == std::errc{}) return value;
    return wrong(fmt::format("{} is too large for an integer", quoted(text)));
  }
  const auto number = parse_number(text);
  if (!number) return tl::make_unexpected(number.error());
  constexpr double kExact = 9007199254740992.0;
  if (std::trunc(*number) == *number && std::abs(*number) <= kExact)
    return wrong(fmt::format("{} where an integer is wanted; write {}", quoted(text),
                             static_cast<long long>(*number)));
  return wrong(fmt::format("{} where an integer is wanted", quoted(text)));
}

}  // namespace slipbench::driver::base
