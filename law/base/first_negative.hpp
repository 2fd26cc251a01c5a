// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slipbench::law {

/// Zero of f in [low, high], f(low) >= 0 > f(high): Chandrupatla (1997, Advances in Engineering
/// Software 28, 145-149), which interpolates where the inverse quadratic through three places is
/// monotone in the bracket, and bisects elsewhere. Returns the side where f < 0, so that what
/// follows is past it.
/// \param width of the bracket in the end, as a part of the larger of `high` and `least`
template <class Function>
double first_negative(Function&& f, double low, double high,
                      double width = 2.0 * std::numeric_limits<double>::epsilon(),
                      double least = 0.0) {
  // The bracket is between `a`, the latest place, and `b`; `c` is the place before.
  double b = low;
  double at_b = f(b);
  double a = high;
  double at_a = f(a);
  double part = 0.5;
  for (int i = 0; i < 100; ++i) {
    const double tolerance = width * std::max({a, b, least});
    if (!(std::abs(b - a) > tolerance)) break;
    const double next = a + part * (b - a);
    if (next == a || next == b) break;
    const double value = f(next);
    double c = a;
    double at_c = at_a;
    if ((value < 0.0) != (at_a < 0.0)) {
      std::swap(b, c);
      std::swap(at_b, at_c);
    }
    a = next;
    at_a = value;
    const double xi = (a - b) / (c - b);
    const double phi = (at_a - at_b) / (at_c - at_b);
    part = 0.5;
    if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
      const double shortest = std::min(0.5, 0.5 * tolerance / std::abs(b - a));
      part = at_a / (at_b - at_a) * at_c / (at_b - at_c) +
             (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b);
      part = std::clamp(part, shortest, 1.0 - shortest);
    }
  }
  return at_a < 0.0 ? a : b;
}

}  // namespace slipbench::law
