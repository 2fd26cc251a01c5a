// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/fit/statistics.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace slipbench::driver::fit {
namespace {

/// Normal noise of deviation 1, the same with every standard library (Box and Muller).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : bits_(seed) {}
  double operator()() {
    const double a = uniform();
    const double b = uniform();
    return std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * std::numbers::pi * b);
  }

 private:
  double uniform() { return (static_cast<double>(bits_() >> 11U) + 0.5) * 0x1p-53; }
  std::mt19937_64 bits_;
};

/// r = A x - y.
ResidualProblem linear(std::vector<double> matrix, std::vector<double> measured,
                       std::vector<UnknownRange> unknowns) {
  ResidualProblem problem;
  problem.rows = measured.size();
  problem.data_rows = measured.size();
  const std::size_t n = unknowns.size();
  problem.unknowns = std::move(unknowns);
  problem.residuals = [matrix, measured, n](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = -measured[i];
      for (std::size_t j = 0; j < n; ++j) r[i] += matrix[i * n + j] * x[j];
    }
    return true;
  };
  problem.derivatives = [matrix, residuals = problem.residuals](std::span<const double> x,
                                                                std::span<double> r,
                                                                std::span<double> jacobian) {
    std::copy(matrix.begin(), matrix.end(), jacobian.begin());
    return residuals(x, r);
  };
  return problem;
}

/// 1 + 2 t over -1 .. 1 with errors.
ResidualProblem straight(const std::vector<double>& errors) {
  const std::size_t rows = errors.size();
  std::vector<double> matrix;
  std::vector<double> measured;
  for (std::size_t i = 0; i < rows; ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(rows - 1) - 1.0;
    matrix.insert(matrix.end(), {1.0, t});
    measured.push_back(1.0 + 2.0 * t + errors[i]);
  }
  return linear(std::move(matrix), std::move(measured), {{.start = 0.5}, {.start = 1.0}});
}

std::vector<double> white(std::size_t rows, std::uint64_t seed) {
  Noise noise(seed);
  std::vector<double> errors(rows);
  for (double& error : errors) error = noise();
  return errors;
}

std::vector<double> autoregressive(std::size_t rows, double rho, std::uint64_t seed) {
  std::vector<double> errors = white(rows, seed);
  for (std::size_t i = 1; i < rows; ++i) {
    errors[i] = rho * errors[i - 1] + std::sqrt(1.0 - rho * rho) * errors[i];
  }
  return errors;
}

TEST_CASE("The bootstrap keeps the residuals of a response in it") {
  // 2 t and 3 t, measured with noises of 0.01 and 1, an unknown each.
  constexpr std::size_t kEach = 100;
  std::vector<double> matrix;
  std::vector<double> measured;
  double squares = 0.0;
  Noise noise(3);
  for (std::size_t i = 0; i < 2 * kEach; ++i) {
    const double t = static_cast<double>(i % kEach) / static_cast<double>(kEach);
    const bool first = i < kEach;
    matrix.insert(matrix.end(), {first ? t : 0.0, first ? 0.0 : t});
    measured.push_back((first ? 2.0 : 3.0) * t + (first ? 0.01 : 1.0) * noise());
    if (first) squares += t * t;
  }
  ResidualProblem problem = linear(matrix, measured, {{.start = 1.0}, {.start = 1.0}});
  problem.groups = {0, kEach};
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const Bootstrap result = bootstrap(problem, fit, 200, 0.95, 1);
  CHECK(result.done == 200);
  // 100 points know their noise to 7 %, 200 resamplings their scatter to 5 %
  CHECK(result.standard_error[0] == Approx(0.01 / std::sqrt(squares)).epsilon(0.25));
  CHECK(result.standard_error[1] == Approx(1.0 / std::sqrt(squares)).epsilon(0.25));
}

TEST_CASE("A response of a few points draws from all data") {
  ResidualProblem problem = straight(white(60, 4));
  problem.groups = {0, 1, 2, 3};
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  const Bootstrap result = bootstrap(problem, fit, 200, 0.95, 1);
  CHECK(result.standard_error[1] == Approx(statistics.standard_error[1]).epsilon(0.25));
}

TEST_CASE("Blocks have the length that the autocorrelation asks for") {
  CHECK(block_length(white(4000, 1)) < 3.0);
  for (const double rho : {0.5, 0.8}) {
    CAPTURE(rho);
    // G/g of the autocovariances rho^|k| is 2 rho/(1 - rho^2); that of a sample scatters.
    const double ratio = 2.0 * rho / (1.0 - rho * rho);
    const double exact = std::cbrt(1.5 * ratio * ratio * 4000.0);
    const double found = block_length(autoregressive(4000, rho, 2));
    CHECK(found > 0.6 * exact);
    CHECK(found < 1.7 * exact);
  }
  CHECK(block_length(autoregressive(4000, -0.6, 2)) == 1.0);
  CHECK(block_length(std::vector<double>(30, 0.5)) == 1.0);
}

TEST_CASE("Bootstrap intervals of few points cover the truth as often as they say") {
  constexpr int kSeeds = 300;
  int covered = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const ResidualProblem problem = straight(white(6, static_cast<std::uint64_t>(seed)));
    const LeastSquaresFit fit = solve_least_squares(problem, {});
    const Bootstrap result = bootstrap(problem, fit, 100, 0.95, 1);
    covered += result.lower[1] <= 2.0 && result.upper[1] >= 2.0 ? 1 : 0;
  }
  // 300 tries know the part to 1.3 %; percentiles without Student's t cover 0.87
  CHECK(covered > 0.91 * kSeeds);
}

