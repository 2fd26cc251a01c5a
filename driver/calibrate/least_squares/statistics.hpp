// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "driver/calibrate/least_squares/problem.hpp"

namespace slipbench::driver {

/// How well the unknowns of a fit are known. NaN where an unknown is not identifiable, not even by
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
/// log-scaled unknowns are symmetric in the logarithm. (docs/theory.md, section 17.)
FitStatistics fit_statistics(const ResidualProblem& problem, const LeastSquaresFit& fit,
                             double confidence);

/// Bootstrap of the residuals: each resampling draws residuals with replacement (in blocks, since
/// neighbours in time are alike; twice the lag at which their autocorrelation is lost in noise),
/// centred and enlarged by sqrt(data/(data - unknowns)), adds them to the fitted model, and fits
/// again from the optimum.
struct Bootstrap {
  int wanted = 0;
  int done = 0;  ///< those that converged
  std::size_t block = 1;
  std::vector<double> standard_error;
  std::vector<double> lower;  ///< percentile interval
  std::vector<double> upper;
};
Bootstrap bootstrap(const ResidualProblem& problem, const LeastSquaresFit& fit, int resamplings,
                    double confidence, std::uint64_t seed);

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
};
LikelihoodProfile profile_likelihood(const ResidualProblem& problem, const LeastSquaresFit& fit,
                                     std::size_t unknown, double confidence);

}  // namespace slipbench::driver
