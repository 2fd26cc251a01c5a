// SPDX-License-Identifier: Apache-2.0
#include "driver/check/tolerance_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "driver/check/curves/common_range.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::check {
namespace {

constexpr double kLoose = 1000.0;      ///< times the largest deviation
constexpr double kTightEnough = 1e-6;  ///< of the scale
constexpr double kHeadroom = 10.0;     ///< of a suggested tolerance over the deviation

constexpr double kOfRounding = 3.0;  ///< resolutions that rounding may explain
constexpr double kFarBetter = 1e-2;  ///< of the resolution

/// The next number of one digit that is not smaller, but for rounding: 0.00123 -> 0.002.
double one_digit_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  return std::ceil(value / power * (1.0 - 1e-12)) * power;
}

std::string told(double value, const std::string& unit) {
  return base::with_unit(fmt::format("{:.3g}", value), unit);
}

}  // namespace

std::vector<std::string> tolerance_doubts(const cases::Tolerance& tolerance,
                                          const ToleranceUse& use) {
  const double absolute = tolerance.absolute.value_or(0.0);
  const double of_scale = tolerance.relative.value_or(0.0) * use.scale;
  const double bound = std::max(absolute, of_scale);
  std::vector<std::string> doubts;
  if (tolerance.relative.value_or(0.0) >= 1.0) {
    doubts.push_back(fmt::format(
        "'relative: {0:.9g}' allows {0:.9g} times the reference itself; 5 % is 'relative: 0.05'",
        *tolerance.relative));
    return doubts;
  }
  // Sums and products of such numbers would not be finite.
  constexpr double kLargest = 1e290;
  if (std::isfinite(bound) && bound >= kLargest) {
    doubts.push_back(fmt::format("the tolerance of {} allows any number", told(bound, use.unit)));
    return doubts;
  }
  if (!std::isfinite(bound) || !(use.scale < kLargest) || !(use.worst < kLargest)) return doubts;
  const double digits = use.resolution && std::isfinite(*use.resolution) ? *use.resolution : 0.0;
  const double enough = std::max(kHeadroom * use.worst, kTightEnough * use.scale);
  const bool is_relative = of_scale >= absolute;
  const double unit = is_relative ? use.scale : 1.0;
  const double advised = use.scale > 0.0 ? one_digit_up(enough / unit) : 0.0;
  // An advised tolerance is not doubted in turn.
  if (use.scale > 0.0 && bound > advised * unit * (1.0 + 1e-9) && use.worst * kLoose < bound &&
      enough >= digits) {
    const std::string seen = use.worst > 0.0
                                 ? fmt::format("{:.0e} times the largest deviation, {}",
                                               bound / use.worst, told(use.worst, use.unit))
                                 : "not needed at all, there is no deviation";
    doubts.push_back(fmt::format("the tolerance of {} is {}; '{}: {:.0e}' would do",
                                 told(bound, use.unit), seen, is_relative ? "relative" : "absolute",
                                 advised));
  } else if (const double largest = use.largest.value_or(0.0);
             0.0 < largest && largest <= absolute) {
    doubts.push_back(fmt::format("the tolerance of {} is as large as the reference itself, {}",
                                 told(absolute, use.unit), told(largest, use.unit)));
  }
  // Half a unit and a tolerance of the same size are equal but for rounding.
  if (bound < digits * (1.0 - 1e-9) && use.worst <= kOfRounding * digits) {
    doubts.push_back(fmt::format(
        "the reference's printed digits leave it uncertain by {}, more than the tolerance of {}; "
        "print more digits or widen the tolerance",
        told(digits, use.unit), told(bound, use.unit)));
  }
  return doubts;
}

bool has_all_digits(std::span<const CurvePoint> points, double resolution) {
  constexpr std::size_t kFewest = 3;
  const auto agrees = [&](double deviation) { return deviation < kFarBetter * resolution; };
  const auto deviation = [](const CurvePoint& p) { return std::abs(p.value - p.reference); };
  if (std::all_of(points.begin(), points.end(),
                  [&](const CurvePoint& p) { return agrees(deviation(p)); })) {
    return true;
  }
  struct Printed {
    double reference;
    double deviation;
  };
  std::vector<Printed> values;
  for (const CurvePoint& p : points) {
    if (p.reference != 0.0) values.push_back({p.reference, deviation(p)});
  }
  std::stable_sort(values.begin(), values.end(),
                   [](const Printed& a, const Printed& b) { return a.reference < b.reference; });
  const auto same = [](const Printed& a, const Printed& b) { return a.reference == b.reference; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  if (values.size() < kFewest) return false;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end(),
                   [](const Printed& a, const Printed& b) { return a.deviation < b.deviation; });
  return agrees(middle->deviation);
}

std::string range_doubt(const Series& result, const Series& reference) {
  if (reference.size() < 2) return {};
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return {};
  const Interval theirs = extent(reference.abscissa);
  const Interval ours = extent(result.abscissa);
  if (2.0 * common.interval.width() >= ours.width()) return {};
  return fmt::format(
      "the reference goes from {:.4g} to {:.4g} only, and the rows that the check selects from "
      "{:.4g} to {:.4g}; select with 'over' what is meant",
      theirs.from, theirs.to, ours.from, ours.to);
}

std::string coverage_doubt(const Series& result, const Series& reference, std::int64_t compared) {
  if (reference.size() < 2) return {};
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return {};
  const Interval theirs = extent(reference.abscissa);
  const auto rows = static_cast<std::int64_t>(reference.size());
  if (2 * compared >= rows && 2.0 * common.interval.width() >= theirs.width()) {
    return range_doubt(result, reference);
  }
  return fmt::format(
      "only {} of the reference's {} rows were compared, from {:.4g} to {:.4g}, while it goes from "
      "{:.4g} to {:.4g}; select with 'over' what is meant",
      compared, rows, common.interval.from, common.interval.to, theirs.from, theirs.to);
}

}  // namespace slipbench::driver::check
