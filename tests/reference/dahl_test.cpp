// SPDX-License-Identifier: Apache-2.0
#include "reference/dahl.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {
const std::vector<std::vector<double>> kParameters{{20.0}, {1000.0}};
}

TEST_CASE("Dahl's force has the printed values on first loading") {
  const auto rows = evaluate("dahl", kParameters, {{0.3}, {0.31}, {0.32}, {0.35}});
  const char* forces[] = {"7.86938680574733", "12.6424111765712", "18.358300027522"};
  // The motion 0.3 carries a rounding that the stiffness turns into 1e-13.
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(rows[i + 1][0] == Approx(std::stod(forces[i])).epsilon(1e-13));
  }
  const auto from_zero = evaluate("dahl", kParameters, {{0.0}, {0.01}, {0.02}, {0.05}});
  for (std::size_t i = 0; i < 3; ++i) CHECK_THAT(from_zero[i + 1][0], printed(forces[i]));
}

TEST_CASE("Dahl's steady loop has the printed force and energy") {
  CHECK_THAT(dahl::loop_force({20.0, 1000.0}, 0.1), printed("19.9981840852519"));
  CHECK_THAT(dahl::loop_energy({20.0, 1000.0}, 0.1), printed("6.40014527317985"));
  const auto rows =
      evaluate("dahl", kParameters, {{0.0}, {0.1}, {-0.1}, {0.1}, {-0.1}, {0.1}, {-0.1}, {0.1}});
  CHECK(rows[7][0] == Approx(19.9981840852519).epsilon(1e-13));
  CHECK(rows[6][0] == Approx(-19.9981840852519).epsilon(1e-13));
  CHECK(rows[7][1] - rows[5][1] == Approx(6.40014527317985).epsilon(1e-13));
}

TEST_CASE("increments between the turning points change nothing for Dahl's force") {
  std::vector<std::vector<double>> fine{{0.0}};
  for (int i = 1; i <= 50; ++i) fine.push_back({0.001 * i});
  for (int i = 1; i <= 50; ++i) fine.push_back({0.05 - 0.0003 * i});
  double area = 0.0;
  const auto rows = evaluate("dahl", kParameters, fine);
  for (std::size_t i = 1; i < fine.size(); ++i) {
    area += 0.5 * (rows[i][0] + rows[i - 1][0]) * (fine[i][0] - fine[i - 1][0]);
  }
  const auto coarse = evaluate("dahl", kParameters, {{0.0}, {0.05}, {0.035}}).back();
  CHECK(rows.back()[0] == Approx(coarse[0]).epsilon(1e-12));
  CHECK(rows.back()[1] == Approx(coarse[1]).epsilon(1e-12));
  // Trapezoids over an exponential: (sigma du/F_c)^2/12, here du = 0.001.
  CHECK(area == Approx(coarse[1]).epsilon(1e-3));
}
