// SPDX-License-Identifier: Apache-2.0
// The least of a linearised problem within bounds and shapes, over the unknowns themselves.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace slipbench::driver::fit {

/// A sum of factors times unknowns that is to be at least `least`.
struct Inequality {
  std::vector<std::pair<std::size_t, double>> terms;
  double least = 0.0;
};

/// Gain that a step of all unknowns promises.
struct ConvexStep {
  Eigen::VectorXd change;
  double gain = 0.0;  ///< fall of the linearised cost, >= 0
};

/// The least of |J d + f|^2/2 under the inequalities at x + d: a problem of least distance, solved
/// by non-negative least squares (Lawson and Hanson 1974, chapter 23). Unknowns without any effect
/// stay.
/// \param products [J f]^T [J f]
/// \param x keeps the inequalities
ConvexStep convex_step(const Eigen::MatrixXd& products, std::span<const double> x,
                       std::span<const Inequality> inequalities);

}  // namespace slipbench::driver::fit
