// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// Errors of the unknowns of a fit. NaN where an unknown is not identifiable, not even by
/// the rows that are no data (smoothness). Bounds and shapes are looked through: errors are those
/// of the unknowns as if they could move; intervals end at the bounds.
struct FitStatistics {
  std::size_t data = 0;      ///< rows compared
  std::size_t unknowns = 0;  ///< that are not frozen
  /// Residual standard deviation s: s^2 = 2 cost/(data - unknowns) over the data, where the
  /// unknowns count as far as data and not smoothness determine them; Huber's estimate for robust
  /// losses.
  double deviation = 0.0;
  std::vector<double> standard_error;  ///< of each unknown, natural unit
  std::vector<double> lower;           ///< confidence interval
  std::vector<double> upper;
  std::vector<double> covariance;   ///< unknowns x unknowns, row-major
  std::vector<double> correlation;  ///< likewise
  std::vector<char> identifiable;   ///< 0: the data do not see it, alone or in a combination
  double condition = 0.0;           ///< of the Jacobian with columns of unit length, all rows
};

/// Covariance s^2 (J^T W J)^-1 of the linearised problem, with intervals by Student's t; those of
/// log-scaled unknowns are symmetric in the logarithm. (docs/theory, section 17.)
FitStatistics fit_statistics(const ResidualProblem& problem, const LeastSquaresFit& fit,
                             double confidence);

/// Bootstrap of the residuals: each resampling draws residuals with replacement, centred and
/// enlarged by sqrt(data/(data - unknowns)) of their response, adds them to the fitted model, and
/// fits again from the optimum. Residuals of a response stay in it (those of less than 10 points
/// draw from all data), in circular blocks, since neighbours in time are alike: of the length by
/// Politis and White, at most 3 sqrt(points) and a quarter of the points.
/// Nothing is drawn without degrees of freedom.
struct Bootstrap {
  int wanted = 0;
  int done = 0;           ///< those that ended at a minimum
  std::size_t block = 1;  ///< the longest of all responses
  std::vector<double> standard_error;
  /// Percentile interval, its distances from the unknown enlarged from the normal distribution to
  /// Student's t, whose freedom is that of the data or the number of blocks less one.
  std::vector<double> lower;
  std::vector<double> upper;
  /// The residuals hang together over so many points that few blocks are left, or shorter ones than
  /// they should be: errors are too small.
  bool few_blocks = false;
};
Bootstrap bootstrap(const ResidualProblem& problem, const LeastSquaresFit& fit, int resamplings,
                    double confidence, std::uint64_t seed);

/// Length of the circular blocks for residuals, not yet rounded and without a cap, >= 1:
/// (3 G^2 n / (2 g^2))^(1/3) with g = sum R(k) and G = sum |k| R(k) of the autocovariances R
/// through a flat-topped window. Source: Politis and White, Automatic block-length selection for
/// the dependent bootstrap, 2004, as corrected by Patton, Politis and White 2009.
double block_length(std::span<const double> residuals);

/// The cost along one unknown, all others fitted again at every value. The ordinates of a shaped
/// block keep their shape among themselves, without the fixed one.
struct LikelihoodProfile {
  std::size_t unknown = 0;
  std::vector<double> value;  ///< ascending, the optimum among them
  std::vector<double> cost;
  double threshold = 0.0;  ///< cost at the ends of the interval
  double lower = 0.0;      ///< where it is crossed; -infinity or the bound if it never is
  double upper = 0.0;
  bool open_below = false;  ///< not crossed: the data do not bound it
  bool open_above = false;
  int refits = 0;       ///< of the other unknowns
  int unconverged = 0;  ///< of those: their costs are too high, and the interval may be too narrow
};
/// Threshold, lower and upper are NaN, and nothing is open, without degrees of freedom or if the
/// unknown is frozen.
LikelihoodProfile profile_likelihood(const ResidualProblem& problem, const LeastSquaresFit& fit,
                                     std::size_t unknown, double confidence);

/// A profile as numbers, which programs give each other, and back.
std::vector<double> numbers_of(const LikelihoodProfile& profile);
LikelihoodProfile profile_of(std::span<const double> numbers);

}  // namespace slipbench::driver::fit
