// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The distance of two curves in the plane of abscissa and value, point by point at equal parts of
/// their lengths; for loops, which have no function value over their abscissa.
///
/// Both curves are scaled by the reference's ranges of abscissa and value, so that the reference
/// fills a unit box (a reference value that is constant but for rounding is scaled by its
/// magnitude), and run through in the order of their rows at constant speed from s = 0 to 1. The
/// distance is d(s) = |f(s + phi) - r(s)|. Both are polygons, so the largest distance lies at a row
/// of one of them, and is found there exactly; the rows' distances along straight parts do not
/// matter, and on curved parts only by the chords' lengths, second order.
///
/// A curve is closed if its ends meet within 2 % of the box. If both are, the first curve's start
/// phi is where the mean square of d is least, so it does not matter where a loop begins; otherwise
/// phi = 0. The direction of travel matters always. Whole curves are compared, whatever their
/// ranges, and all their rounds: a check's `step` or `over` selects one.
///
/// Measures, dimensionless: "largest distance of closed loops" or "largest distance along the
/// curves", with its place, which the tolerance bounds (the larger of absolute and relative, scale
/// 1); "mean distance", at 1000 equal parts, only reported.
/// Faults: empty curves, numbers that are not finite, a reference whose abscissa does not move or
/// whose values are all zero.
CurveComparison compare_arc_length(const Series& result, const Series& reference,
                                   const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
