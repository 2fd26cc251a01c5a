// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/objective.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "driver/calibrate/fit/loss.hpp"
#include "driver/calibrate/fit/products.hpp"
#include "driver/calibrate/fit/tall_qr.hpp"

namespace slipbench::driver::fit {
namespace {

/// Columns shorter than this part of the longest are invisible combinations.
constexpr double kRankThreshold = 1e-12;

struct ScaledSolution {
  Eigen::VectorXd step;
  double projected = 0.0;  ///< length of the part of the right-hand side in the range
  std::size_t rank = 0;
};

/// The step that leaves least of R step + projection, shortest in scaled columns.
ScaledSolution solve(const TallQr& qr) {
  const Eigen::Index n = qr.triangle.cols();
  ScaledSolution solution;
  solution.step = Eigen::VectorXd::Zero(n);
  if (n == 0) return solution;
  Eigen::VectorXd length = qr.triangle.colwise().norm();
  for (Eigen::Index j = 0; j < n; ++j) {
    if (!(length(j) > 0.0)) length(j) = 1.0;
  }
  const Eigen::MatrixXd scaled = qr.triangle * length.cwiseInverse().asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(kRankThreshold);
  decomposition.compute(scaled);
  const Eigen::VectorXd step = decomposition.solve(-qr.projection);
  solution.rank = static_cast<std::size_t>(decomposition.rank());
  solution.projected = (scaled * step).norm();
  solution.step = step.cwiseQuotient(length);
  return solution;
}

}  // namespace

Objective::Objective(Evaluator& evaluator, const UnknownMap& map)
    : evaluator_(&evaluator),
      map_(&map),
      held_(map.size(), 0),
      shaped_(map.shaped()),
      free_(map.size()) {
  std::iota(free_.begin(), free_.end(), std::size_t{0});
}

void Objective::set_held(std::size_t coordinate, bool held) {
  held_[coordinate] = held ? 1 : 0;
  free_.clear();
  for (std::size_t c = 0; c < held_.size(); ++c) {
    if (held_[c] == 0) free_.push_back(c);
  }
}

bool Objective::cost(std::span<const double> z, SearchPoint& point) {
  point.z.assign(z.begin(), z.end());
  point.x.resize(evaluator_->unknowns());
  point.residuals.resize(evaluator_->rows());
  point.products.resize(0, 0);
  map_->unknowns(z, point.x);
  if (!evaluator_->residuals(point.x, point.residuals)) return false;
  point.cost = total_cost(evaluator_->problem(), point.residuals);
  return std::isfinite(point.cost);
}

bool Objective::derivatives(std::span<const double> z, SearchPoint& point, bool fine) {
  point.z.assign(z.begin(), z.end());
  point.x.resize(evaluator_->unknowns());
  point.residuals.resize(evaluator_->rows());
  point.jacobian.resize(evaluator_->rows() * evaluator_->unknowns());
  point.products.resize(0, 0);
  map_->unknowns(z, point.x);
  if (!evaluator_->derivatives(point.x, point.residuals, point.jacobian, fine)) return false;
  point.cost = total_cost(evaluator_->problem(), point.residuals);
  if (evaluator_->problem().loss.kind == Loss::Kind::kSquares) {
    // The products are wanted next, and any number that is not finite spoils them.
    point.products = products(point.jacobian, evaluator_->unknowns(), point.residuals);
    if (point.products.allFinite()) return std::isfinite(point.cost);
  }
  return all_finite(point.jacobian) && std::isfinite(point.cost);
}

std::vector<double> Objective::root_weights(const SearchPoint& point) const {
  if (evaluator_->problem().loss.kind == Loss::Kind::kSquares) return {};
  std::vector<double> weights = row_weights(evaluator_->problem(), point.residuals);
  for (double& weight : weights) weight = std::sqrt(weight);
  return weights;
}

void Objective::weigh(const SearchPoint& point, std::span<const double> root_weights,
                      std::span<double> f, std::span<double> jacobian) const {
  const std::size_t rows = evaluator_->rows();
  const auto weight = [&](std::size_t i) { return root_weights.empty() ? 1.0 : root_weights[i]; };
  if (!f.empty()) {
    for (std::size_t i = 0; i < rows; ++i) f[i] = weight(i) * point.residuals[i];
  }
  if (jacobian.empty()) return;
  const std::vector<CoordinateColumn> columns = map_->columns(point.z, held_);
  const std::size_t n = evaluator_->unknowns();
  const std::size_t m = free_.size();
  // Most coordinates move one unknown each: then a row is a product of two short rows.
  std::vector<std::size_t> unknown(m, 0);
  std::vector<double> factor(m, 0.0);
  bool single = true;
  for (std::size_t c = 0; c < m; ++c) {
    const CoordinateColumn& column = columns[free_[c]];
    single = single && column.size() <= 1;
    if (!column.empty()) std::tie(unknown[c], factor[c]) = column.front();
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const double* from = point.jacobian.data() + i * n;
    double* to = jacobian.data() + i * m;
    const double w = weight(i);
    if (single) {
      for (std::size_t c = 0; c < m; ++c) to[c] = w * factor[c] * from[unknown[c]];
      continue;
    }
    for (std::size_t c = 0; c < m; ++c) {
      double sum = 0.0;
      for (const auto& [j, slope] : columns[free_[c]]) sum += slope * from[j];
      to[c] = w * sum;
    }
  }
}

Eigen::MatrixXd Objective::coordinate_map(const SearchPoint& point) const {
  const std::vector<CoordinateColumn> columns = map_->columns(point.z, held_);
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(evaluator_->unknowns()),
                                              static_cast<Eigen::Index>(free_.size()));
  for (std::size_t c = 0; c < free_.size(); ++c) {
    for (const auto& [j, slope] : columns[free_[c]]) {
      map(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(c)) = slope;
    }
  }
  return map;
}

