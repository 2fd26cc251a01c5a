// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Deviations that a tolerance met.
struct ToleranceUse {
  double scale = 0.0;  ///< what a relative tolerance is relative to
  double worst = 0.0;  ///< largest deviation seen, in the same unit
  /// Largest absolute value of a reference that is compared point by point, in the same unit.
  std::optional<double> largest = std::nullopt;
  /// Half a unit of the last digit that the reference was printed with, in the same unit; nothing
  /// if it was not printed, or with all digits.
  std::optional<double> resolution;
  std::string unit;  ///< of all of these; may be empty
};

/// Returns what is doubtful about a tolerance, in sentences for a person, without a period at the
/// end:
/// - it is more than 1000 times the largest deviation, and more than 1e-6 of the scale: what it
///   would let pass is orders worse than the agreement. The sentence names a tolerance that would
///   do: ten times the deviation, at least 1e-6 of the scale, rounded up to one digit. Nothing is
///   said if that were less than the reference's digits leave open.
/// - else it is as large as the reference's largest absolute value, so that 0 would pass, too.
/// - it is smaller than the reference's printed digits allow: such a check fails by rounding. A
///   deviation of more than three times the resolution is not rounding's doing, and nothing is
///   said.
/// At most one of these is said. Nothing is said where a number is not finite, and of the first
/// kind nothing if the scale is 0 (a quantity that is zero throughout has no natural tolerance).
std::vector<std::string> tolerance_doubts(const cases::Tolerance& tolerance,
                                          const ToleranceUse& use);

/// Tells whether the digits that a reference was printed with are all there are, as of round
/// numbers or of exact integers: most of its values agree with the result far better than rounded
/// ones could. Rounded values deviate by anything up to `resolution`, so that one in a hundred
/// agrees to a hundredth of it. Counted are different values that are not 0, of each its first
/// point: zeros and the level of a plateau agree in a rounded file, too. Fewer than three say
/// something only if all points agree that well.
bool has_all_digits(std::span<const CurvePoint> points, double resolution);

/// Returns that a reference covers less than half of the range of a result, in a sentence; else
/// empty.
std::string range_doubt(const Series& result, const Series& reference);

/// The same, or that less than half of the reference's rows or range was compared.
/// \param compared rows of the reference
std::string coverage_doubt(const Series& result, const Series& reference, std::int64_t compared);

}  // namespace slipbench::driver::check
