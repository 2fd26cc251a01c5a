// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"

namespace slipbench::law {

/// Returns the fraction [1] at which a force that turns back from outside comes out of the limit
/// again, 0 if it does not get inside before the predictor; a limit of 0 is met where the force
/// passes 0.
template <int D>
[[gnu::noinline, gnu::cold]] double fraction_from_outside(const Slip<D>& y0, const Slip<D>& trial,
                                                          double limit) {
  const Slip<D> rise = trial - y0;
  const double a = rise.squaredNorm();
  const double b = y0.dot(rise);
  if (!(b < 0.0 && a + b > 0.0)) return 0.0;
  // Not b^2 - a (y0^2 - limit^2), a difference of large numbers: how near the path passes to 0.
  double apart = 0.0;
  if constexpr (D > 1) apart = (y0 - b / a * rise).squaredNorm();
  // A path through 0 leaves the rounding of y0.
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (apart <= kRounding * kRounding * y0.squaredNorm()) apart = 0.0;
  const double square = limit * limit - apart;
  return square >= 0.0 ? std::min((std::sqrt(a * square) - b) / a, 1.0) : 0.0;
}

/// The fraction of an increment [1] at which a force that rises from y0 along the straight line to
/// the predictor `trial` meets the limit |y| = `limit`; 0 where it does not get inside before.
template <int D>
[[gnu::always_inline]] inline double limit_fraction(const Slip<D>& y0, const Slip<D>& trial,
                                                    double limit) {
  const double square = limit * limit;
  const double excess = y0.squaredNorm() - square;
  // A force returned to the limit may lie above it by its rounding; it counts as on the limit.
  if (excess > 2.0 * (kLimitSlack - 1.0) * square) {
    return fraction_from_outside<D>(y0, trial, limit);
  }
  const Slip<D> rise = trial - y0;
  const double a = rise.squaredNorm();
  if (!(a > 0.0)) return 0.0;
  const double b = y0.dot(rise);
  const double c = std::min(excess, 0.0);
  // The stable form of the larger root of a x^2 + 2 b x + c = 0.
  const double root = std::sqrt(std::max(b * b - a * c, 0.0));
  return std::clamp(b > 0.0 ? -c / (b + root) : (root - b) / a, 0.0, 1.0);
}

/// Work [F L] over ds of a force that goes from y0 straight towards `trial` for the fraction
/// `onset` of the increment, and then to y1.
template <int D>
[[gnu::always_inline]] inline double work_split_at(double onset, const Slip<D>& y0,
                                                   const Slip<D>& trial, const Slip<D>& y1,
                                                   const Slip<D>& ds) {
  const Slip<D> split = y0 + onset * (trial - y0);
  return 0.5 * (onset * (y0 + split).dot(ds) + (1.0 - onset) * (split + y1).dot(ds));
}

/// Work of the force going from y0 to y1 over ds. The force first rises along the straight line to
/// the predictor `trial`; where that meets the limit the increment is split, so that the trapezoid
/// is exact for an elastic-plastic path in one dimension (docs/theory, section 13).
/// \param[out] onset the fraction of the increment before the split
template <int D>
[[gnu::always_inline]] inline double split_work(const Slip<D>& y0, const Slip<D>& trial,
                                                const Slip<D>& y1, const Slip<D>& ds, double limit,
                                                double* onset) {
  *onset = limit_fraction<D>(y0, trial, limit);
  return work_split_at<D>(*onset, y0, trial, y1, ds);
}

}  // namespace slipbench::law
