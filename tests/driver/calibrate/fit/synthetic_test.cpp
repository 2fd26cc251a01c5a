// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "driver/calibrate/fit/statistics.hpp"
#include "tests/driver/calibrate/fit/synthetic_models.hpp"

namespace slipbench::driver::fit {
namespace {

using test::Synthetic;

std::vector<Synthetic> all() {
  return {test::decay(), test::wear(), test::microslip(), test::sliders()};
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// Starts off by the factor: all up, all down, and up and down in turn, both ways. Sliders in
/// parallel can change places, but not if all of them are off alike.
std::vector<std::vector<double>> starts_of(const Synthetic& synthetic) {
  const double f = synthetic.factor;
  std::vector<std::vector<double>> starts{scaled(synthetic.truth, f),
                                          scaled(synthetic.truth, 1.0 / f)};
  std::vector<double> turns = synthetic.truth;
  std::vector<double> back = synthetic.truth;
  for (std::size_t j = 0; j < turns.size(); ++j) {
    turns[j] *= j % 2 == 0 ? f : 1.0 / f;
    back[j] *= j % 2 == 0 ? 1.0 / f : f;
  }
  starts.push_back(turns);
  starts.push_back(back);
  return starts;
}

/// The same fit by the port of MINPACK that Eigen brings, over the logarithms.
struct Minpack {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  const ResidualProblem* problem;
  int inputs() const { return static_cast<int>(problem->unknowns.size()); }
  int values() const { return static_cast<int>(problem->rows); }
  int operator()(const InputType& z, ValueType& r) const {
    const Eigen::VectorXd x = z.array().exp();
    problem->residuals({x.data(), static_cast<std::size_t>(x.size())},
                       {r.data(), static_cast<std::size_t>(r.size())});
    return 0;
  }
};

double minpack_cost(const ResidualProblem& problem) {
  Eigen::VectorXd z(static_cast<Eigen::Index>(problem.unknowns.size()));
  for (Eigen::Index j = 0; j < z.size(); ++j) {
    z(j) = std::log(problem.unknowns[static_cast<std::size_t>(j)].start);
  }
  Eigen::NumericalDiff<Minpack, Eigen::Central> minpack(Minpack{&problem});
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Minpack, Eigen::Central>> solver(minpack);
  solver.parameters.xtol = 1e-12;
  solver.parameters.ftol = 1e-14;
  solver.parameters.maxfev = 4000;
  solver.minimize(z);
  return 0.5 * solver.fvec.squaredNorm();
}

TEST_CASE("Exact data give the closed forms' parameters back to eight digits") {
  for (const Synthetic& synthetic : all()) {
    for (const std::vector<double>& start : starts_of(synthetic)) {
      const ResidualProblem problem = test::problem_of(synthetic, start, {});
      const LeastSquaresFit fit = solve_least_squares(problem, {});
      INFO(synthetic.name << " from " << start[0] << ", " << start[1] << ": " << fit.stop_sentence);
      CHECK(fit.converged);
      for (std::size_t j = 0; j < start.size(); ++j) {
        INFO("parameter " << j);
        // derivatives by differences leave the last digits open
        CHECK(fit.x[j] == Approx(synthetic.truth[j]).epsilon(1e-8));
      }
    }
  }
}

TEST_CASE("Noisy data give the parameters back within three standard errors") {
  for (const Synthetic& synthetic : all()) {
    for (const std::vector<double>& start : starts_of(synthetic)) {
      const std::vector<double> noise = test::noise_of(synthetic, 4711);
      const ResidualProblem problem = test::problem_of(synthetic, start, noise);
      const LeastSquaresFit fit = solve_least_squares(problem, {});
      const FitStatistics statistics = fit_statistics(problem, fit, 0.95);
      INFO(synthetic.name << " from " << start[0] << ", " << start[1] << ": " << fit.stop_sentence);
      CHECK(fit.converged);
      for (std::size_t j = 0; j < start.size(); ++j) {
        INFO("parameter " << j);
        CHECK(std::abs(fit.x[j] - synthetic.truth[j]) < 3.0 * statistics.standard_error[j]);
      }
    }
  }
}

TEST_CASE("Noisy data give the same least cost as MINPACK finds") {
  for (const Synthetic& synthetic : all()) {
    const std::vector<double> noise = test::noise_of(synthetic, 99);
    for (const double factor : {1.15, 1.0 / 1.15}) {
      const std::vector<double> start = scaled(synthetic.truth, factor);
      const ResidualProblem problem = test::problem_of(synthetic, start, noise);
      const LeastSquaresFit fit = solve_least_squares(problem, {});
      INFO(synthetic.name << ": " << fit.stop_sentence);
      // Kinks stop MINPACK above the minimum: never below is what it can tell there.
      const double peer = minpack_cost(problem);
      CHECK(fit.cost <= peer * (1.0 + 1e-6));
      if (synthetic.name != "parallel sliders") CHECK(fit.cost == Approx(peer).epsilon(1e-6));
    }
  }
}

}  // namespace
}  // namespace slipbench::driver::fit
