// SPDX-License-Identifier: Apache-2.0
// Everyday data in a fit: noise, and a cost with kinks where points begin to slip.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "driver/calibrate/fit/products.hpp"
#include "driver/calibrate/fit/statistics.hpp"

namespace slipbench::driver::fit {
namespace {

constexpr std::size_t kOrdinates = 6;
constexpr std::size_t kRows = 2000;
constexpr std::array<double, kOrdinates> kTruth{100.0, 92.0, 83.0, 76.0, 71.0, 68.0};
constexpr double kKnot = 4.0;  // of accumulated slip, between two ordinates
constexpr double kStiffness = 400.0;

/// A slider on a sine of growing amplitude, whose limit is a table over the accumulated slip. The
/// jacobian may be empty.
void slide(std::span<const double> limits, std::span<double> force, std::span<double> jacobian) {
  using Slopes = std::array<double, kOrdinates>;
  double f = 0.0;
  double slip = 0.0;
  Slopes f_slope{};
  Slopes slip_slope{};
  double before = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(force.size());
    const double motion = (0.5 + t) * std::sin(16.0 * std::numbers::pi * t);
    f += kStiffness * (motion - before);
    before = motion;
    const std::size_t cell = std::min(static_cast<std::size_t>(slip / kKnot), kOrdinates - 2);
    const double share = slip / kKnot - static_cast<double>(cell);
    const double limit = limits[cell] + share * (limits[cell + 1] - limits[cell]);
    if (std::abs(f) > limit) {
      const double sign = f > 0.0 ? 1.0 : -1.0;
      for (std::size_t j = 0; j < kOrdinates; ++j) {
        double slope = (limits[cell + 1] - limits[cell]) / kKnot * slip_slope[j];
        if (j == cell) slope += 1.0 - share;
        if (j == cell + 1) slope += share;
        slip_slope[j] += (sign * f_slope[j] - slope) / kStiffness;
        f_slope[j] = sign * slope;
      }
      slip += (std::abs(f) - limit) / kStiffness;
      f = sign * limit;
    }
    force[i] = f;
    if (jacobian.empty()) continue;
    std::copy(f_slope.begin(), f_slope.end(), jacobian.begin() + static_cast<long>(i * kOrdinates));
  }
}

/// Draws noise of variance 1.
std::vector<double> noise_of(unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<double> noise(kRows);
  for (double& value : noise) {
    value = -6.0;  // and twelve numbers: nearly normal, and the same on every machine
    for (int k = 0; k < 12; ++k) value += static_cast<double>(engine()) / 4294967296.0;
  }
  return noise;
}

ResidualProblem slider_problem(double start, unsigned seed) {
  ResidualProblem problem;
  problem.rows = problem.data_rows = kRows;
  for (std::size_t j = 0; j < kOrdinates; ++j) problem.unknowns.push_back({.start = start});
  std::vector<double> measured(kRows);
  slide(kTruth, measured, {});
  const std::vector<double> noise = noise_of(seed);
  for (std::size_t i = 0; i < kRows; ++i) measured[i] += noise[i];
  problem.residuals = [measured](std::span<const double> x, std::span<double> r) {
    slide(x, r, {});
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= measured[i];
    return true;
  };
  problem.derivatives = [measured](std::span<const double> x, std::span<double> r,
                                   std::span<double> jacobian) {
    slide(x, r, jacobian);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= measured[i];
    return true;
  };
  return problem;
}

/// A linear model of six unknowns with bends at which all rows change at once. Without the bends
/// the least cost would be beyond them, with them before.
ResidualProblem bent_problem(double start, unsigned seed) {
  constexpr std::size_t kBends = 3;
  constexpr double kBeyond = 0.05;  // about two standard errors
  constexpr double kMisfit = 0.1;   // what the bends make worse
  ResidualProblem problem;
  problem.rows = problem.data_rows = kRows;
  for (std::size_t j = 0; j < kOrdinates; ++j) problem.unknowns.push_back({.start = start});
  const auto column = [](std::size_t i, std::size_t j) {
    const double angle = (static_cast<double>(i) + 0.5) * std::numbers::pi / kRows;
    return std::cos(static_cast<double>(j) * angle);
  };
  const std::vector<double> noise = noise_of(seed);
  // Bend k is where x_k + x_(k+3)/2 = 1.5; the truth of all unknowns is 1.
  problem.derivatives = [=](std::span<const double> x, std::span<double> r,
                            std::span<double> jacobian) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] = noise[i];
      for (std::size_t j = 0; j < kOrdinates; ++j) {
        const double slope = column(i, j);
        r[i] += slope * (x[j] - 1.0 - kBeyond);
        if (!jacobian.empty()) jacobian[i * kOrdinates + j] = slope;
      }
      for (std::size_t k = 0; k < kBends; ++k) {
        const double bend = column(i, 10 + k);
        const double over = x[k] + 0.5 * x[k + 3] - 1.5;
        r[i] += bend * (kMisfit + (over > 0.0 ? 3.0 * over : 0.0));
        if (!(over > 0.0) || jacobian.empty()) continue;
        jacobian[i * kOrdinates + k] += 3.0 * bend;
        jacobian[i * kOrdinates + k + 3] += 1.5 * bend;
      }
    }
    return true;
  };
  problem.residuals = [all = problem.derivatives](std::span<const double> x, std::span<double> r) {
    return all(x, r, {});
  };
  return problem;
}

