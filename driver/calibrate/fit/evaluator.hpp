// SPDX-License-Identifier: Apache-2.0
// The model as the searches call it: counted, checked for numbers, differenced where it has no
// derivatives of its own.
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// Tells whether no number is infinite or none.
bool all_finite(std::span<const double> values);

class Evaluator {
 public:
  explicit Evaluator(const ResidualProblem& problem)
      : problem_(&problem), rows_(problem.rows), unknowns_(problem.unknowns.size()) {}

  const ResidualProblem& problem() const { return *problem_; }
  std::size_t rows() const { return rows_; }
  std::size_t unknowns() const { return unknowns_; }

  /// r(x); false where the model has no finite value. For as many threads as the problem admits.
  bool residuals(std::span<const double> x, std::span<double> r);

  /// r(x) and dr/dx, row-major; false where a residual is not finite, or a difference; derivatives
  /// of the model's own are left for the caller to look at. Without derivatives of the
  /// model: central differences, of fourth order if `fine` (truncation and rounding errors balance
  /// at about 1e-10 and 1e-13 of the value), one-sided at a bound.
  bool derivatives(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                   bool fine);

  /// Tells whether r with dr/dx costs little more than r and, if that was in vain, r again.
  bool has_cheap_derivatives() const {
    constexpr double kCheap = 4.0;
    return problem_->derivatives && problem_->derivative_effort <= kCheap;
  }

  long residual_evaluations() const { return residual_evaluations_; }
  long derivative_evaluations() const { return derivative_evaluations_; }
  /// Counts evaluations that another evaluator of the problem has made.
  void count(long residuals, long derivatives) {
    residual_evaluations_ += residuals;
    derivative_evaluations_ += derivatives;
  }

 private:
  bool difference(std::span<const double> x, std::span<const double> r, std::size_t unknown,
                  bool fine, std::span<double> jacobian);

  const ResidualProblem* problem_;
  std::size_t rows_;
  std::size_t unknowns_;
  std::atomic<long> residual_evaluations_ = 0;
  long derivative_evaluations_ = 0;
};

}  // namespace slipbench::driver::fit
