// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/fold.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace slipbench::driver::fit {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// sqrt(1 + z^2) - 1 without cancellation.
double rise(double z) {
  const double z2 = z * z;
  return z2 / (std::sqrt(1.0 + z2) + 1.0);
}

}  // namespace

Folded fold(const Limits& limits, double z) {
  if (limits.both()) {
    const double width = limits.upper - limits.lower;
    const double part = 0.5 * (1.0 + std::sin(z));
    const double value = part < 0.5 ? limits.lower + width * part
                                    : limits.upper - width * (0.5 * (1.0 - std::sin(z)));
    return {value, 1.0 - part, part, 0.5 * width * std::cos(z)};
  }
  if (std::isfinite(limits.lower)) {
    return {limits.lower + limits.unit * rise(z), 1.0, 0.0, limits.unit * z / std::hypot(1.0, z)};
  }
  if (std::isfinite(limits.upper)) {
    return {limits.upper - limits.unit * rise(z), 0.0, 1.0, -limits.unit * z / std::hypot(1.0, z)};
  }
  return {z, 0.0, 0.0, 1.0};
}

double unfold(const Limits& limits, double value, double inset) {
  if (limits.both()) {
    const double width = limits.upper - limits.lower;
    if (!(width > 0.0)) return 0.0;
    const double part = std::clamp((value - limits.lower) / width, 0.0, 1.0);
    const double z = 2.0 * std::asin(std::sqrt(part)) - kQuarter;
    return std::clamp(z, inset - kQuarter, kQuarter - inset);
  }
  if (limits.any()) {
    const double way =
        (std::isfinite(limits.lower) ? value - limits.lower : limits.upper - value) / limits.unit;
    const double z = way > 0.0 ? std::sqrt(way * (way + 2.0)) : 0.0;
    return std::max(z, inset);
  }
  return value;
}

double principal_coordinate(const Limits& limits, double z) {
  if (limits.both()) return std::asin(std::clamp(std::sin(z), -1.0, 1.0));
  return limits.any() ? std::abs(z) : z;
}

FoldPoint nearest_fold(const Limits& limits, double z) {
  if (limits.both()) {
    const double width = limits.upper - limits.lower;
    if (z < 0.0) return {-kQuarter, z + kQuarter, 1.0, width};
    return {kQuarter, kQuarter - z, -1.0, -width};
  }
  if (!limits.any()) return {0.0, std::numeric_limits<double>::infinity(), 1.0, 1.0};
  return {0.0, std::abs(z), 1.0, std::isfinite(limits.lower) ? limits.unit : -limits.unit};
}

}  // namespace slipbench::driver::fit
