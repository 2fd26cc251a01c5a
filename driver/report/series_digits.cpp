// SPDX-License-Identifier: Apache-2.0
#include "driver/report/series_digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::driver::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

int digits_within(double value, double resolution) {
  if (!(resolution > 0.0) || !std::isfinite(value) || value == 0.0) return kFewestDigits;
  const double digits = std::ceil(std::log10(std::abs(value) / resolution));
  return static_cast<int>(
      std::clamp(digits, static_cast<double>(kFewestDigits), static_cast<double>(kMostDigits)));
}

SeriesDigits::SeriesDigits(std::span<const double> numbers) : numbers_(numbers) {
  constexpr double kRounding = 1e-12;
  constexpr double kStepOfRange = 1e-8;
  double low = kInfinity;
  double high = -kInfinity;
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    low = std::min(low, number);
    high = std::max(high, number);
  }
  const double range = high - low;
  if (!(range > kRounding * std::max(std::abs(low), std::abs(high)))) {
    least_step_ = kInfinity;  // a constant, but for rounding
    return;
  }
  of_range_ = range * std::pow(10.0, -kFewestDigits);
  least_step_ = kStepOfRange * range;
}

int SeriesDigits::operator[](std::size_t i) const {
  double step = kInfinity;
  const auto take = [&](std::size_t other) {
    const double size = std::abs(numbers_[other] - numbers_[i]);
    if (size > least_step_) step = std::min(step, size);
  };
  if (i > 0) take(i - 1);
  if (i + 1 < numbers_.size()) take(i + 1);
  return digits_within(numbers_[i], std::min(of_range_, 1e-3 * step));
}

double time_resolution(std::span<const double> times) {
  constexpr double kRounding = 1e-12;
  double shortest = kInfinity;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    if (step > kRounding * std::abs(times[i])) shortest = std::min(shortest, step);
  }
  return std::isfinite(shortest) ? 1e-3 * shortest : 0.0;
}

}  // namespace slipbench::driver::report
