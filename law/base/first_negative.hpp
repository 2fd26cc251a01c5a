// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

namespace slipbench::law {

/// Zero of f in [low, high], f(low) >= 0 > f(high): regula falsi (Illinois), and bisection where
/// that is slow. Returns the side where f < 0, so that what follows is past it.
/// \param width of the bracket in the end, as a part of the larger of `high` and `least`
template <class Function>
double first_negative(Function&& f, double low, double high,
                      double width = 2.0 * std::numeric_limits<double>::epsilon(),
                      double least = 0.0) {
  double at_low = f(low);
  double at_high = f(high);
  for (int i = 0; i < 100 && high - low > width * std::max(high, least); ++i) {
    double next = (low * at_high - high * at_low) / (at_high - at_low);
    if (i % 4 == 3 || !(next > low && next < high)) next = low + 0.5 * (high - low);
    if (!(next > low && next < high)) break;
    const double value = f(next);
    if (value < 0.0) {
      high = next;
      at_high = value;
      at_low *= 0.5;
    } else {
      low = next;
      at_low = value;
      at_high *= 0.5;
    }
  }
  return high;
}

}  // namespace slipbench::law
