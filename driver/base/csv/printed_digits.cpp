// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/printed_digits.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slipbench::driver::base {

void PrintedDigits::add(std::string_view text) {
  bool point = false;
  int digits = 0;              // from the first that is not 0
  int before_point = 0;        // of these
  int zeros_behind_point = 0;  // before the first of these
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.') {
      point = true;
    } else if (c >= '0' && c <= '9') {
      if (digits > 0 || c != '0') {
        ++digits;
        if (!point) ++before_point;
      } else if (point) {
        ++zeros_behind_point;
      }
    } else if (c == 'e' || c == 'E') {
      break;
    }
  }
  if (digits == 0) return;
  int exponent = before_point > 0 ? before_point - 1 : -zeros_behind_point - 1;
  if (i < text.size()) {
    std::string_view power = text.substr(i + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    int shift = 0;
    std::from_chars(power.data(), power.data() + power.size(), shift);
    exponent += shift;
  }
  digits_ = std::max(digits_, digits);
  exponent_ = std::max(exponent_.value_or(exponent), exponent);
}

std::optional<double> PrintedDigits::resolution() const {
  if (!exponent_ || exact()) return std::nullopt;
  return 0.5 * std::pow(10.0, *exponent_ - digits_ + 1);
}

}  // namespace slipbench::driver::base
