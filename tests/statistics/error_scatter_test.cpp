// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "driver/calibrate/fit/statistics.hpp"
#include "tests/driver/calibrate/fit/synthetic_models.hpp"

namespace slipbench::driver {
namespace {

TEST_CASE("Reported errors are the scatter over 200 noises") {
  constexpr int kSeeds = 200;
  for (const fit::test::Synthetic& synthetic :
       {fit::test::decay(), fit::test::wear(), fit::test::microslip(), fit::test::sliders()}) {
    const std::size_t n = synthetic.truth.size();
    std::vector<double> near_the_truth = synthetic.truth;
    for (double& value : near_the_truth) value *= 1.05;
    std::vector<double> squares(n, 0.0);
    std::vector<double> reported(n, 0.0);
    int converged = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const fit::ResidualProblem problem = fit::test::problem_of(
          synthetic, near_the_truth,
          fit::test::noise_of(synthetic, static_cast<std::uint64_t>(1000 + seed)));
      const fit::LeastSquaresFit fit = fit::solve_least_squares(problem, {});
      const fit::FitStatistics statistics = fit::fit_statistics(problem, fit, 0.95);
      converged += fit.converged ? 1 : 0;
      for (std::size_t j = 0; j < n; ++j) {
        squares[j] += std::pow(fit.x[j] - synthetic.truth[j], 2);
        reported[j] += std::pow(statistics.standard_error[j], 2);
      }
    }
    CHECK(converged == kSeeds);
    for (std::size_t j = 0; j < n; ++j) {
      INFO(synthetic.name << ", parameter " << j);
      // The scatter of 200 values is itself known to 5 %.
      CHECK(std::sqrt(reported[j] / squares[j]) == Approx(1.0).margin(0.2));
    }
  }
}

}  // namespace
}  // namespace slipbench::driver
