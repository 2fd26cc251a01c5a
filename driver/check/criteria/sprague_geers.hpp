// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The errors of magnitude and phase of Sprague and Geers over the common range of the abscissa
/// (time, or anything else that does not turn):
///
///     M = sqrt(Int f^2 / Int r^2) - 1,  P = acos(Int f r / sqrt(Int f^2 Int r^2)) / pi,
///     C = sqrt(M^2 + P^2)
///
/// with f the result and r the reference (M. A. Sprague, T. L. Geers: A spectral-element method for
/// modelling cavitation in transient fluid-structure interaction, Int. J. Numer. Meth. Engng 60,
/// 2004, 2467-2499). Both curves are taken as linear between their rows, and the integrals of
/// their products are exact, so the rows' distances do not matter.
///
/// Measures, all dimensionless: "comprehensive error" C with the tolerance (the larger of absolute
/// and relative, scale 1), "magnitude error" M and "phase error" P, only reported.
/// Faults: an abscissa that turns, no common range, a number that is not finite, a reference that
/// is zero throughout. A result that is zero throughout has M = -1 and P = 1/2 (the cosine of the
/// phase is taken as 0 there), that is, it fails.
CurveComparison compare_sprague_geers(const Series& result, const Series& reference,
                                      const cases::Tolerance& tolerance);

}  // namespace slipbench::driver::check
