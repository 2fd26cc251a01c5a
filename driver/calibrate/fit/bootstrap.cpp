// SPDX-License-Identifier: Apache-2.0
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>

#include "driver/calibrate/fit/error_scale.hpp"
#include "driver/calibrate/fit/statistics.hpp"

namespace slipbench::driver::fit {
namespace {

/// Rows that follow each other, and what is drawn for them.
struct Response {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t pool = 0;        ///< first of the residuals that are drawn
  std::size_t pool_count = 0;  ///< and how many there are
  std::size_t block = 1;
  double mean = 0.0;       ///< of the pool
  double inflation = 1.0;  ///< the residuals of a fit are smaller than the errors of the data
};

double sum_of(std::span<const double> numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

/// \param capped is set where blocks are shorter than they should be
std::vector<Response> responses_of(const ResidualProblem& problem, const LeastSquaresFit& fit,
                                   bool* capped) {
  constexpr std::size_t kFewest = 10;    // that tell a noise of their own
  constexpr double kMostLeverage = 0.9;  // of a point, on average: what is left tells no noise
  const std::size_t data = problem.data_rows;
  const std::span<const double> residuals{fit.residuals.data(), data};
  const std::vector<double> all_leverages = leverages(problem, fit);
  std::vector<std::size_t> firsts = problem.groups;
  if (firsts.empty() || firsts.front() != 0) firsts.insert(firsts.begin(), 0);
  const auto fill = [&](std::size_t from, std::size_t count, Response* response) {
    const auto n = static_cast<double>(count);
    const double lost =
        std::min(sum_of(std::span(all_leverages).subspan(from, count)), kMostLeverage * n);
    response->pool = from;
    response->pool_count = count;
    response->mean = sum_of(residuals.subspan(from, count)) / n;
    response->inflation = std::sqrt(n / (n - lost));
  };
  std::vector<Response> responses;
  for (std::size_t g = 0; g < firsts.size(); ++g) {
    const std::size_t end = g + 1 < firsts.size() ? std::min(firsts[g + 1], data) : data;
    if (firsts[g] >= end) continue;
    Response response{.first = firsts[g], .count = end - firsts[g]};
    const auto n = static_cast<double>(response.count);
    const auto own = std::span(all_leverages).subspan(response.first, response.count);
    if (response.count < kFewest || sum_of(own) > kMostLeverage * n) {
      fill(0, data, &response);
    } else {
      fill(response.first, response.count, &response);
      const double wanted = block_length(residuals.subspan(response.first, response.count));
      const double most = std::max(1.0, std::min(3.0 * std::sqrt(n), n / 4.0));
      if (wanted > most) *capped = true;
      response.block = static_cast<std::size_t>(std::lround(std::min(wanted, most)));
    }
    responses.push_back(response);
  }
  return responses;
}

/// A value of sorted numbers at a part of their range, between neighbours linearly.
double percentile(const std::vector<double>& sorted, double part) {
  const double where = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(where);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (where - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

double block_length(std::span<const double> residuals) {
  const std::size_t n = residuals.size();
  if (n < 4) return 1.0;
  const auto number = static_cast<double>(n);
  const double mean = sum_of(residuals) / number;
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) {
      sum += (residuals[i] - mean) * (residuals[i + lag] - mean);
    }
    return sum / number;
  };
  const double variance = covariance(0);
  if (!(variance > 0.0)) return 1.0;
  // The last lag before so many that are lost in noise.
  const double noise = 2.0 * std::sqrt(std::log10(number) / number) * variance;
  const auto quiet =
      std::max<std::size_t>(5, static_cast<std::size_t>(std::sqrt(std::log10(number))));
  const std::size_t most =
      std::min(n - 1, static_cast<std::size_t>(std::ceil(std::sqrt(number))) + quiet);
  std::size_t last = 0;
  for (std::size_t lag = 1; lag <= most && lag <= last + quiet; ++lag) {
    if (std::abs(covariance(lag)) > noise) last = lag;
  }
  if (last == 0) return 1.0;
  const std::size_t window = std::min(2 * last, n - 1);
  double density = variance;
  double slope = 0.0;
  for (std::size_t lag = 1; lag <= window; ++lag) {
    const double part = static_cast<double>(lag) / static_cast<double>(window);
    const double weight = part <= 0.5 ? 1.0 : 2.0 * (1.0 - part);
    const double term = 2.0 * weight * covariance(lag);
    density += term;
    slope += static_cast<double>(lag) * term;
  }
  // Of residuals that swing about their mean, single points tell no less than blocks.
  if (!(density > 0.0) || !(slope > 0.0)) return 1.0;
  return std::max(1.0, std::cbrt(1.5 * slope * slope / (density * density) * number));
}

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
  const double effective = effective_unknowns(problem, fit);
  const double freedom = static_cast<double>(data) - effective;
  if (!(freedom > 0.0)) return result;
  const std::vector<Response> responses = responses_of(problem, fit, &result.few_blocks);
  double blocks = 0.0;
  for (const Response& response : responses) {
    result.block = std::max(result.block, response.block);
    blocks += static_cast<double>(response.count) / static_cast<double>(response.block);
  }
  constexpr double kEnough = 15.0;  // from here on the scatter of blocks is known well enough
  if (result.block > 1 && blocks < kEnough) result.few_blocks = true;

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
  std::size_t drawn = 0;
  const auto draw = [&] {
    for (const Response& response : responses) {
      std::size_t from = 0;
      for (std::size_t k = 0; k < response.count; ++k) {
        if (k % response.block == 0) from = engine() % response.pool_count;
        const std::size_t taken = response.pool + (from + k % response.block) % response.pool_count;
        const std::size_t row = response.first + k;
        (*shift)[row] =
            response.inflation * (fit.residuals[taken] - response.mean) - fit.residuals[row];
      }
    }
    ++drawn;
  };
  const auto resample = [&](std::size_t sample) {
    // Items come in their order; those that others run are drawn and left.
    while (drawn <= sample) draw();
    const LeastSquaresFit again = solve_least_squares(resampled, options);
    return is_minimum(again, effective, freedom) ? again.x : std::vector<double>();
  };
  const auto count = static_cast<std::size_t>(resamplings);
  std::vector<std::vector<double>> values(n);
  for (const std::vector<double>& x :
       problem.items ? problem.items(count, resample) : run_here(count, resample)) {
    if (x.empty()) continue;
    ++result.done;
    for (std::size_t j = 0; j < n; ++j) values[j].push_back(x[j]);
  }
  if (result.done < 2) return result;
  const double enlargement =
      gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, std::min(freedom, std::max(blocks - 1.0, 2.0))) /
      gsl_cdf_ugaussian_Pinv(0.5 + 0.5 * confidence);
  for (std::size_t j = 0; j < n; ++j) {
    if (fit.frozen[j] != 0) continue;
    std::vector<double>& column = values[j];
    std::sort(column.begin(), column.end());
    double average = 0.0;
    for (const double value : column) average += value / static_cast<double>(column.size());
    double squares = 0.0;
    for (const double value : column) squares += (value - average) * (value - average);
    result.standard_error[j] = std::sqrt(squares / static_cast<double>(column.size() - 1));
    const UnknownRange& range = problem.unknowns[j];
    const auto enlarged = [&](double value) {
      if (range.scale == Scale::kLog) return fit.x[j] * std::pow(value / fit.x[j], enlargement);
      return fit.x[j] + enlargement * (value - fit.x[j]);
    };
    const double lower = enlarged(percentile(column, 0.5 - 0.5 * confidence));
    const double upper = enlarged(percentile(column, 0.5 + 0.5 * confidence));
    result.lower[j] = std::clamp(lower, range.lower, range.upper);
    result.upper[j] = std::clamp(upper, range.lower, range.upper);
  }
  return result;
}

}  // namespace slipbench::driver::fit
