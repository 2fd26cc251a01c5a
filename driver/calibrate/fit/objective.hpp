// SPDX-License-Identifier: Apache-2.0
// The cost over coordinates: where a search stands, and its linearisation there.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "driver/calibrate/fit/evaluator.hpp"
#include "driver/calibrate/fit/unknown_map.hpp"

namespace slipbench::driver::fit {

/// A point of a search with what the model says there.
struct SearchPoint {
  std::vector<double> z;  ///< coordinates
  std::vector<double> x;  ///< unknowns
  std::vector<double> residuals;
  std::vector<double> jacobian;  ///< dr/dx, row-major; of another point after Objective::cost
  double cost = 0.0;
  Eigen::MatrixXd products;  ///< of dr/dx and r, all weights 1; of squares only
};

/// The linearised problem at a point: f = sqrt(w) r, G = sqrt(w) dr/dz over the free coordinates.
struct Linearisation {
  Eigen::VectorXd step;      ///< of the free coordinates: the least of |G step + f|
  Eigen::MatrixXd triangle;  ///< R: step is the least of |R step + projection|
  Eigen::VectorXd projection;
  Eigen::MatrixXd products;  ///< of sqrt(w) dr/dx and sqrt(w) r: over the unknowns
  /// |part of f in the range of G| / |f|: the cosine of the angle between them. 0 at a minimum;
  /// invariant to how the unknowns are scaled (Bates and Watts 1981). 0 where f is 0.
  double offset = 0.0;
  std::size_t rank = 0;  ///< of G, columns scaled to unit length
};

/// The model's own rounding in a cost, as a part of it: a gain below it is none.
inline constexpr double kCostNoise = 1e-10;

class Objective {
 public:
  Objective(Evaluator& evaluator, const UnknownMap& map);

  Evaluator& evaluator() { return *evaluator_; }
  const UnknownMap& map() const { return *map_; }

  /// Coordinates that are searched; the others are held where they are.
  std::span<const std::size_t> free() const { return free_; }
  bool held(std::size_t coordinate) const { return held_[coordinate] != 0; }
  void set_held(std::size_t coordinate, bool held);

  /// x, r and cost at z; false where the model has no value.
  bool cost(std::span<const double> z, SearchPoint& point);
  /// The same with dr/dx.
  bool derivatives(std::span<const double> z, SearchPoint& point, bool fine);

  /// sqrt of the weights of all rows at a point; empty for squares, whose weights are 1.
  std::vector<double> root_weights(const SearchPoint& point) const;

  /// f and G = sqrt(w) dr/dz, row-major over the free coordinates. Either may be empty.
  void weigh(const SearchPoint& point, std::span<const double> root_weights, std::span<double> f,
             std::span<double> jacobian) const;

  /// [G f]^T [G f] over the free coordinates. Keeps what it finds with the point.
  Eigen::MatrixXd normal_products(SearchPoint& point, std::span<const double> root_weights) const;

  /// The linearised problem, from the products where they are good enough, else by QR. For robust
  /// losses the step is that of the curvatures rho' + 2 r^2 rho'' (at least a part of rho'), which
  /// converges faster than reweighting.
  Linearisation linearise(SearchPoint& point);

  /// d cost/dz of the held coordinates on their way inside, as a part of |f| times the length of
  /// their column; 0 for the free ones.
  std::vector<double> inward_slopes(const SearchPoint& point) const;

  /// dx/dz, unknowns x free coordinates.
  Eigen::MatrixXd coordinate_map(const SearchPoint& point) const;

  /// The coordinates after a step of the free ones. Those of shaped blocks go to where the unknowns
  /// go to first order, if the shape admits it: near folds coordinates are too curved for a step.
  std::vector<double> moved(const SearchPoint& point, const Eigen::VectorXd& step) const;

  /// dx for a step of the free coordinates, to first order.
  std::vector<double> unknown_step(const SearchPoint& point, const Eigen::VectorXd& step) const;

 private:
  Eigen::MatrixXd unknown_products(SearchPoint& point, std::span<const double> root_weights) const;
  Eigen::MatrixXd to_coordinates(const SearchPoint& point, const Eigen::MatrixXd& products) const;

  Evaluator* evaluator_;
  const UnknownMap* map_;
  std::vector<char> held_;
  std::vector<char> shaped_;
  std::vector<std::size_t> free_;
  std::vector<double> f_;  ///< of the linearised problem; kept, since they are large
  std::vector<double> jacobian_;
};

}  // namespace slipbench::driver::fit