/// The cost after any unknown has changed by a part of its error, less the least cost: the lowest.
double lowest_beside(const ResidualProblem& problem, const LeastSquaresFit& fit, double part) {
  const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
  std::vector<double> r(problem.rows);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < fit.x.size(); ++j) {
    for (const double way : {-part, part}) {
      std::vector<double> x = fit.x;
      x[j] += way * statistics.standard_error[j];
      problem.residuals(x, r);
      double cost = 0.0;
      for (const double value : r) cost += 0.5 * value * value;
      lowest = std::min(lowest, cost - fit.cost);
    }
  }
  return lowest;
}

TEST_CASE("A slider with a table to fit and noise ends at its minimum, soon, and converged") {
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U);
  for (const double start : {60.0, 140.0}) {
    const ResidualProblem problem = slider_problem(start, seed);
    const LeastSquaresFit fit = solve_least_squares(problem, {});
    INFO("seed " << seed << ", start " << start << ": " << fit.stop_sentence << ", "
                 << fit.residual_evaluations << " + " << fit.derivative_evaluations);
    CHECK(fit.converged);
    CHECK(fit.residual_evaluations + fit.derivative_evaluations <= 80);
    CHECK(2.0 * fit.cost / kRows == Approx(1.0).epsilon(0.1));
    // The noise has the variance 1: nobody sees a hundredth of it.
    CHECK(lowest_beside(problem, fit, 0.1) > -1e-2);
    for (std::size_t j = 0; j < kOrdinates; ++j) {
      CHECK(fit.x[j] == Approx(kTruth[j]).epsilon(0.02));
    }
  }
}

TEST_CASE("A cost that is least where it has kinks is told so, soon, and converged") {
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U);
  for (const double start : {0.2, 3.0}) {
    const ResidualProblem problem = bent_problem(start, seed);
    const LeastSquaresFit fit = solve_least_squares(problem, {});
    INFO("seed " << seed << ", start " << start << ": " << fit.stop_sentence << ", "
                 << fit.residual_evaluations << " + " << fit.derivative_evaluations);
    CHECK(fit.converged);
    // 82 without vector instructions: a rounding of sums decides which side of a kink is tried.
    CHECK(fit.residual_evaluations + fit.derivative_evaluations <= 90);
    CHECK(lowest_beside(problem, fit, 0.1) > -1e-3);
  }
}

TEST_CASE("A monotone table with noise and kinks needs no more than a free one") {
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U);
  ResidualProblem problem = slider_problem(80.0, seed);
  const LeastSquaresFit free = solve_least_squares(problem, {});
  problem.shapes = {{0, kOrdinates, {0, 4, 8, 12, 16, 20}, {Shape::Monotone::kDecreasing, {}}}};
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  INFO("seed " << seed << ": " << fit.stop_sentence);
  CHECK(fit.converged);
  CHECK(fit.residual_evaluations + fit.derivative_evaluations <= 80);
  CHECK(std::is_sorted(fit.x.rbegin(), fit.x.rend()));
  // The truth falls by many errors from knot to knot: the shape does not bind.
  CHECK(fit.cost == Approx(free.cost).epsilon(1e-5));
}

TEST_CASE("With cheap derivatives a smooth fit takes one evaluation an iteration") {
  ResidualProblem problem;
  problem.rows = problem.data_rows = 5000;
  problem.unknowns = {{.start = 5.0}, {.start = 0.2, .lower = 0.0}};
  problem.residuals = [](std::span<const double>, std::span<double>) { return false; };
  problem.derivatives = [](std::span<const double> x, std::span<double> r,
                           std::span<double> jacobian) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double t = 1e-3 * static_cast<double>(i);
      const double decay = std::exp(-x[1] * t);
      const double noise = 0.1 * std::sin(17.0 * static_cast<double>(i % 97));
      r[i] = x[0] * decay - 2.0 * std::exp(-0.7 * t) - noise;
      jacobian[2 * i] = decay;
      jacobian[2 * i + 1] = -t * x[0] * decay;
    }
    return true;
  };
  const LeastSquaresFit fit = solve_least_squares(problem, {});
  INFO(fit.stop_sentence);
  CHECK(fit.converged);
  CHECK(fit.residual_evaluations == 0);
  // The start is asked for twice: for what is frozen, and by the search.
  CHECK(fit.derivative_evaluations <= fit.iterations + 2);
  CHECK(fit.iterations <= 10);
}

TEST_CASE("Products of columns give the triangle of the factorisation, or none") {
  std::vector<double> matrix;
  std::vector<double> side;
  for (std::size_t i = 0; i < 103; ++i) {
    const double t = 0.02 * static_cast<double>(i);
    matrix.insert(matrix.end(), {1.0, 1e3 * t, std::sin(3.0 * t)});
    side.push_back(std::cos(t));
  }
  const TallQr slow = tall_qr(matrix, 3, side);
  const auto fast = triangle_of(products(matrix, 3, side));
  REQUIRE(fast);
  // R is known up to the signs of its rows.
  for (int i = 0; i < 3; ++i) {
    CHECK(std::abs(fast->projection(i)) == Approx(std::abs(slow.projection(i))).epsilon(1e-10));
    for (int j = i; j < 3; ++j) {
      CHECK(std::abs(fast->triangle(i, j)) == Approx(std::abs(slow.triangle(i, j))).epsilon(1e-10));
    }
  }
  CHECK(fast->rest == Approx(slow.rest).epsilon(1e-8));
  for (std::size_t i = 0; i < 103; ++i) matrix[3 * i + 2] = matrix[3 * i] + 1e-9 * side[i];
  CHECK_FALSE(triangle_of(products(matrix, 3, side)));
}

}  // namespace
}  // namespace slipbench::driver::fit
