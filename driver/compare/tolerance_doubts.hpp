// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/case/case.hpp"

namespace slipbench::driver {

/// What a tolerance met.
struct ToleranceUse {
  double scale = 0.0;  ///< what a relative tolerance is relative to
  double worst = 0.0;  ///< largest deviation seen, in the same unit
  /// Half a unit of the last digit that the reference was printed with, in the same unit; nothing
  /// if it was not printed, or with all digits.
  std::optional<double> resolution;
  std::string unit;  ///< of all of these; may be empty
};

/// What is doubtful about a tolerance, in sentences for a person, without a period at the end:
/// - it is more than 1000 times the largest deviation, and more than 1e-6 of the scale: what it
///   would let pass is orders worse than the agreement. The sentence names a tolerance that would
///   do: ten times the deviation, at least 1e-6 of the scale, rounded up to one digit.
/// - it is smaller than the reference's printed digits allow: such a check fails by rounding.
/// Nothing is said where a number is not finite, and of the first kind nothing if the scale is 0
/// (a quantity that is zero throughout has no natural tolerance).
std::vector<std::string> tolerance_doubts(const Tolerance& tolerance, const ToleranceUse& use);

}  // namespace slipbench::driver
