// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/case/criterion.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver {

/// Holds a result against a reference by a criterion. Every criterion refuses empty curves, numbers
/// that are not finite and curves without a common range with a fault in words; none depends on how
/// either curve is sampled but for the errors its own header names, and none on the units.
/// Of kPointwise it gives the worst point as one measure; compare_points gives all of them.
CurveComparison compare(Criterion criterion, const Series& result, const Series& reference,
                        const Tolerance& tolerance);

}  // namespace slipbench::driver
