// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/convex_step.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace slipbench::driver::fit {
namespace {

/// The least of |matrix u - target| with u >= 0 (Lawson and Hanson's active set).
Eigen::VectorXd non_negative(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& target) {
  const Eigen::Index m = matrix.cols();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(m);
  std::vector<Eigen::Index> active;
  std::vector<char> is_active(static_cast<std::size_t>(m), 0);
  for (Eigen::Index round = 0; round < 3 * m; ++round) {
    const Eigen::VectorXd slope = matrix.transpose() * (target - matrix * u);
    Eigen::Index steepest = -1;
    for (Eigen::Index i = 0; i < m; ++i) {
      if (is_active[static_cast<std::size_t>(i)] != 0 || !(slope(i) > 0.0)) continue;
      if (steepest < 0 || slope(i) > slope(steepest)) steepest = i;
    }
    if (steepest < 0) break;
    active.push_back(steepest);
    is_active[static_cast<std::size_t>(steepest)] = 1;
    while (!active.empty()) {
      Eigen::MatrixXd columns(matrix.rows(), static_cast<Eigen::Index>(active.size()));
      for (std::size_t i = 0; i < active.size(); ++i) {
        columns.col(static_cast<Eigen::Index>(i)) = matrix.col(active[i]);
      }
      const Eigen::VectorXd best = columns.colPivHouseholderQr().solve(target);
      if (best.minCoeff() > 0.0) {
        u.setZero();
        for (std::size_t i = 0; i < active.size(); ++i) {
          u(active[i]) = best(static_cast<Eigen::Index>(i));
        }
        break;
      }
      // As far as the first one becomes zero, which leaves the set.
      double part = 1.0;
      for (std::size_t i = 0; i < active.size(); ++i) {
        const double wanted = best(static_cast<Eigen::Index>(i));
        const double now = u(active[i]);
        if (wanted <= 0.0) part = std::min(part, now > 0.0 ? now / (now - wanted) : 0.0);
      }
      std::vector<Eigen::Index> left;
      for (std::size_t i = 0; i < active.size(); ++i) {
        double& now = u(active[i]);
        const double wanted = best(static_cast<Eigen::Index>(i));
        now += part * (wanted - now);
        const bool leaves = wanted <= 0.0 && now <= 1e-14 * u.cwiseAbs().maxCoeff();
        if (!leaves) {
          left.push_back(active[i]);
          continue;
        }
        now = 0.0;
        is_active[static_cast<std::size_t>(active[i])] = 0;
      }
      if (left.size() == active.size()) break;
      active = std::move(left);
    }
  }
  return u;
}

}  // namespace

ConvexStep convex_step(const Eigen::MatrixXd& products, std::span<const double> x,
                       std::span<const Inequality> inequalities) {
  // Invisible combinations stay where they are.
  constexpr double kRidge = 1e-11;
  const Eigen::Index n = products.cols() - 1;
  ConvexStep step{Eigen::VectorXd::Zero(n), 0.0};
  Eigen::VectorXd size = products.diagonal().head(n).cwiseSqrt();
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!(size(j) > 0.0)) size(j) = 1.0;
  }
  const Eigen::VectorXd per = size.cwiseInverse();
  const Eigen::MatrixXd squares = products.topLeftCorner(n, n);
  const Eigen::VectorXd slope = products.topRightCorner(n, 1);
  Eigen::MatrixXd scaled = per.asDiagonal() * squares * per.asDiagonal();
  scaled.diagonal().array() += kRidge;
  const Eigen::LLT<Eigen::MatrixXd> factors(scaled);
  if (factors.info() != Eigen::Success) return step;
  // |R d + q|, the d in units of `per`; y = R d + q is to be short.
  Eigen::VectorXd q = per.cwiseProduct(slope);
  factors.matrixL().solveInPlace(q);
  const double unit = q.norm();
  if (!(unit > 0.0)) return step;
  const auto m = static_cast<Eigen::Index>(inequalities.size());
  Eigen::MatrixXd matrix(n + 1, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Inequality& row = inequalities[static_cast<std::size_t>(i)];
    Eigen::VectorXd normal = Eigen::VectorXd::Zero(n);
    double value = 0.0;
    for (const auto& [j, factor] : row.terms) {
      normal(static_cast<Eigen::Index>(j)) = factor * per(static_cast<Eigen::Index>(j));
      value += factor * x[j];
    }
    factors.matrixL().solveInPlace(normal);
    const double length = normal.norm();
    const double room = std::min(row.least - value, 0.0);  // x is taken to keep it
    matrix.col(i).head(n) = normal / length;
    matrix(n, i) = (room / length + matrix.col(i).head(n).dot(q)) / unit;
  }
  const Eigen::VectorXd target = Eigen::VectorXd::Unit(n + 1, n);
  const Eigen::VectorXd rest = matrix * non_negative(matrix, target) - target;
  if (!(rest(n) < 0.0)) return step;
  Eigen::VectorXd change = rest.head(n) * (-unit / rest(n)) - q;
  factors.matrixU().solveInPlace(change);
  step.change = per.cwiseProduct(change);
  const double fall = -slope.dot(step.change) - 0.5 * step.change.dot(squares * step.change);
  step.gain = std::max(fall, 0.0);
  return step;
}

}  // namespace slipbench::driver::fit
