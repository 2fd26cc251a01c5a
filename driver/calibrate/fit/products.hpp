// SPDX-License-Identifier: Apache-2.0
// Products of the columns of a tall matrix: all that a step needs of thousands of rows.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "driver/calibrate/fit/tall_qr.hpp"

namespace slipbench::driver::fit {

/// [A b]^T W^2 [A b], (columns + 1) squared, of a row-major A with as many rows as b; one pass.
/// \param root_weights the diagonal of W; empty for ones
Eigen::MatrixXd products(std::span<const double> matrix, std::size_t columns,
                         std::span<const double> side, std::span<const double> root_weights = {});

/// Returns what tall_qr gives of A and b, from their products (Cholesky, columns of unit length).
/// Products square the condition: none where that would cost more than half of the digits, or where
/// the rank is not full.
std::optional<TallQr> triangle_of(const Eigen::MatrixXd& products);

/// R of a row-major A, whichever way is the faster one that keeps the digits.
Eigen::MatrixXd triangle_of(std::span<const double> matrix, std::size_t columns, std::size_t rows);

}  // namespace slipbench::driver::fit
