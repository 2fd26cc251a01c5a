// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Returns the largest absolute value.
double magnitude(const Interval& values);

/// Returns what a relative tolerance of values is relative to: their range, or their magnitude if
/// they are constant but for rounding (range below 1e-9 of it). Of no values, 0.
double scale_of(std::span<const double> values);

/// The same of values that reach from the smallest to the largest of this range.
double scale_of(const Interval& values);

/// Returns what the scale cannot fall below, whatever other values join these.
double least_scale(const Interval& values);

/// The bound of a measure in the quantity's unit, or in quantity x abscissa: the larger of
/// `absolute` and relative * scale; infinite if only positions are bounded, 0 if nothing is.
double value_bound(const cases::Tolerance& tolerance, double scale);

/// The bound of a position: the larger of `abscissa` and relative * scale; infinite without them.
double position_bound(const cases::Tolerance& tolerance, double scale);

/// Returns what a criterion returns for curves that cannot be compared.
CurveComparison incomparable(std::string fault);

/// Returns the comparison of all.
CurveComparison compared(std::size_t points, std::vector<Measure> measures);

/// A measure with its deviation |value - reference|; scale and tolerance are left to the caller.
Measure judged(std::string name, MeasureUnit unit, double value, double reference);

}  // namespace slipbench::driver::check
