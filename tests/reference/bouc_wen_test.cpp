// SPDX-License-Identifier: Apache-2.0
#include "reference/bouc_wen.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

TEST_CASE("the Bouc-Wen model loads along the known exponential") {
  const auto rows = evaluate("bouc_wen", {{1000.0}, {25.0}, {25.0}, {1.0}, {0.0}},
                             {{0.0}, {0.01}, {0.02}, {0.1}, {5.0}});
  for (std::size_t i = 1; i < 5; ++i) {
    const double u = i == 4 ? 5.0 : i == 3 ? 0.1 : 0.01 * static_cast<double>(i);
    CHECK(rows[i][1] == Approx((1.0 - std::exp(-50.0 * u)) / 50.0).epsilon(1e-13));
    CHECK(rows[i][0] == Approx(1000.0 * rows[i][1]).epsilon(1e-14));
  }
  CHECK(bouc_wen::largest_hysteretic_motion({1000.0, 25.0, 25.0, 1.0, 0.0}) == 0.02);
}

TEST_CASE("with beta = gamma the Bouc-Wen model unloads along a line") {
  const auto rows = evaluate("bouc_wen", {{1000.0}, {25.0}, {25.0}, {1.0}, {0.0}},
                             {{0.0}, {5.0}, {4.99}, {4.98}, {4.97}});
  CHECK(rows[2][1] == Approx(0.01).epsilon(1e-12));
  CHECK(rows[3][1] == Approx(0.0).margin(1e-14));
  CHECK(rows[4][1] == Approx(-(1.0 - std::exp(-0.5)) / 50.0).epsilon(1e-12));
}

TEST_CASE("the Bouc-Wen model follows its differential equation on any path") {
  const double sets[][3] = {{30.0, 10.0, 1.0}, {10.0, 30.0, 0.8}, {30.0, -20.0, 1.5}};
  for (const auto& set : sets) {
    std::vector<std::vector<double>> path;
    for (int i = 0; i <= 60; ++i) path.push_back({0.05 * std::sin(0.7 * i) + 0.03 * std::cos(i)});
    const auto rows = evaluate("bouc_wen", {{1000.0}, {set[0]}, {set[1]}, {set[2]}, {0.1}}, path);
    double z = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double travel = path[i][0] - path[i - 1][0];
      const int n = 400;
      const double h = travel / n;
      // dz/du of dz = A du - beta |du| z - gamma du |z|
      const auto rate = [&](double at) {
        const double sense = travel > 0.0 ? 1.0 : -1.0;
        return set[2] - set[0] * sense * at - set[1] * std::abs(at);
      };
      for (int j = 0; j < n; ++j) {
        const double middle = z + 0.5 * h * rate(z);
        z += h * rate(middle);
      }
      // The midpoint rule is second order in 1/400 of a piece.
      CHECK(rows[i][1] == Approx(z).margin(1e-6));
      CHECK(rows[i][0] ==
            Approx(100.0 * (path[i][0] - path[0][0]) + 900.0 * rows[i][1]).margin(1e-12));
    }
  }
}

TEST_CASE("a Bouc-Wen model without a bound is refused") {
  const std::vector<std::vector<double>> odd{{1.0}, {1.0}, {-1.0}, {1.0}, {0.0}};
  CHECK(bouc_wen::violation(odd).value() ==
        "gamma must be above -beta, else the hysteretic motion has no bound");
}
