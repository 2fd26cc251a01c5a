// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The integral of q dx over what the curves have in common, with its sign: one measure
/// [quantity x abscissa], which `tolerance.absolute` bounds in the same unit; a relative tolerance
/// is relative to the integral of |q dx| of the reference. Trapezoids between the rows of each
/// curve, second order.
/// Back and forth branch by branch as for points, so curves of different branches are a fault.
CurveComparison compare_area(const Series& result, const Series& reference,
                             const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
