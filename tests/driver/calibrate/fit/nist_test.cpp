// SPDX-License-Identifier: Apache-2.0
// The 27 nonlinear regression problems of NIST's Statistical Reference Datasets: no bounds, no
// scales, the default options, one start each.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "driver/calibrate/fit/problem.hpp"
#include "driver/calibrate/fit/statistics.hpp"
#include "tests/driver/calibrate/fit/nist_models.hpp"
#include "tests/driver/calibrate/fit/nist_problems.hpp"

namespace slipbench::driver::fit {
namespace {

using nist::Dual;

enum class Derivatives { kExact, kDifferences };

ResidualProblem problem_of(const nist::Problem& nist, std::span<const double> start,
                           Derivatives derivatives) {
  ResidualProblem problem;
  const std::size_t stride = static_cast<std::size_t>(nist.predictors) + 1;
  problem.rows = nist.data.size() / stride;
  problem.data_rows = problem.rows;
  for (const double b : start) problem.unknowns.push_back({.start = b});
  const auto row = [&nist, stride](std::size_t i) { return nist.data.subspan(i * stride, stride); };
  const auto measured = [&nist](double y) {
    return std::string_view(nist.name) == "Nelson" ? std::log(y) : y;
  };
  problem.residuals = [&nist, row, measured](std::span<const double> x, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = nist::model<double>(nist.name, x, row(i).subspan(1)) - measured(row(i)[0]);
    }
    return true;
  };
  if (derivatives == Derivatives::kDifferences) return problem;
  problem.derivatives = [&nist, row, measured](std::span<const double> x, std::span<double> r,
                                               std::span<double> jacobian) {
    std::vector<Dual> b(x.begin(), x.end());
    for (std::size_t j = 0; j < b.size(); ++j) b[j].slope[j] = 1.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const Dual y = nist::model<Dual>(nist.name, b, row(i).subspan(1));
      r[i] = y.value - measured(row(i)[0]);
      for (std::size_t j = 0; j < b.size(); ++j) jacobian[i * b.size() + j] = y.slope[j];
    }
    return true;
  };
  return problem;
}

/// Digits of the standard deviations (and of the squares) that doubles can tell. Lanczos1's data
/// are its model to 14 digits: the residuals, 1e-13 of the data, are known to three digits.
double digits_of_residuals(const nist::Problem& nist, double wanted) {
  return std::string_view(nist.name) == "Lanczos1" ? 2.0 : wanted;
}

/// Correct significant digits: -log10 of the relative error, at most the 11 that are certified.
double digits(double value, double certified) {
  const double error = std::abs(value / certified - 1.0);
  if (!std::isfinite(error)) return 0.0;
  return error > 0.0 ? std::clamp(-std::log10(error), 0.0, 11.0) : 11.0;
}

struct Score {
  double parameters = 11.0;  ///< digits of the worst
  double deviations = 11.0;
  double squares = 11.0;
  LeastSquaresFit fit;
};

Score score(const nist::Problem& nist, std::span<const double> start, Derivatives derivatives) {
  const ResidualProblem problem = problem_of(nist, start, derivatives);
  Score score;
  score.fit = solve_least_squares(problem, {});
  const FitStatistics statistics = fit_statistics(problem, score.fit, 0.95);
  for (std::size_t j = 0; j < start.size(); ++j) {
    score.parameters = std::min(score.parameters, digits(score.fit.x[j], nist.certified[j]));
    score.deviations =
        std::min(score.deviations, digits(statistics.standard_error[j], nist.deviation[j]));
  }
  score.squares = digits(2.0 * score.fit.cost, nist.squares);
  return score;
}

/// The table of digits, if the environment asks for it.
void print(const nist::Problem& nist, int start, const Score& score) {
  if (std::getenv("SLIPBENCH_PRINT_DIGITS") == nullptr) return;
  fmt::print(
      "{:9} start {}: parameters {:4.1f}, deviations {:4.1f}, squares {:4.1f}; {:3} "
      "iterations, {:4} + {:3} evaluations\n",
      nist.name, start, score.parameters, score.deviations, score.squares, score.fit.iterations,
      score.fit.residual_evaluations, score.fit.derivative_evaluations);
}

TEST_CASE("NIST's regression problems are solved to six digits from the second start") {
  for (const nist::Problem& nist : nist::kProblems) {
    const Score found = score(nist, nist.second_start, Derivatives::kExact);
    print(nist, 2, found);
    INFO(nist.name);
    CHECK(found.fit.converged);
    CHECK(found.parameters >= 6.0);
    CHECK(found.deviations >= digits_of_residuals(nist, 5.0));
    CHECK(found.squares >= digits_of_residuals(nist, 6.0));
  }
}

TEST_CASE("NIST's regression problems are solved to six digits from the first start") {
  for (const nist::Problem& nist : nist::kProblems) {
    const Score found = score(nist, nist.first_start, Derivatives::kExact);
    print(nist, 1, found);
    INFO(nist.name);
    CHECK(found.fit.converged);
    CHECK(found.parameters >= 6.0);
    CHECK(found.deviations >= digits_of_residuals(nist, 5.0));
  }
}

TEST_CASE("NIST's regression problems are solved to six digits with differences for derivatives") {
  for (const nist::Problem& nist : nist::kProblems) {
    const Score found = score(nist, nist.second_start, Derivatives::kDifferences);
    print(nist, 2, found);
    INFO(nist.name);
    CHECK(found.fit.converged);
    CHECK(found.parameters >= 6.0);
    CHECK(found.deviations >= digits_of_residuals(nist, 5.0));
  }
}

}  // namespace
}  // namespace slipbench::driver::fit
