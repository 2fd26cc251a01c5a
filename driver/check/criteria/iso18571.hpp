// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The objective rating of ISO/TS 18571 (2014, 2nd edition 2024) over the common range of the
/// abscissa (time, or anything else that does not turn), with the constants of ISO/TS 18571:
///
///     R = 0.4 Z + 0.2 E_P + 0.2 E_M + 0.2 E_S
///
/// - corridor Z: mean of 1 within 0.05 T of the reference, 0 beyond 0.5 T, and the square of the
///   distance to the outer corridor over the corridors' distance between; T = max |reference|;
/// - phase E_P: 1 - n/(0.2 N), with n <= 0.2 N the shift at which the parts of both curves that
///   still overlap correlate best; of equal correlations (to 1e-12) the smallest shift;
/// - magnitude E_M: 1 - e/0.5, e = sum |f - r| / sum |r| along the path of dynamic time warping of
///   the shifted and truncated curves: squared differences, steps of weight one, a window of 10 %;
/// - slope E_S: 1 - e/2, e = sum |f' - r'| / sum |r'|, the derivatives by central differences and
///   their moving mean over 9 points, fewer at the ends, again of the shifted, truncated curves.
///
/// ISO/TS 18571 samples crash signals at 10 kHz. Here the common range is divided into N =
/// 1000 equal parts, a signal of 100 ms at this rate, and each is represented by the curve's mean
/// over it: the rows' distances do not matter, nor do jumps between or on the samples. Where
/// several warping paths cost the same (to 1e-12 T^2) the shortest is taken, so that a plateau
/// counts once.
///
/// Measures, dimensionless but for the last: "rating" R, whose deviation 1 - R the tolerance bounds
/// (the larger of absolute and relative, scale 1); "corridor score", "phase score", "magnitude
/// score", "slope score" and "delay" [abscissa] (positive if the result is the one that comes at
/// larger abscissas, that is, late), only reported. Equal curves have R = 1 exactly. Faults: an
/// abscissa that turns, no common range, a number that is not finite, a reference that is constant
/// (range below 1e-9 of its magnitude): neither phase nor slope have a meaning. A result that
/// correlates at no shift, since it is constant, has E_P = 0.
CurveComparison compare_iso18571(const Series& result, const Series& reference,
                                 const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
