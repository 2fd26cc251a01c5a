// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/compare/series.hpp"

namespace slipbench::driver {

/// Result and reference, point by point.
struct PointwiseComparison {
  std::string fault;               ///< why the two cannot be compared; empty if they can
  std::vector<CurvePoint> points;  ///< in the order of the reference; not empty without a fault
};

/// The result at each row of the reference that lies in the common range, interpolated linearly
/// within the branch of the same number (docs/theory.md, section 16). An abscissa that only
/// increases, such as time, is one branch.
///
/// Where the result has several rows at the reference's abscissa (equal but for rounding,
/// kSameTime) it jumps or dwells there, and all its values stand: the nearest counts, and if time
/// passes between these rows also all values in between. Curves with identical abscissas are
/// compared row by row instead.
///
/// A row at a reversal is compared once. Faults: unusable curves or nothing in common, different
/// numbers of branches, branches in opposite directions.
PointwiseComparison compare_points(const Series& result, const Series& reference);

/// What a relative tolerance of points is relative to: the range of their reference values, or its
/// magnitude if it is constant but for rounding.
double scale_of(const std::vector<CurvePoint>& points);

/// One measure, the point of the largest deviation; `compared` is the number of points.
CurveComparison compare_pointwise(const Series& result, const Series& reference,
                                  const Tolerance& tolerance);

}  // namespace slipbench::driver
