// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The points where the abscissa turns: their number, which must be equal, and if it is, of each
/// its position [abscissa], which `tolerance.abscissa` bounds, and the value there [quantity].
/// Scales are the ranges of the reference. After a dwell the value is that of its end. Positions
/// are those of rows: a turn between rows is missed by the error of sampling.
/// A reference without reversals is a fault.
CurveComparison compare_reversals(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
