// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/tolerance_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/results/summary.hpp"

namespace slipbench::driver {
namespace {

constexpr double kLoose = 1000.0;      ///< times the largest deviation
constexpr double kTightEnough = 1e-6;  ///< of the scale
constexpr double kHeadroom = 10.0;     ///< of a suggested tolerance over the deviation

/// The next number of one digit that is not smaller, but for rounding: 0.00123 -> 0.002.
std::string one_digit_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  return fmt::format("{:.0e}", std::ceil(value / power * (1.0 - 1e-12)) * power);
}

std::string told(double value, const std::string& unit) {
  return with_unit(fmt::format("{:.3g}", value), unit);
}

}  // namespace

std::vector<std::string> tolerance_doubts(const Tolerance& tolerance, const ToleranceUse& use) {
  const double absolute = tolerance.absolute.value_or(0.0);
  const double of_scale = tolerance.relative.value_or(0.0) * use.scale;
  const double bound = std::max(absolute, of_scale);
  std::vector<std::string> doubts;
  if (!std::isfinite(bound) || !std::isfinite(use.scale) || !std::isfinite(use.worst))
    return doubts;

  if (use.scale > 0.0 && bound > kTightEnough * use.scale && use.worst * kLoose < bound) {
    const double enough = std::max(kHeadroom * use.worst, kTightEnough * use.scale);
    const std::string seen = use.worst > 0.0
                                 ? fmt::format("{:.0e} times the largest deviation, {}",
                                               bound / use.worst, told(use.worst, use.unit))
                                 : "not needed at all, there is no deviation";
    const std::string advice = of_scale >= absolute
                                   ? "relative: " + one_digit_up(enough / use.scale)
                                   : "absolute: " + with_unit(one_digit_up(enough), use.unit);
    doubts.push_back(
        fmt::format("the tolerance of {} is {}; {} would do", told(bound, use.unit), seen, advice));
  }
  // Half a unit and a tolerance of the same size are equal but for rounding.
  if (use.resolution && std::isfinite(*use.resolution) && bound < *use.resolution * (1.0 - 1e-9)) {
    doubts.push_back(fmt::format(
        "the reference's printed digits leave it uncertain by {}, more than the tolerance of {}; "
        "print more digits or widen the tolerance",
        told(*use.resolution, use.unit), told(bound, use.unit)));
  }
  return doubts;
}

}  // namespace slipbench::driver