Eigen::MatrixXd Objective::to_coordinates(const SearchPoint& point,
                                          const Eigen::MatrixXd& products) const {
  const Eigen::MatrixXd map = coordinate_map(point);
  const Eigen::Index n = map.rows();
  const Eigen::Index m = map.cols();
  Eigen::MatrixXd result(m + 1, m + 1);
  result.topLeftCorner(m, m) = map.transpose() * products.topLeftCorner(n, n) * map;
  result.topRightCorner(m, 1) = map.transpose() * products.topRightCorner(n, 1);
  result.bottomLeftCorner(1, m) = result.topRightCorner(m, 1).transpose();
  result(m, m) = products(n, n);
  return result;
}

std::vector<double> Objective::moved(const SearchPoint& point, const Eigen::VectorXd& step) const {
  std::vector<double> z = point.z;
  bool any = false;
  for (std::size_t c = 0; c < free_.size(); ++c) {
    z[free_[c]] += step(static_cast<Eigen::Index>(c));
    any = any || shaped_[free_[c]] != 0;
  }
  if (!any) return z;
  constexpr double kMostLogarithm = 2.0;
  std::vector<double> x = point.x;
  const std::vector<double> change = unknown_step(point, step);
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (evaluator_->problem().unknowns[j].scale == Scale::kLog) {
      x[j] *= std::exp(std::clamp(change[j] / x[j], -kMostLogarithm, kMostLogarithm));
    } else {
      x[j] += change[j];
    }
  }
  const std::vector<double> target = map_->coordinates(x, 0.0);
  for (std::size_t c = 0; c < z.size(); ++c) {
    if (shaped_[c] != 0 && held_[c] == 0) z[c] = target[c];
  }
  return z;
}

Eigen::MatrixXd Objective::unknown_products(SearchPoint& point,
                                            std::span<const double> root_weights) const {
  const std::size_t n = evaluator_->unknowns();
  if (!root_weights.empty()) {
    return products(point.jacobian, n, point.residuals, root_weights);
  }
  assert(point.products.size() > 0);  // the point has derivatives
  return point.products;
}

Eigen::MatrixXd Objective::normal_products(SearchPoint& point,
                                           std::span<const double> root_weights) const {
  return to_coordinates(point, unknown_products(point, root_weights));
}

