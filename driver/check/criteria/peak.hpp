// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The largest and the smallest value of each curve over the common range of the abscissa, ends
/// interpolated: two measures [quantity], each with where the result has it. A peak that falls
/// between rows is missed by the error of sampling.
CurveComparison compare_peak(const Series& result, const Series& reference,
                             const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
