// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/evaluator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slipbench::driver::fit {
namespace {

/// The size of an unknown, by which its step is measured.
double size_of(const UnknownRange& range, double x) {
  if (range.scale == Scale::kLog && x != 0.0) return std::abs(x);
  double size = std::max(std::abs(x), 1e-2 * std::abs(range.start));
  if (std::isfinite(range.lower) && std::isfinite(range.upper)) {
    size = std::max(size, 1e-4 * (range.upper - range.lower));
  }
  return size > 0.0 ? size : 1e-4;
}

/// Points of a difference in steps, and their weights.
using Stencil = std::vector<std::pair<double, double>>;

}  // namespace

bool all_finite(std::span<const double> values) {
  // 0 times a number is 0, unless the number is infinite or none.
  std::array<double, 8> sum{};  // several, or each addition would wait for the one before
  std::size_t i = 0;
  for (; i + sum.size() <= values.size(); i += sum.size()) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += 0.0 * values[i + k];
  }
  for (; i < values.size(); ++i) sum[0] += 0.0 * values[i];
  return std::all_of(sum.begin(), sum.end(), [](double s) { return s == 0.0; });
}

bool Evaluator::residuals(std::span<const double> x, std::span<double> r) {
  ++residual_evaluations_;
  return problem_->residuals(x, r) && all_finite(r);
}

bool Evaluator::derivatives(std::span<const double> x, std::span<double> r,
                            std::span<double> jacobian, bool fine) {
  ++derivative_evaluations_;
  if (problem_->derivatives) {
    return problem_->derivatives(x, r, jacobian) && all_finite(r);
  }
  if (!residuals(x, r)) return false;
  for (std::size_t j = 0; j < unknowns_; ++j) {
    if (!difference(x, r, j, fine, jacobian)) return false;
  }
  return all_finite(jacobian);
}

bool Evaluator::difference(std::span<const double> x, std::span<const double> r,
                           std::size_t unknown, bool fine, std::span<double> jacobian) {
  // Truncation ~ step^2 or step^4 against rounding ~ 1e-16/step.
  constexpr double kStep = 6e-6;
  constexpr double kFineStep = 8e-4;
  const UnknownRange& range = problem_->unknowns[unknown];
  std::vector<double> moved(x.begin(), x.end());
  std::vector<double> value(rows_);
  double step = (fine ? kFineStep : kStep) * size_of(range, x[unknown]);
  for (int tries = 0; tries < 4; ++tries, step *= 0.1) {
    const double reach = fine ? 2.0 * step : step;
    const bool up = x[unknown] + reach <= range.upper;
    const bool down = x[unknown] - reach >= range.lower;
    Stencil stencil;
    if (up && down) {
      stencil = fine ? Stencil{{1.0, 8.0 / 12.0},
                               {-1.0, -8.0 / 12.0},
                               {2.0, -1.0 / 12.0},
                               {-2.0, 1.0 / 12.0}}
                     : Stencil{{1.0, 0.5}, {-1.0, -0.5}};
    } else {
      const double sense = up ? 1.0 : -1.0;
      const double size = fine ? 0.01 : 1.0;  // of second order only: a smaller step
      stencil = {{sense * size, 2.0 * sense / size}, {2.0 * sense * size, -0.5 * sense / size}};
    }
    double own = 0.0;
    for (const auto& [at, weight] : stencil) own -= weight;
    for (std::size_t i = 0; i < rows_; ++i) jacobian[i * unknowns_ + unknown] = own * r[i];
    bool found = true;
    for (const auto& [at, weight] : stencil) {
      moved[unknown] = x[unknown] + at * step;
      if (!residuals(moved, value)) {
        found = false;
        break;
      }
      for (std::size_t i = 0; i < rows_; ++i) {
        jacobian[i * unknowns_ + unknown] += weight * value[i];
      }
    }
    if (!found) continue;
    const double per_step = 1.0 / step;
    for (std::size_t i = 0; i < rows_; ++i) jacobian[i * unknowns_ + unknown] *= per_step;
    return true;
  }
  return false;
}

}  // namespace slipbench::driver::fit