Linearisation Objective::linearise(SearchPoint& point) {
  const std::size_t m = free_.size();
  Linearisation linear;
  const auto take_step = [&](const TallQr& qr) {
    const ScaledSolution solution = solve(qr);
    linear.step = solution.step;
    linear.rank = solution.rank;
    linear.triangle = qr.triangle;
    linear.projection = qr.projection;
    return solution.projected;
  };
  const auto take_offset = [&](const TallQr& qr) {
    const double projected = take_step(qr);
    const double length = std::hypot(qr.projection.norm(), qr.rest);
    linear.offset = length > 0.0 ? projected / length : 0.0;
  };
  const std::vector<double> root = root_weights(point);
  linear.products = unknown_products(point, root);
  const Eigen::MatrixXd squares = to_coordinates(point, linear.products);
  const std::optional<TallQr> triangle = triangle_of(squares);
  if (triangle) {
    take_offset(*triangle);
  } else {
    f_.resize(evaluator_->rows());
    jacobian_.resize(f_.size() * m);
    weigh(point, root, f_, jacobian_);
    take_offset(tall_qr(jacobian_, m, f_));
  }
  if (root.empty()) return linear;

  // Huber's loss has no curvature beyond its threshold; a little keeps the step finite.
  constexpr double kLeastCurvature = 1e-3;
  const ResidualProblem& problem = evaluator_->problem();
  std::vector<double> ratio(root.size(), 1.0);
  for (std::size_t i = 0; i < problem.data_rows; ++i) {
    const double weight = root[i] * root[i];
    const double curvature =
        std::max(loss_curvature(problem.loss, point.residuals[i]), kLeastCurvature * weight);
    ratio[i] = std::sqrt(curvature / weight);
  }
  if (triangle) {
    std::vector<double> curved = root;
    for (std::size_t i = 0; i < curved.size(); ++i) curved[i] *= ratio[i];
    Eigen::MatrixXd curvatures = normal_products(point, curved);
    // The gradient is that of the weights.
    curvatures.rightCols<1>() = squares.rightCols<1>();
    curvatures.bottomRows<1>() = squares.bottomRows<1>();
    if (const std::optional<TallQr> newton = triangle_of(curvatures)) {
      take_step(*newton);
      return linear;
    }
    f_.resize(evaluator_->rows());
    jacobian_.resize(f_.size() * m);
    weigh(point, root, f_, jacobian_);
  }
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    for (std::size_t c = 0; c < m; ++c) jacobian_[i * m + c] *= ratio[i];
    f_[i] /= ratio[i];
  }
  take_step(tall_qr(jacobian_, m, f_));
  return linear;
}

std::vector<double> Objective::inward_slopes(const SearchPoint& point) const {
  const std::vector<CoordinateColumn> columns = map_->columns(point.z, held_);
  const std::vector<double> weights = row_weights(evaluator_->problem(), point.residuals);
  const std::size_t n = evaluator_->unknowns();
  std::vector<double> slopes(held_.size(), 0.0);
  double length = 0.0;
  for (std::size_t i = 0; i < point.residuals.size(); ++i) {
    length += weights[i] * point.residuals[i] * point.residuals[i];
  }
  for (std::size_t c = 0; c < held_.size(); ++c) {
    if (held_[c] == 0) continue;
    double slope = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < point.residuals.size(); ++i) {
      double change = 0.0;
      for (const auto& [j, by] : columns[c]) change += by * point.jacobian[i * n + j];
      slope += weights[i] * point.residuals[i] * change;
      square += weights[i] * change * change;
    }
    const double scale = std::sqrt(length * square);
    slopes[c] = scale > 0.0 ? slope / scale : 0.0;
  }
  return slopes;
}

std::vector<double> Objective::unknown_step(const SearchPoint& point,
                                            const Eigen::VectorXd& step) const {
  const std::vector<CoordinateColumn> columns = map_->columns(point.z, held_);
  std::vector<double> change(evaluator_->unknowns(), 0.0);
  for (std::size_t c = 0; c < free_.size(); ++c) {
    for (const auto& [j, slope] : columns[free_[c]]) {
      change[j] += slope * step(static_cast<Eigen::Index>(c));
    }
  }
  return change;
}

}  // namespace slipbench::driver::fit
