// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The mean of each curve over the common range of the abscissa, the integral of q |dx| over that
/// of |dx|: one measure [quantity]. Trapezoids, second order. Which rows belong to the plateau,
/// the check says with `step` and `over`.
/// A common range that is only one point is a fault.
CurveComparison compare_plateau(const Series& result, const Series& reference,
                                const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
