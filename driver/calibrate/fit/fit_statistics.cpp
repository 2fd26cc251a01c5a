// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_cdf.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/calibrate/fit/error_scale.hpp"
#include "driver/calibrate/fit/products.hpp"
#include "driver/calibrate/fit/statistics.hpp"

namespace slipbench::driver::fit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Singular values and vectors of a Jacobian with columns of unit length.
struct ScaledSvd {
  Eigen::VectorXd length;  ///< of the columns; 1 for those that are zero
  Eigen::VectorXd value;
  Eigen::MatrixXd vector;
  std::vector<char> seen;  ///< no invisible combination contains the column
};

ScaledSvd scaled_svd(std::span<const double> matrix, std::size_t columns, std::size_t rows,
                     double threshold) {
  Eigen::MatrixXd triangle = triangle_of(matrix, columns, rows);
  ScaledSvd result;
  result.length = triangle.colwise().norm();
  for (Eigen::Index j = 0; j < triangle.cols(); ++j) {
    if (!(result.length(j) > 0.0)) result.length(j) = 1.0;
    triangle.col(j) /= result.length(j);
  }
  // Divides and conquers: the method of Jacobi took over 20 s with a thousand columns.
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
  result.value = svd.singularValues();
  result.vector = svd.matrixV();
  result.seen.assign(columns, 1);
  constexpr double kPart = 1e-3;  // of an invisible combination
  for (Eigen::Index i = 0; i < result.value.size(); ++i) {
    if (result.value(i) > threshold * result.value(0)) continue;
    for (std::size_t j = 0; j < columns; ++j) {
      if (std::abs(result.vector(static_cast<Eigen::Index>(j), i)) > kPart) result.seen[j] = 0;
    }
  }
  return result;
}

}  // namespace

FitStatistics fit_statistics(const ResidualProblem& problem, const LeastSquaresFit& fit,
                             double confidence) {
  const std::size_t n = problem.unknowns.size();
  FitStatistics statistics;
  statistics.data = problem.data_rows;
  statistics.deviation = kNan;
  statistics.condition = kNan;
  statistics.standard_error.assign(n, kNan);
  statistics.lower.assign(n, kNan);
  statistics.upper.assign(n, kNan);
  statistics.covariance.assign(n * n, kNan);
  statistics.correlation.assign(n * n, kNan);
  statistics.identifiable.assign(n, 0);
  std::vector<std::size_t> free;
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.frozen[j] == 0) free.push_back(j);
  }
  statistics.unknowns = free.size();
  if (free.empty() || fit.jacobian.size() != problem.rows * n || problem.data_rows == 0 ||
      fit.residuals.size() != problem.rows || fit.stop == StopReason::kModelFailure) {
    return statistics;
  }

  const ErrorScale scale = error_scale(problem, fit, effective_unknowns(problem, fit));
  statistics.deviation = std::sqrt(scale.variance);
  const double root = std::sqrt(scale.curvature);
  const std::size_t m = free.size();
  std::vector<double> weighted;
  std::span<const double> rows = fit.jacobian;
  if (m < n || root != 1.0) {
    weighted.resize(problem.rows * m);
    for (std::size_t i = 0; i < problem.rows; ++i) {
      const double weight = i < problem.data_rows ? root : 1.0;
      for (std::size_t c = 0; c < m; ++c) {
        weighted[i * m + c] = weight * fit.jacobian[i * n + free[c]];
      }
    }
    rows = weighted;
  }
  // What differences cannot tell from zero is larger than what exact derivatives cannot.
  const double threshold = problem.derivatives ? problem.derivative_accuracy : 1e-9;
  const ScaledSvd all = scaled_svd(rows, m, problem.rows, threshold);
  std::vector<char> identifiable = all.seen;
  if (problem.data_rows < problem.rows) {
    identifiable =
        scaled_svd(rows.first(problem.data_rows * m), m, problem.data_rows, threshold).seen;
  }
  const double least = all.value.minCoeff();
  statistics.condition =
      least > 0.0 ? all.value(0) / least : std::numeric_limits<double>::infinity();

  Eigen::MatrixXd inverse = all.vector;  // V/sigma, of what is visible
  for (Eigen::Index i = 0; i < all.value.size(); ++i) {
    const bool visible = all.value(i) > threshold * all.value(0);
    inverse.col(i) *= visible ? 1.0 / all.value(i) : 0.0;
  }
  inverse = all.length.cwiseInverse().asDiagonal() * inverse;
  const Eigen::MatrixXd covariance =
      scale.variance * scale.curvature * (inverse * inverse.transpose());
  const double quantile =
      scale.freedom > 0.0 ? gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, scale.freedom) : kNan;
  for (std::size_t c = 0; c < m; ++c) {
    const std::size_t j = free[c];
    statistics.identifiable[j] = identifiable[c];
    if (all.seen[c] == 0) continue;
    const auto at = static_cast<Eigen::Index>(c);
    const double error = std::sqrt(covariance(at, at));
    statistics.standard_error[j] = error;
    const UnknownRange& range = problem.unknowns[j];
    const double x = fit.x[j];
    if (range.scale == Scale::kLog) {
      const double factor = std::exp(quantile * error / x);
      statistics.lower[j] = x / factor;
      statistics.upper[j] = x * factor;
    } else {
      statistics.lower[j] = x - quantile * error;
      statistics.upper[j] = x + quantile * error;
    }
    statistics.lower[j] = std::max(statistics.lower[j], range.lower);
    statistics.upper[j] = std::min(statistics.upper[j], range.upper);
    for (std::size_t d = 0; d < m; ++d) {
      if (all.seen[d] == 0) continue;
      const auto other = static_cast<Eigen::Index>(d);
      const double product = std::sqrt(covariance(at, at) * covariance(other, other));
      statistics.covariance[j * n + free[d]] = covariance(at, other);
      statistics.correlation[j * n + free[d]] = c == d          ? 1.0
                                                : product > 0.0 ? covariance(at, other) / product
                                                                : 0.0;
    }
  }
  return statistics;
}

}  // namespace slipbench::driver::fit
