// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace slipbench::reference {

/// Principal branch of Lambert's W: the w >= -1 with w e^w = x, for x >= -1/e; NaN below.
///
/// Halley's iteration from the series about the branch point, or from log1p; the last digits are
/// lost within about 1e-16 of the branch point, where W is a square root. Source: Corless, Gonnet,
/// Hare, Jeffrey and Knuth 1996.
inline double lambert_w0(double x) {
  using std::numbers::e;
  const double offset = e * x + 1.0;
  if (std::isnan(x) || offset < -4.0 * std::numeric_limits<double>::epsilon()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (x == 0.0 || x == std::numeric_limits<double>::infinity()) return x;
  if (offset <= 0.0) return -1.0;

  double w = 0.0;
  if (x < -0.25) {
    const double p = std::sqrt(2.0 * offset);
    w = -1.0 + p * (1.0 + p * (-1.0 / 3.0 + p * 11.0 / 72.0));
    if (p < 1e-4) return w;  // the next term, 43/540 p^4, is below the rounding of w
  } else {
    const double l = std::log1p(x);
    w = x < 3.0 ? l * (1.0 - std::log1p(l) / (2.0 + l)) : l - std::log(l);
  }
  for (int i = 0; i < 40; ++i) {
    // Written with e^-w so that a large x does not overflow.
    const double residual = w - x * std::exp(-w);
    const double step = residual / (w + 1.0 - 0.5 * (w + 2.0) * residual / (w + 1.0));
    w -= step;
    if (std::abs(step) <= 4.0 * std::numeric_limits<double>::epsilon() * std::abs(w)) break;
  }
  return w;
}

}  // namespace slipbench::reference
