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
  double wanted = number;
  if (digits_ > 0) wanted = std::strtod(fmt::format("{:.{}g}", number, digits_).c_str(), nullptr);
  std::string text = base::format_number(wanted);
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

void tell_rounding(std::size_t rounded, double worst, std::vector<Loss>& losses) {
  if (rounded == 0) return;
  losses.push_back(
      {Loss::Kind::kApproximated,
       fmt::format("numbers: {} rounded, by at most {:.1e} of themselves", rounded, worst)});
}

}  // namespace slipbench::driver::exports
