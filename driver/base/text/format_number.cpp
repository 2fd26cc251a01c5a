// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/format_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace slipbench::driver::base {
namespace {

// The longest is -2.2250738585072014e-308: 24 characters.
constexpr std::size_t kMostCharacters = 32;

/// Writes a number, and returns where it ends.
/// \param to has room for kMostCharacters
char* put_number(char* to, double value) {
  // The sign of a NaN depends on the operation that made it, and says nothing.
  if (std::isnan(value)) return std::copy_n("nan", 3, to);
  return std::to_chars(to, to + kMostCharacters, value).ptr;
}

}  // namespace

void append_number(std::string& text, double value) {
  std::array<char, kMostCharacters> buffer{};
  text.append(buffer.data(), put_number(buffer.data(), value));
}

void append_numbers(std::string& text, std::span<const double> values) {
  const std::size_t size = text.size();
  text.resize(size + (kMostCharacters + 1) * values.size());
  char* to = text.data() + size;
  for (const double value : values) {
    to = put_number(to, value);
    *to++ = ',';
  }
  text.resize(static_cast<std::size_t>(to - text.data()));
}

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

double rounded_number(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

}  // namespace slipbench::driver::base
