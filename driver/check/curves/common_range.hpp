// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

struct Interval {
  double from = 0.0;
  double to = 0.0;
  double width() const { return to - from; }
};

/// From the smallest to the largest of some numbers, at least one.
Interval extent(std::span<const double> numbers);

/// The range of an abscissa that two curves share.
struct CommonRange {
  std::string fault;  ///< in words why there is none; empty if there is one
  Interval interval;
  double slack = 0.0;  ///< abscissas that differ by no more are the same but for rounding
};

/// Tells whether two curves are at the same abscissas at the same known times: the same rows.
bool are_same_rows(const Series& result, const Series& reference);

/// Faults: a curve that is empty, has columns of different lengths or a number that is not finite;
/// a reference whose ranges are not finite; ranges without a common part, or with one point only. A
/// result of a single row is compared at its point all the same, and so are the very rows of a
/// result.
CommonRange common_range(const Series& result, const Series& reference);

/// The part of a curve within an interval of the abscissa, in its order; where the curve crosses an
/// end of the interval it gets an interpolated row. `slack` keeps rows beside the ends.
Series cut(const Series& curve, const Interval& interval, double slack);

}  // namespace slipbench::driver::check
