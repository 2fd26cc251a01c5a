// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// Factors that turn the linearised problem into errors: covariance = s^2 a (a G^T G + H^T H)^-1, G
/// the data rows of dr/dx, H the others.
///
/// Squares: a = 1, s^2 = sum r^2/(data - p). Robust losses: Huber's estimate with psi = rho' r, a
/// the mean of psi' over the data, and s^2 = K^2 sum psi^2/(data - p)/a^2, K = 1 + p/data var(psi')
/// /a^2. p counts the unknowns that the data determine: trace((G^T G + H^T H)^-1 G^T G).
/// Source: Huber, Robust Statistics, 1981, section 7.6.
struct ErrorScale {
  double variance;   ///< s^2; NaN without degrees of freedom
  double curvature;  ///< a
  double freedom;    ///< data - p
};

/// \param effective p
ErrorScale error_scale(const ResidualProblem& problem, const LeastSquaresFit& fit,
                       double effective);

/// p of a fit.
double effective_unknowns(const ResidualProblem& problem, const LeastSquaresFit& fit);

/// Returns what each data row has in p: the diagonal of G (G^T G + H^T H)^-1 G^T, in [0, 1].
std::vector<double> leverages(const ResidualProblem& problem, const LeastSquaresFit& fit);

/// Tells whether a refit ended where its cost is least, or within 0.01 standard errors of it by its
/// gradient: nothing can be gained where it began at its minimum.
/// \param effective p
/// \param freedom data - p
bool is_minimum(const LeastSquaresFit& refit, double effective, double freedom);

}  // namespace slipbench::driver::fit
