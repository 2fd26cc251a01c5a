// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::driver::bench {

/// An interval in which a function changes its sign.
struct Bracket {
  double a = 0.0;  ///< where the function has the sign it sets out with
  double b = 0.0;  ///< where it has the other one, or is 0
};

/// Narrows the bracket of a function until its ends are neighbours, or as near as `tolerance`:
/// regula falsi with the halved ordinates of the Illinois rule, every third time a bisection, so
/// that a jump of the function is found too. `fa` and `fb` are the values at the ends; fa != 0.
/// \return the narrowed bracket; its b is the side that is beyond the root
template <class Function>
Bracket narrow(Bracket bracket, double fa, double fb, double tolerance, Function&& f) {
  constexpr int kMostRounds = 200;
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  auto& [a, b] = bracket;
  double weight_a = fa, weight_b = fb;
  int side = 0;  // which end moved last
  for (int round = 0; round < kMostRounds && fb != 0.0; ++round) {
    const double near = std::max(tolerance, 2.0 * kEpsilon * std::max(std::abs(a), std::abs(b)));
    if (std::abs(b - a) <= near) break;
    double x =
        round % 3 == 2 ? 0.5 * (a + b) : (a * weight_b - b * weight_a) / (weight_b - weight_a);
    // Close to an end the secant creeps: step over the root to the other side of it.
    const double low = std::min(a, b) + 0.5 * near;
    const double high = std::max(a, b) - 0.5 * near;
    if (!(x >= low && x <= high)) x = std::isfinite(x) ? std::clamp(x, low, high) : 0.5 * (a + b);
    const double fx = f(x);
    if (fx != 0.0 && (fx < 0.0) == (fa < 0.0)) {
      a = x;
      fa = weight_a = fx;
      if (side < 0) weight_b *= 0.5;
      side = -1;
    } else {
      b = x;
      fb = weight_b = fx;
      if (side > 0) weight_a *= 0.5;
      side = 1;
    }
  }
  return bracket;
}

}  // namespace slipbench::driver::bench
