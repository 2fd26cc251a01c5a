// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/tall_qr.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace slipbench::driver::fit {

TallQr tall_qr(std::span<const double> matrix, std::size_t columns, std::span<const double> side) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(columns);
  const auto rows = static_cast<Eigen::Index>(side.size());
  const Eigen::Map<const RowMajor> a(matrix.data(), rows, n);
  const Eigen::Map<const Eigen::VectorXd> b(side.data(), rows);
  const Eigen::Index block = std::max<Eigen::Index>(256, 4 * n);

  // The last column is the right-hand side.
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::MatrixXd work;
  for (Eigen::Index first = 0; first < rows; first += block) {
    const Eigen::Index count = std::min(block, rows - first);
    work.resize(n + 1 + count, n + 1);
    work.topRows(n + 1) = triangle;
    work.bottomLeftCorner(count, n) = a.middleRows(first, count);
    work.bottomRightCorner(count, 1) = b.segment(first, count);
    const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(work);
    triangle = qr.matrixQR().topRows(n + 1).triangularView<Eigen::Upper>();
  }
  return {triangle.topLeftCorner(n, n), triangle.topRightCorner(n, 1), std::abs(triangle(n, n))};
}

}  // namespace slipbench::driver::fit
