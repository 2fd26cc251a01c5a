// SPDX-License-Identifier: Apache-2.0
// Losses: what a residual adds to the cost, and with which weight it acts.
#pragma once

#include <span>
#include <vector>

#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// rho(r^2): squares r^2; Huber r^2 up to |r| = t and 2 t |r| - t^2 beyond; soft-L1
/// 2 t^2 (sqrt(1 + r^2/t^2) - 1). (docs/theory, section 17.)
double loss_value(const Loss& loss, double residual);

/// rho'(r^2), the weight of the squared residual in reweighted least squares: 1 for squares, in
/// (0, 1] otherwise.
double loss_weight(const Loss& loss, double residual);

/// rho'(r^2) + 2 r^2 rho''(r^2), the curvature of rho(r^2)/2 over r; >= 0. Huber's is 0 beyond t.
double loss_curvature(const Loss& loss, double residual);

/// Sum of rho(r^2)/2 over the data rows plus r^2/2 over the rows beyond them.
double total_cost(const ResidualProblem& problem, std::span<const double> residuals);

/// rho' of every row; 1 for rows that are no data.
std::vector<double> row_weights(const ResidualProblem& problem, std::span<const double> residuals);

}  // namespace slipbench::driver::fit
