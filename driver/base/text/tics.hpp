// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace slipbench::driver::base {

/// A distance of tics that divides a range into about `parts` parts: 1, 2 or 5 times a power of
/// ten; 1 for an empty range.
inline double tic_step(double range, double parts) {
  if (!(range > 0.0)) return 1.0;
  const double part = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(part)));
  const double digit = part / power;
  return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

}  // namespace slipbench::driver::base
