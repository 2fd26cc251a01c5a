// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "law/base/capstan.hpp"
#include "law/base/exponential_sum.hpp"
#include "law/friction/slip_line.hpp"

namespace slipbench::law {

/// A coefficient before its floor along a SlipLine, t = 0 at the slip and 1 at the end of the line:
///   mu(t) = numerator(t) / denominator(t),   denominator > 0,
/// up to `until`, where another formula takes over. Where there is a denominator q, mu is also a
/// constant less recovery/q, of which the slopes can be had without cancellation.
struct CoefficientCurve {
  ExponentialSum numerator;
  ExponentialSum denominator;  ///< empty: 1
  double recovery = 0.0;
  double until = std::numeric_limits<double>::infinity();
};

/// Part of the line that counts as the place the search stands on.
inline double standing(const SlipLine& line) { return 1e-13 * line.slip / (line.end - line.slip); }

/// The next slip at which mu F_N, with F_N linear along the line, may have a kink or may change its
/// curvature: the end of the formula, the floor, an inflection. Infinity if there is none up to the
/// end of the line. All inflections are found: the numerator of (mu F_N)'' is an ExponentialSum.
double next_bend(const CoefficientCurve& curve, const SlipLine& line) noexcept;

/// The same for exp(mu alpha) or -exp(-mu alpha), the limit of a belt, whose curvature has the sign
/// of alpha mu'' + (alpha mu')^2 or alpha mu'' - (alpha mu')^2.
double next_belt_bend(const CoefficientCurve& curve, const SlipLine& line, double wrap_angle,
                      FlowSense sense) noexcept;

}  // namespace slipbench::law