TEST_CASE("Residuals that hang together are drawn in blocks, and too few of them are told") {
  const ResidualProblem some = straight(autoregressive(400, 0.5, 7));
  const LeastSquaresFit fit = solve_least_squares(some, {});
  const Bootstrap of_some = bootstrap(some, fit, 100, 0.95, 1);
  CHECK(of_some.block > 3);
  CHECK_FALSE(of_some.few_blocks);
  // 400 points by n/(1 + 2 rho/(1 - rho)) are as good as 133: sqrt(3) times the error
  CHECK(of_some.standard_error[0] > 1.3 * fit_statistics(some, fit, 0.95).standard_error[0]);
  const ResidualProblem most = straight(autoregressive(400, 0.97, 7));
  CHECK(bootstrap(most, solve_least_squares(most, {}), 20, 0.95, 1).few_blocks);
}

TEST_CASE("Of as many values as unknowns nothing is told of the errors") {
  const ResidualProblem problem = straight({0.1, -0.2});
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  CHECK(std::isnan(fit_statistics(problem, fit, 0.95).deviation));
  const Bootstrap resampled = bootstrap(problem, fit, 20, 0.95, 1);
  CHECK(resampled.wanted == 20);
  CHECK(resampled.done == 0);
  const LikelihoodProfile profile = profile_likelihood(problem, fit, 0, 0.95);
  CHECK(std::isnan(profile.threshold));
  CHECK(std::isnan(profile.lower));
  CHECK_FALSE(profile.open_below);
  CHECK_FALSE(profile.open_above);
}

TEST_CASE("Data without noise are resampled as well") {
  const ResidualProblem problem = straight(std::vector<double>(40, 0.0));
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  const Bootstrap result = bootstrap(problem, fit, 20, 0.95, 1);
  CHECK(result.done >= 18);
  CHECK(result.standard_error[0] < 1e-12);
}

TEST_CASE("What derivatives cannot tell from nothing is no data") {
  // Only the sum of two unknowns is seen, but for errors of the derivatives.
  constexpr double kError = 1e-10;
  ResidualProblem problem = straight(white(50, 5));
  std::vector<double> matrix;
  std::vector<double> measured;
  Noise noise(6);
  for (std::size_t i = 0; i < 50; ++i) {
    const double t = 1.0 + static_cast<double>(i);
    matrix.insert(matrix.end(), {t, t * (1.0 + kError * noise())});
    measured.push_back(3.0 * t + noise());
  }
  problem = linear(matrix, measured, {{.start = 1.0}, {.start = 1.0}});
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  CHECK(fit_statistics(problem, fit, 0.95).identifiable == std::vector<char>{1, 1});
  problem.derivative_accuracy = 1e-9;
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  CHECK(statistics.identifiable == std::vector<char>{0, 0});
  CHECK(std::isnan(statistics.standard_error[0]));
}

TEST_CASE("A profile counts the refits that are no minimum") {
  Noise noise(8);
  std::vector<double> matrix;
  std::vector<double> measured;
  for (std::size_t i = 0; i < 50; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    matrix.insert(matrix.end(), {1.0, t});
    measured.push_back(1.0 + 2.0 * t + noise());
  }
  const ResidualProblem good = linear(matrix, measured, {{.start = 0.5}, {.start = 1.0}});
  const LeastSquaresFit fit = solve_least_squares(good, {});
  const LikelihoodProfile sound = profile_likelihood(good, fit, 0, 0.95);
  CHECK(sound.refits > 0);
  CHECK(sound.unconverged == 0);
  // Away from the optimum the slopes to the other unknown have the wrong sign.
  ResidualProblem bad = good;
  bad.derivatives = [model = good.derivatives, at = fit.x[0]](std::span<const double> x,
                                                              std::span<double> r,
                                                              std::span<double> jacobian) {
    if (!model(x, r, jacobian)) return false;
    if (x[0] == at) return true;
    for (std::size_t i = 0; i < r.size(); ++i) jacobian[2 * i + 1] *= -1.0;
    return true;
  };
  CHECK(profile_likelihood(bad, fit, 0, 0.95).unconverged > 0);
}

TEST_CASE("Differences of an unknown on a logarithmic scale are a part of it, not of its bounds") {
  ResidualProblem problem;
  problem.rows = 30;
  problem.data_rows = 30;
  problem.unknowns = {{.start = 1e-8, .lower = 1e-12, .upper = 1e12, .scale = Scale::kLog}};
  // ln(x/1e-9) = 0 by data with a scatter of 0.1 about it
  Noise noise(9);
  std::vector<double> errors(30);
  double mean = 0.0;
  for (double& error : errors) mean += (error = 0.1 * noise()) / 30.0;
  problem.residuals = [errors](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = std::log(x[0] / 1e-9) - errors[i];
    return true;
  };
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  CHECK(fit.converged);
  // the differences' error, 1e-10 of the value
  CHECK(fit.x[0] == Approx(1e-9 * std::exp(mean)).epsilon(1e-8));
}

}  // namespace
}  // namespace slipbench::driver::fit
