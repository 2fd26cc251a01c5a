// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/products.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace slipbench::driver::fit {
namespace {

constexpr std::size_t kTogether = 4;  // rows for each time that a sum is fetched and stored
constexpr std::size_t kLanes = 4;     // rows of sums are worked on in whole blocks

/// Adds the products of the columns of some rows to the lower triangle of `sums`; what lies beside
/// it in the blocks of the diagonal is filled as well. The same sums in the same order on any
/// machine: wider registers take more columns at once, and nothing is fused.
[[gnu::always_inline]] inline void add_products(const double* __restrict rows, std::size_t columns,
                                                std::size_t stride, double* __restrict sums) {
  const double* a = rows;
  const double* b = a + stride;
  const double* c = b + stride;
  const double* d = c + stride;
  for (std::size_t i = 0; i < columns; ++i) {
    double* sum = sums + i * stride;
    const double ai = a[i];
    const double bi = b[i];
    const double ci = c[i];
    const double di = d[i];
    for (std::size_t first = 0; first <= i; first += kLanes) {
      for (std::size_t j = first; j < first + kLanes; ++j) {
        sum[j] += (ai * a[j] + bi * b[j]) + (ci * c[j] + di * d[j]);
      }
    }
  }
}

using AddProducts = void (*)(const double*, std::size_t, std::size_t, double*);

void add_products_anywhere(const double* rows, std::size_t columns, std::size_t stride,
                           double* sums) {
  add_products(rows, columns, stride, sums);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void add_products_avx2(const double* rows, std::size_t columns,
                                               std::size_t stride, double* sums) {
  add_products(rows, columns, stride, sums);
}
AddProducts fastest() {
  return __builtin_cpu_supports("avx2") ? add_products_avx2 : add_products_anywhere;
}
#else
AddProducts fastest() { return add_products_anywhere; }
#endif

}  // namespace

Eigen::MatrixXd products(std::span<const double> matrix, std::size_t columns,
                         std::span<const double> side, std::span<const double> root_weights) {
  const std::size_t n = columns + 1;
  const std::size_t stride = (n + kLanes - 1) / kLanes * kLanes;
  const std::size_t rows = side.size();
  const AddProducts add = fastest();
  std::vector<double> sums(n * stride, 0.0);
  std::vector<double> block(kTogether * stride, 0.0);
  for (std::size_t first = 0; first < rows; first += kTogether) {
    const std::size_t count = std::min(kTogether, rows - first);
    if (count < kTogether) std::fill(block.begin(), block.end(), 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t row = first + k;
      const double weight = root_weights.empty() ? 1.0 : root_weights[row];
      const double* from = matrix.data() + row * columns;
      double* to = block.data() + k * stride;
      for (std::size_t j = 0; j < columns; ++j) to[j] = weight * from[j];
      to[columns] = weight * side[row];
    }
    add(block.data(), n, stride, sums.data());
  }
  Eigen::MatrixXd result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row = static_cast<Eigen::Index>(i);
      const auto column = static_cast<Eigen::Index>(j);
      result(row, column) = result(column, row) = sums[i * stride + j];
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

}  // namespace slipbench::driver::fit
