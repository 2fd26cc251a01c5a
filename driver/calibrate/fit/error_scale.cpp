// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/error_scale.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit/products.hpp"

namespace slipbench::driver::fit {

ErrorScale error_scale(const ResidualProblem& problem, const LeastSquaresFit& fit,
                       double effective) {
  const auto data = static_cast<double>(problem.data_rows);
  const double freedom = data - effective;
  double squares = 0.0;
  double curvature = 0.0;
  double curvature_squares = 0.0;
  for (std::size_t i = 0; i < problem.data_rows; ++i) {
    const double r = fit.residuals[i];
    const double psi = loss_weight(problem.loss, r) * r;
    const double slope = loss_curvature(problem.loss, r);
    squares += psi * psi;
    curvature += slope;
    curvature_squares += slope * slope;
  }
  const double mean = curvature / data;
  if (!(freedom > 0.0) || !(mean > 0.0)) {
    return {std::numeric_limits<double>::quiet_NaN(), 1.0, freedom};
  }
  if (problem.loss.kind == Loss::Kind::kSquares) return {squares / freedom, 1.0, freedom};
  const double spread = curvature_squares / data / (mean * mean) - 1.0;
  const double correction = 1.0 + effective / data * spread;
  return {correction * correction * squares / freedom / (mean * mean), mean, freedom};
}

double effective_unknowns(const ResidualProblem& problem, const LeastSquaresFit& fit) {
  const std::size_t n = problem.unknowns.size();
  std::vector<std::size_t> seen;
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.frozen[j] == 0) seen.push_back(j);
  }
  if (problem.rows == problem.data_rows) return static_cast<double>(seen.size());
  // The smoothness rows share in determining the unknowns: trace of the data's part.
  std::vector<double> all(problem.rows * seen.size());
  for (std::size_t i = 0; i < problem.rows; ++i) {
    for (std::size_t c = 0; c < seen.size(); ++c) {
      all[i * seen.size() + c] = fit.jacobian[i * n + seen[c]];
    }
  }
  const std::size_t data_entries = problem.data_rows * seen.size();
  const Eigen::MatrixXd whole = triangle_of(all, seen.size(), problem.rows);
  const Eigen::MatrixXd data =
      triangle_of({all.data(), data_entries}, seen.size(), problem.data_rows);
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse(whole.transpose());
  return inverse.solve(data.transpose()).squaredNorm();
}

std::vector<double> leverages(const ResidualProblem& problem, const LeastSquaresFit& fit) {
  const std::size_t n = problem.unknowns.size();
  std::vector<std::size_t> seen;
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.frozen[j] == 0) seen.push_back(j);
  }
  std::vector<double> all(problem.rows * seen.size());
  for (std::size_t i = 0; i < problem.rows; ++i) {
    for (std::size_t c = 0; c < seen.size(); ++c) {
      all[i * seen.size() + c] = fit.jacobian[i * n + seen[c]];
    }
  }
  std::vector<double> result(problem.data_rows, 0.0);
  if (seen.empty()) return result;
  // Columns of unit length first: of what units the unknowns are must not decide the rank.
  Eigen::MatrixXd whole = triangle_of(all, seen.size(), problem.rows);
  Eigen::VectorXd length = whole.colwise().norm();
  for (Eigen::Index j = 0; j < length.size(); ++j) {
    if (!(length(j) > 0.0)) length(j) = 1.0;
    whole.col(j) /= length(j);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse;
  inverse.setThreshold(problem.derivatives ? problem.derivative_accuracy : 1e-9);
  inverse.compute(whole.transpose());
  const Eigen::MatrixXd solver = inverse.pseudoInverse();
  Eigen::VectorXd row(length.size());
  for (std::size_t i = 0; i < problem.data_rows; ++i) {
    for (Eigen::Index c = 0; c < row.size(); ++c) {
      row(c) = all[i * seen.size() + static_cast<std::size_t>(c)] / length(c);
    }
    result[i] = std::min((solver * row).squaredNorm(), 1.0);
  }
  return result;
}

bool is_minimum(const LeastSquaresFit& refit, double effective, double freedom) {
  constexpr double kMostLeft = 0.01;  // of a standard error
  if (refit.converged) return true;
  if (refit.stop == StopReason::kModelFailure) return false;
  return refit.gradient_norm * std::sqrt(freedom / std::max(effective, 1.0)) <= kMostLeft;
}

}  // namespace slipbench::driver::fit
