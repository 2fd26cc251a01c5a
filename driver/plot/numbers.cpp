// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/base/text/tics.hpp"

namespace slipbench::driver::plot {
namespace {

/// A double has no more.
constexpr int kMostDigits = 17;

/// By how many digits the numbers of a range are larger than the range.
int digits_before_range(double lowest, double highest) {
  const double largest = std::max(std::abs(lowest), std::abs(highest));
  const double range = highest - lowest;
  if (!(range > 0.0) || !std::isfinite(largest)) return 0;
  return std::max(0, static_cast<int>(std::ceil(std::log10(largest / range))));
}

}  // namespace

int drawn_digits(double lowest, double highest) {
  constexpr int kOfRange = 9;
  return std::min(kMostDigits, kOfRange + digits_before_range(lowest, highest));
}

std::string tic_format(double lowest, double highest) {
  constexpr int kUsual = 6;
  constexpr int kOfRange = 2;
  const int digits = kOfRange + digits_before_range(lowest, highest);
  return digits <= kUsual ? "% h" : fmt::format("%.{}g", std::min(digits, kMostDigits));
}

double wide_tic_step(double lowest, double highest, double parts) {
  const double largest = std::max(std::abs(lowest), std::abs(highest));
  const bool short_numbers =
      largest == 0.0 || (largest < 1e5 && highest - lowest >= 1e-3 * largest && largest >= 1e-3);
  return base::tic_step(highest - lowest, short_numbers ? parts : 0.5 * parts);
}

}  // namespace slipbench::driver::plot
