// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace slipbench::law {

/// Two neighbouring places, or the ends of a bracket that has none in between.
struct Turn {
  double low = 0.0;
  double high = 0.0;
};

/// Where in [low, high] `is_low` turns from true to false, by bisection to the last digit.
template <class IsLow>
Turn turn(double low, double high, IsLow is_low) noexcept {
  for (int i = 0; i < 100; ++i) {
    const double middle = low + 0.5 * (high - low);
    if (!(middle > low && middle < high)) break;
    (is_low(middle) ? low : high) = middle;
  }
  return {low, high};
}

}  // namespace slipbench::law
