// SPDX-License-Identifier: Apache-2.0
// The triangle of a tall matrix and its right-hand side, without squaring its condition.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace slipbench::driver::fit {

/// min |A x - b|: R of A = Q R, Q^T b, and what of b is left over.
struct TallQr {
  Eigen::MatrixXd triangle;    ///< R, columns x columns
  Eigen::VectorXd projection;  ///< the first entries of Q^T b
  double rest = 0.0;           ///< |b - Q Q^T b|
};

/// Householder QR of `matrix`, row-major rows x columns, rows >= 1, beside `side`. Goes through the
/// rows in blocks, carrying only the triangle: one pass over the memory, no copy of the matrix.
TallQr tall_qr(std::span<const double> matrix, std::size_t columns, std::span<const double> side);

}  // namespace slipbench::driver::fit
