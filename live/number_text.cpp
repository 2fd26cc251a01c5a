// SPDX-License-Identifier: Apache-2.0
#include "live/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace slipbench::live {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns how much of a text is a number as std::from_chars reads them; 0 if none stands there.
std::size_t number_length(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const auto word = [&](std::string_view wanted) {
    const std::string_view here = text.substr(at, wanted.size());
    return std::equal(here.begin(), here.end(), wanted.begin(), wanted.end(),
                      [](char a, char b) { return (a | 0x20) == b; });
  };
  for (const std::string_view wanted : {"infinity", "inf", "nan"}) {
    if (word(wanted)) return at + wanted.size();
  }
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - begin;
  };
  std::size_t count = digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    const std::size_t fraction = digits();
    if (count + fraction == 0) return 0;
    count += fraction;
  }
  if (count == 0) return 0;
  const std::size_t end = at;
  if (at == text.size() || (text[at] | 0x20) != 'e') return end;
  ++at;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  return digits() > 0 ? at : end;
}

}  // namespace

std::from_chars_result read_number(const char* first, const char* last, double& value) {
  const std::size_t length = number_length({first, static_cast<std::size_t>(last - first)});
  if (length == 0) return {first, std::errc::invalid_argument};
  // musl's strtod rounds correctly, and knows no other decimal mark than the point.
  const std::string text(first, length);
  const double read = std::strtod(text.c_str(), nullptr);
  const bool finite = is_digit(text.back()) || text.back() == '.';
  const bool nonzero =
      text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != std::string::npos;
  if (finite && (std::isinf(read) || (read == 0.0 && nonzero))) {
    return {first + length, std::errc::result_out_of_range};
  }
  value = read;
  return {first + length, std::errc{}};
}

std::to_chars_result write_number(char* first, char* last, double value) {
  std::string text = std::signbit(value) ? "-" : "";
  if (!std::isfinite(value)) {
    text += std::isnan(value) ? "nan" : "inf";
  } else if (value == 0.0) {
    text += "0";
  } else {
    const auto decimal = fmt::detail::dragonbox::to_decimal(std::abs(value));
    const std::string digits = std::to_string(decimal.significand);
    const int count = static_cast<int>(digits.size());
    const int power = decimal.exponent + count - 1;  // of the first digit
    const std::string scientific = fmt::format("{}{}{}e{:+03d}", digits.substr(0, 1),
                                               count > 1 ? "." : "", digits.substr(1), power);
    const int fixed = power < 0 ? 1 - power + count : decimal.exponent >= 0 ? power + 1 : count + 1;
    if (fixed > static_cast<int>(scientific.size())) {
      text += scientific;
    } else if (decimal.exponent >= 0) {
      text += fmt::format("{:.0f}", std::abs(value));
    } else if (power < 0) {
      text += "0." + std::string(static_cast<std::size_t>(-power - 1), '0') + digits;
    } else {
      const auto whole = static_cast<std::size_t>(power) + 1;
      text += digits.substr(0, whole) + "." + digits.substr(whole);
    }
  }
  if (static_cast<std::ptrdiff_t>(text.size()) > last - first) {
    return {last, std::errc::value_too_large};
  }
  return {std::copy(text.begin(), text.end(), first), std::errc{}};
}

}  // namespace slipbench::live
