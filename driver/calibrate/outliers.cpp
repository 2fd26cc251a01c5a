// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/outliers.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::driver::calibrate {
namespace {

/// Neighbours on each side that a point is compared with.
constexpr std::size_t kReach = 3;

std::vector<double> finite_of(std::span<const double> residuals) {
  std::vector<double> finite;
  std::copy_if(residuals.begin(), residuals.end(), std::back_inserter(finite),
               [](double r) { return std::isfinite(r); });
  return finite;
}

/// Distances of a point's value from the median of its neighbours.
std::vector<double> steps_from_neighbours(std::span<const double> residuals) {
  std::vector<double> steps;
  std::vector<double> near;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    near.clear();
    const std::size_t end = std::min(residuals.size(), i + kReach + 1);
    for (std::size_t k = i > kReach ? i - kReach : 0; k < end; ++k) {
      if (k != i && std::isfinite(residuals[k])) near.push_back(residuals[k]);
    }
    steps.push_back(near.empty() ? 0.0 : residuals[i] - median(near));
  }
  return steps;
}

}  // namespace

double median(std::vector<double> numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

double robust_scale(std::span<const double> residuals) {
  std::vector<double> distances = finite_of(residuals);
  const double centre = median(distances);
  for (double& one : distances) one = std::abs(one - centre);
  return kNormalOverMedian * median(std::move(distances));
}

Outliers find_outliers(std::span<const double> residuals, double rounding) {
  constexpr std::size_t kFewest = 20;
  constexpr double kFalseAlarms = 0.01;
  constexpr double kMostShare = 0.05;
  const std::vector<double> finite = finite_of(residuals);
  Outliers found;
  found.scale = robust_scale(finite);
  if (finite.size() < kFewest || !(found.scale > rounding)) return found;
  const auto n = static_cast<double>(finite.size());
  // Bonferroni's bound; of few points the scale is not well known, which 5/n makes up for.
  found.limit = gsl_cdf_ugaussian_Qinv(0.5 * kFalseAlarms / n) * (1.0 + 5.0 / n);
  const double centre = median(finite);
  const std::vector<double> steps = steps_from_neighbours(residuals);
  const double step = robust_scale(steps);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (std::abs(residuals[i] - centre) > found.limit * found.scale &&
        std::abs(steps[i]) > found.limit * step) {
      found.points.push_back(i);
    }
  }
  if (static_cast<double>(found.points.size()) > kMostShare * n) found.points.clear();
  return found;
}

std::vector<double> other_residuals(std::span<const double> residuals, const Outliers& outliers) {
  std::vector<double> others;
  auto next = outliers.points.begin();
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (next != outliers.points.end() && *next == i) {
      ++next;
    } else if (std::isfinite(residuals[i])) {
      others.push_back(residuals[i]);
    }
  }
  return others;
}

}  // namespace slipbench::driver::calibrate
