// SPDX-License-Identifier: Apache-2.0
#include "reference/harmonic_balance.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

using std::numbers::pi;

namespace {

const std::vector<std::vector<double>> kBase{{0.2}, {100.0}, {1000.0}, {0.1}, {4.0}, {3.0}};

struct Loop {
  std::vector<double> phases;
  std::vector<double> motions;
  std::vector<double> forces;
};

/// The second cycle of the Coulomb slider under u = 0.1 cos p in n pieces, from p = 2 pi on.
Loop steady_loop(int n) {
  std::vector<std::vector<double>> path;
  for (int i = 0; i <= 2 * n; ++i) path.push_back({0.1 * std::cos(2.0 * pi * i / n)});
  const auto rows =
      evaluate("coulomb_slider",
               {{0.2}, {100.0}, {1000.0}, {std::numeric_limits<double>::infinity()}}, path);
  Loop loop;
  for (int i = n; i <= 2 * n; ++i) {
    loop.phases.push_back(2.0 * pi * i / n);
    loop.motions.push_back(path[static_cast<std::size_t>(i)][0]);
    loop.forces.push_back(rows[static_cast<std::size_t>(i)][0]);
  }
  return loop;
}

}  // namespace

TEST_CASE("the harmonic balance of the Coulomb slider has the printed numbers") {
  const auto rows = evaluate("harmonic_balance", kBase, {{3.0}, {4.0}});
  CHECK_THAT(rows[0][2], printed("142.378489932647"));
  CHECK_THAT(rows[0][3], printed("203.718327157626"));
  CHECK(rows[0][4] == Approx(6.4).epsilon(1e-14));
  CHECK(rows[0][0] == Approx(0.1 * 142.378489932647).epsilon(1e-13));
  CHECK(rows[1][0] == Approx(-0.1 * 203.718327157626).epsilon(1e-13));
  CHECK(rows[0][1] == 0.1);
}

TEST_CASE("the first harmonic of a sampled loop approaches the harmonic balance") {
  const auto error = [](int n) {
    const Loop loop = steady_loop(n);
    const auto stiffness = harmonic_balance::first_harmonic(loop.phases, loop.motions, loop.forces);
    return std::hypot(stiffness.equivalent - 142.378489932647, stiffness.loss - 203.718327157626);
  };
  // Trapezoids over kinks that fall anywhere in a piece: second order with a factor that varies.
  CHECK(error(100) < 0.5);
  CHECK(error(1000) < 5e-3);
  CHECK(error(20000) < 2e-5);
}

TEST_CASE("a force that is linear in motion and velocity is its own first harmonic") {
  std::vector<double> phases;
  std::vector<double> motions;
  std::vector<double> forces;
  for (int i = 0; i <= 12; ++i) {
    const double p = 0.3 + 2.0 * pi * i / 12;
    phases.push_back(p);
    motions.push_back(0.7 + 0.2 * std::cos(p - 1.0));
    forces.push_back(50.0 * 0.2 * std::cos(p - 1.0) - 30.0 * 0.2 * std::sin(p - 1.0) +
                     4.0 * std::cos(3.0 * p) + 9.0);
  }
  const auto stiffness = harmonic_balance::first_harmonic(phases, motions, forces);
  // Trapezoids are exact for the harmonics below the number of samples.
  CHECK(stiffness.equivalent == Approx(50.0).epsilon(1e-13));
  CHECK(stiffness.loss == Approx(30.0).epsilon(1e-13));
}

TEST_CASE("the post-processor gives the last whole cycle, row by row") {
  const Loop loop = steady_loop(2000);
  // A period of 1.5 from the time 2 on; what went before does not count.
  std::vector<std::vector<double>> path{{0.5, 7.0, 7.0}};
  for (int cycle = 0; cycle < 2; ++cycle) {
    for (std::size_t i = cycle == 0 ? 0 : 1; i < loop.phases.size(); ++i) {
      // In the second cycle all forces are doubled.
      path.push_back({2.0 + 1.5 * (loop.phases[i] / (2.0 * pi) - 1.0 + cycle), loop.motions[i],
                      loop.forces[i] * (cycle + 1)});
    }
  }
  const auto rows = evaluate("first_harmonic", {{1.5}, {2.0}}, path);
  CHECK(rows[2000] == std::vector<double>{0.0, 0.0});
  // The second order error of 2000 rows.
  CHECK(rows[2001][0] == Approx(142.378489932647).epsilon(1e-5));
  CHECK(rows[2001][1] == Approx(203.718327157626).epsilon(1e-5));
  CHECK(rows[4000] == rows[2001]);
  // The jump to the doubled force counts as one row, 1/2000 of a cycle.
  CHECK(rows[4001][0] == Approx(2.0 * 142.378489932647).epsilon(1e-2));
  CHECK(rows[4001][1] == Approx(2.0 * 203.718327157626).epsilon(1e-2));
}
