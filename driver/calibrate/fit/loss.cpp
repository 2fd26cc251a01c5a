// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/loss.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::driver::fit {

double loss_value(const Loss& loss, double residual) {
  const double t = loss.threshold;
  const double magnitude = std::abs(residual);
  switch (loss.kind) {
    case Loss::Kind::kHuber:
      return magnitude <= t ? residual * residual : t * (2.0 * magnitude - t);
    case Loss::Kind::kSoftL1: {
      // 2 t^2 (sqrt(1 + q) - 1), written so that small q keeps its digits
      const double q = (residual / t) * (residual / t);
      return 2.0 * residual * residual / (std::sqrt(1.0 + q) + 1.0);
    }
    case Loss::Kind::kSquares:
      break;
  }
  return residual * residual;
}

double loss_weight(const Loss& loss, double residual) {
  const double t = loss.threshold;
  switch (loss.kind) {
    case Loss::Kind::kHuber:
      return std::abs(residual) <= t ? 1.0 : t / std::abs(residual);
    case Loss::Kind::kSoftL1:
      return 1.0 / std::hypot(1.0, residual / t);
    case Loss::Kind::kSquares:
      break;
  }
  return 1.0;
}

double loss_curvature(const Loss& loss, double residual) {
  switch (loss.kind) {
    case Loss::Kind::kHuber:
      return std::abs(residual) <= loss.threshold ? 1.0 : 0.0;
    case Loss::Kind::kSoftL1: {
      const double weight = loss_weight(loss, residual);
      return weight * weight * weight;
    }
    case Loss::Kind::kSquares:
      break;
  }
  return 1.0;
}

double total_cost(const ResidualProblem& problem, std::span<const double> residuals) {
  double sum = 0.0;
  if (problem.loss.kind == Loss::Kind::kSquares) {
    for (const double r : residuals) sum += r * r;
    return 0.5 * sum;
  }
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    sum += i < problem.data_rows ? loss_value(problem.loss, residuals[i])
                                 : residuals[i] * residuals[i];
  }
  return 0.5 * sum;
}

std::vector<double> row_weights(const ResidualProblem& problem, std::span<const double> residuals) {
  std::vector<double> weights(residuals.size(), 1.0);
  if (problem.loss.kind == Loss::Kind::kSquares) return weights;
  const std::size_t data = std::min(problem.data_rows, residuals.size());
  for (std::size_t i = 0; i < data; ++i) weights[i] = loss_weight(problem.loss, residuals[i]);
  return weights;
}

}  // namespace slipbench::driver::fit
