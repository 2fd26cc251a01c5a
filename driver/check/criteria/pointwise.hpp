// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Gives `take` the points of a result and its reference, in the order of the reference, and
/// returns why the two cannot be compared: empty if they can, and then there is a point at least.
///
/// A point is the result at each row of the reference that lies in the common range, interpolated
/// linearly within the branch of the same number (docs/theory, section 16). An abscissa that only
/// increases, such as time, is one branch.
///
/// Where the result has several rows at the reference's abscissa (equal but for rounding,
/// kSameTime) it jumps or dwells there, and all its values stand: the nearest counts, and if time
/// passes between these rows also all values in between: a place in which time passes is a rest.
/// A row of the reference that lies no further from a rest of the result than the result's own
/// increment on that side (if the reference has several rows there, than any increment next to
/// either curve's rest) may also be met by a value of that rest, or on the way to it: where the
/// abscissa comes to rest depends on the increments. Not so where the reference has several rows in
/// the place of this rest, too. The very rows of the result, and identical
/// abscissas of which no two are the same place, are compared row by row instead.
///
/// A row at a reversal is compared once. Faults: unusable curves or nothing in common, less than
/// two rows of a reference that has more, different numbers of branches, branches in opposite
/// directions. A result of a single row is compared all the same.
std::string each_point(const Series& result, const Series& reference,
                       const std::function<void(const CurvePoint&)>& take);

/// All of these points.
struct PointwiseComparison {
  std::string fault;
  std::vector<CurvePoint> points;
};
PointwiseComparison compare_points(const Series& result, const Series& reference);

/// One measure, the point of the largest deviation as PointJudge finds it; `compared` is the number
/// of points.
CurveComparison compare_pointwise(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
