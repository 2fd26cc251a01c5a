// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {
namespace {

double distance(double a, double b) {
  const double apart = std::abs(a - b);
  // So that what is not known, NaN, is no distance either.
  return apart > history::kSameTime * std::max(std::abs(a), std::abs(b))
             ? apart
             : std::numeric_limits<double>::infinity();
}

}  // namespace

Spacing spacing(const CurvePoint& a, const CurvePoint& b) {
  return {distance(a.abscissa, b.abscissa), distance(a.time, b.time)};
}

Spacing narrower(const Spacing& a, const Spacing& b) {
  return {std::min(a.abscissa, b.abscissa), std::min(a.time, b.time)};
}

ToldPoint told_point(const CurvePoint& point, const Series& curve) {
  ToldPoint told{point, {}};
  if (curve.time.empty() || std::isnan(point.time)) return told;
  const auto next = std::lower_bound(curve.time.begin(), curve.time.end(), point.time);
  const auto at = static_cast<std::size_t>(next - curve.time.begin());
  for (std::size_t i = at > 0 ? at - 1 : 0; i < std::min(at + 2, curve.size()); ++i) {
    const CurvePoint neighbour{.abscissa = curve.abscissa[i], .time = curve.time[i]};
    told.spacing = narrower(told.spacing, spacing(point, neighbour));
  }
  return told;
}

std::string place_text(double value, double distance) {
  constexpr double kFewest = 4.0;
  constexpr double kMost = 17.0;
  double digits = kFewest;
  if (value != 0.0 && std::isfinite(value) && std::isfinite(distance)) {
    digits = std::floor(std::log10(std::abs(value))) - std::floor(std::log10(distance)) + 1.0;
  }
  return fmt::format("{:.{}g}", value, static_cast<int>(std::clamp(digits, kFewest, kMost)));
}

}  // namespace slipbench::driver::check
