// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Place where a curve first leaves its initial slope.
struct Breakaway {
  std::string fault;  ///< why there is none; empty if there is
  double abscissa = 0.0;
  double value = 0.0;
  double time = 0.0;  ///< NaN where it is not known
};

/// The breakaway of the first branch of a curve over a position (docs/theory, section 16): with
/// u and g the changes of abscissa and value from the first row, positive the way the curve goes,
/// and G the largest g of the branch,
///   - the initial slope is the steepest of the first five tenths of G, which leaves aside
///   clearance
///     and a soft start;
///   - the curve has left it where it is 2 % of G below it;
///   - breakaway is where its course there (from 1 % to 2 %), traced back, meets the initial slope,
///     but not before a row that is still on it.
/// So a sharp knee is found exactly however coarse the rows, if one of them is before the knee and
/// two behind it; of a drop from static to kinetic friction, the last row of the initial slope. A
/// knee within the first row counts as its end. A vertical start (rigid) breaks away where it ends.
/// Faults: no branch, no change of the value, or a curve that never leaves its initial slope.
Breakaway breakaway(const Series& curve);

/// Two measures: value at breakaway [quantity], and its position [abscissa], which
/// `tolerance.abscissa` bounds. Scales are the ranges of the reference.
CurveComparison compare_breakaway(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
