// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/least_squares/products.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace slipbench::driver {

Eigen::MatrixXd products(std::span<const double> matrix, std::size_t columns,
                         std::span<const double> side, std::span<const double> root_weights) {
  constexpr std::size_t kTogether = 4;  // rows for each time that a sum is fetched and stored
  const std::size_t n = columns + 1;
  const std::size_t rows = side.size();
  std::vector<double> sums(n * n, 0.0);
  std::vector<double> block(kTogether * n);
  for (std::size_t first = 0; first < rows; first += kTogether) {
    const std::size_t count = std::min(kTogether, rows - first);
    if (count < kTogether) std::fill(block.begin(), block.end(), 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t row = first + k;
      const double weight = root_weights.empty() ? 1.0 : root_weights[row];
      const double* from = matrix.data() + row * columns;
      double* to = block.data() + k * n;
      for (std::size_t j = 0; j < columns; ++j) to[j] = weight * from[j];
      to[columns] = weight * side[row];
    }
    const double* a = block.data();
    const double* b = a + n;
    const double* c = b + n;
    const double* d = c + n;
    for (std::size_t i = 0; i < n; ++i) {
      double* sum = sums.data() + i * n;
      const double ai = a[i];
      const double bi = b[i];
      const double ci = c[i];
      const double di = d[i];
      for (std::size_t j = 0; j <= i; ++j) {
        sum[j] += (ai * a[j] + bi * b[j]) + (ci * c[j] + di * d[j]);
      }
    }
  }
  Eigen::MatrixXd result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row = static_cast<Eigen::Index>(i);
      const auto column = static_cast<Eigen::Index>(j);
      result(row, column) = result(column, row) = sums[i * n + j];
    }
  }
  return result;
}

std::optional<TallQr> triangle_of(const Eigen::MatrixXd& products) {
  constexpr double kLeastReciprocalCondition = 1e-8;
  const Eigen::Index n = products.cols() - 1;
  if (n == 0) return std::nullopt;
  const Eigen::VectorXd length = products.diagonal().head(n).cwiseSqrt();
  if (!(length.minCoeff() > 0.0) || !std::isfinite(length.sum())) return std::nullopt;
  const auto unit = length.cwiseInverse().asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> cholesky(unit * products.topLeftCorner(n, n) * unit);
  if (cholesky.info() != Eigen::Success || cholesky.rcond() < kLeastReciprocalCondition) {
    return std::nullopt;
  }
  TallQr result;
  result.projection = cholesky.matrixL().solve(unit * products.col(n).head(n));
  result.triangle = Eigen::MatrixXd(cholesky.matrixU()) * length.asDiagonal();
  result.rest = std::sqrt(std::max(products(n, n) - result.projection.squaredNorm(), 0.0));
  return result;
}

Eigen::MatrixXd triangle_of(std::span<const double> matrix, std::size_t columns, std::size_t rows) {
  const std::vector<double> nothing(rows, 0.0);
  const std::optional<TallQr> fast = triangle_of(products(matrix, columns, nothing));
  return fast ? fast->triangle : tall_qr(matrix, columns, nothing).triangle;
}

}  // namespace slipbench::driver
