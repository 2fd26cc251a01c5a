// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "driver/calibrate/least_squares/error_scale.hpp"
#include "driver/calibrate/least_squares/statistics.hpp"

namespace slipbench::driver {
namespace {

/// Twice the lag after which the residuals' autocorrelation is lost in noise, 1 if it is so at
/// once.
std::size_t block_length(std::span<const double> residuals) {
  const std::size_t n = residuals.size();
  double mean = 0.0;
  for (const double r : residuals) mean += r / static_cast<double>(n);
  double variance = 0.0;
  for (const double r : residuals) variance += (r - mean) * (r - mean);
  const double noise = 2.0 / std::sqrt(static_cast<double>(n));
  const std::size_t most = std::max<std::size_t>(n / 10, 1);
  for (std::size_t lag = 1; lag <= most / 2; ++lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) {
      sum += (residuals[i] - mean) * (residuals[i + lag] - mean);
    }
    if (std::abs(sum) <= noise * variance) return std::max<std::size_t>(2 * (lag - 1), 1);
  }
  return most;
}

/// A value of sorted numbers at a part of their range, between neighbours linearly.
double percentile(const std::vector<double>& sorted, double part) {
  const double where = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(where);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (where - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Bootstrap bootstrap(const ResidualProblem& problem, const LeastSquaresFit& fit, int resamplings,
                    double confidence, std::uint64_t seed) {
  const std::size_t n = problem.unknowns.size();
  const std::size_t data = problem.data_rows;
  Bootstrap result;
  result.wanted = resamplings;
  result.standard_error.assign(n, std::numeric_limits<double>::quiet_NaN());
  result.lower = result.standard_error;
  result.upper = result.standard_error;
  const bool fitted =
      fit.residuals.size() == problem.rows && fit.jacobian.size() == problem.rows * n;
  if (resamplings <= 0 || data == 0 || !fitted) return result;
  result.block = block_length({fit.residuals.data(), data});

  // The residuals of a fit are smaller than the errors of the data.
  const double freedom = static_cast<double>(data) - effective_unknowns(problem, fit);
  if (!(freedom > 0.0)) return result;
  const double inflation = std::sqrt(static_cast<double>(data) / freedom);
  double mean = 0.0;
  for (std::size_t i = 0; i < data; ++i) mean += fit.residuals[i] / static_cast<double>(data);

  const auto shift = std::make_shared<std::vector<double>>(problem.rows, 0.0);
  const auto add = [shift](std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] += (*shift)[i];
  };
  ResidualProblem resampled = problem;
  for (std::size_t j = 0; j < n; ++j) resampled.unknowns[j].start = fit.x[j];
  resampled.residuals = [model = problem.residuals, add](std::span<const double> x,
                                                         std::span<double> r) {
    if (!model(x, r)) return false;
    add(r);
    return true;
  };
  if (problem.derivatives) {
    resampled.derivatives = [model = problem.derivatives, add](std::span<const double> x,
                                                               std::span<double> r,
                                                               std::span<double> jacobian) {
      if (!model(x, r, jacobian)) return false;
      add(r);
      return true;
    };
  }
  SolverOptions options;
  options.gradient_tolerance = 1e-5;  // of a standard error, about: far below the scatter
  options.step_tolerance = 1e-8;
  options.polish = false;

  std::mt19937_64 engine(seed);
  std::vector<std::vector<double>> values(n);
  for (int sample = 0; sample < resamplings; ++sample) {
    for (std::size_t first = 0; first < data; first += result.block) {
      const std::size_t from = engine() % (data - std::min(result.block, data) + 1);
      for (std::size_t k = 0; k < result.block && first + k < data; ++k) {
        (*shift)[first + k] =
            inflation * (fit.residuals[from + k] - mean) - fit.residuals[first + k];
      }
    }
    const LeastSquaresFit again = solve_least_squares(resampled, options);
    if (!again.converged) continue;
    ++result.done;
    for (std::size_t j = 0; j < n; ++j) values[j].push_back(again.x[j]);
  }
  if (result.done < 2) return result;
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.frozen[j] != 0) continue;
    std::vector<double>& column = values[j];
    std::sort(column.begin(), column.end());
    double average = 0.0;
    for (const double value : column) average += value / static_cast<double>(column.size());
    double squares = 0.0;
    for (const double value : column) squares += (value - average) * (value - average);
    result.standard_error[j] = std::sqrt(squares / static_cast<double>(column.size() - 1));
    result.lower[j] = percentile(column, 0.5 - 0.5 * confidence);
    result.upper[j] = percentile(column, 0.5 + 0.5 * confidence);
  }
  return result;
}

}  // namespace slipbench::driver
