// SPDX-License-Identifier: Apache-2.0
#include "driver/base/text/format_number.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace slipbench::driver::base {

void append_number(std::string& text, double value) {
  if (std::isnan(value)) {
    // The sign of a NaN depends on the operation that made it, and says nothing.
    text += "nan";
    return;
  }
  // The longest is -2.2250738585072014e-308: 24 characters.
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace slipbench::driver::base
