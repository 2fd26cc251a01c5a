// SPDX-License-Identifier: Apache-2.0
#include "driver/export/number_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "driver/base/text/format_number.hpp"

namespace slipbench::driver::exports {

std::string NumberWriter::operator()(double number) {
  constexpr int kAllDigits = 17;
  std::string text =
      digits_ > 0 ? fmt::format("{:.{}g}", number, digits_) : base::format_number(number);
  for (int digits = kAllDigits; text.size() > width_ && digits > 1; --digits) {
    text = fmt::format("{:.{}g}", number, digits);
  }
  const double back = std::strtod(text.c_str(), nullptr);
  if (back != number) {
    ++rounded_;
    worst_ = std::max(worst_, std::abs(back - number) / std::abs(number));
  }
  return text;
}

}  // namespace slipbench::driver::exports
