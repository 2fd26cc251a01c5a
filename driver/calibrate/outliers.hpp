// SPDX-License-Identifier: Apache-2.0
// Points that do not belong to the noise of the others.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace slipbench::driver::calibrate {

/// Standard deviations over the median magnitude of normal noise.
inline constexpr double kNormalOverMedian = 1.4826;
/// Standard deviations within which points keep their weight: Huber's choice, that loses 5 % under
/// normal noise without outliers.
inline constexpr double kUsualThreshold = 1.345;

/// The middle value; the upper one of the two of an even count. NaN of none.
double median(std::vector<double> numbers);

/// 1.4826 times the median distance from the median: the standard deviation of normal noise, which
/// outliers hardly move. NaN of none.
double robust_scale(std::span<const double> residuals);

struct Outliers {
  double scale = std::numeric_limits<double>::quiet_NaN();  ///< robust_scale
  /// An outlier is farther than so many scales from the median, and from the median of its six
  /// neighbours by as many scales of those differences. Of normal noise fewer than 1 of 100 series
  /// have such a point, however long they are; infinite below 20 points.
  double limit = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> points;  ///< ascending
};

/// Outliers of residuals in the order of time. A trend has none, since its neighbours are alike;
/// nor have data that are scattered in two ways: more than 5 of 100 are no outliers. \param
/// rounding residuals whose scale is not above it have none
Outliers find_outliers(std::span<const double> residuals, double rounding);

/// The finite residuals that are no outliers, in their order.
std::vector<double> other_residuals(std::span<const double> residuals, const Outliers& outliers);

}  // namespace slipbench::driver::calibrate
