// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "law/friction/coefficient_point.hpp"

namespace slipbench::law {

/// Floor of the coefficients of the Radioss laws (theory 9.3):
/// mu = max(raw, 1e-30). There is no upper bound.
inline constexpr double kCoefficientFloor = 1.0e-30;

/// The coefficient in force of a raw one; where it is kept up its slopes vanish.
inline CoefficientPoint clamped(const CoefficientPoint& raw) {
  return raw.mu >= kCoefficientFloor ? raw : CoefficientPoint{kCoefficientFloor, 0.0, 0.0};
}

/// An exponent above this one counts as overflow; exp(709.8) is the largest a double holds.
inline constexpr double kLargestExponent = 700.0;
/// Value of a law where an exponent overflows: the run fails there, but a search may look.
inline constexpr CoefficientPoint kOverflown{std::numeric_limits<double>::infinity(), 0.0, 0.0};

}  // namespace slipbench::law
