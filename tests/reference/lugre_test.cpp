// SPDX-License-Identifier: Apache-2.0
#include "reference/lugre.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

using lugre::Bristles;

namespace {

constexpr Bristles kBristles{1.0, 1.5, 0.001, 1e5, 316.2277660168379, 0.4};
const std::vector<std::vector<double>> kParameters{
    {1.0}, {1.5}, {0.001}, {1e5}, {316.2277660168379}, {0.4}};

}  // namespace

TEST_CASE("LuGre's steady force has the printed Stribeck curve") {
  const double velocities[] = {0.0001, 0.0005, 0.001, 0.002, 0.005};
  const char* forces[] = {"1.49506491687458", "1.3896003915357", "1.18433972058572",
                          "1.00995781944437", "1.00200000000694"};
  for (int i = 0; i < 5; ++i) {
    const double v = velocities[i];
    CHECK_THAT(lugre::steady_force(kBristles, v), printed(forces[i]));
    CHECK(lugre::steady_force(kBristles, -v) == -lugre::steady_force(kBristles, v));
    // Long after the start the integrator has come to it.
    const auto rows = evaluate("lugre", kParameters, {{0.0, 0.0}, {100.0 * v, 100.0}});
    CHECK(rows[1][0] == Approx(std::stod(forces[i])).epsilon(1e-12));
    CHECK(rows[1][1] == Approx(std::stod(forces[i])).epsilon(1e-12));
  }
}

TEST_CASE("LuGre's force has the printed values after a start, in one row or many") {
  const double times[] = {0.001, 0.005, 0.02};
  const char* forces[] = {"0.70097980308994", "0.870113485756449", "1.00280322989146"};
  for (int i = 0; i < 3; ++i) {
    const double t = times[i];
    const auto one = evaluate("lugre", kParameters, {{0.0, 0.0}, {0.002 * t, t}});
    CHECK_THAT(one[1][0], printed(forces[i]));
    std::vector<std::vector<double>> path;
    for (int j = 0; j <= 50; ++j) path.push_back({0.002 * t * j / 50, t * j / 50});
    CHECK(evaluate("lugre", kParameters, path).back()[0] ==
          Approx(std::stod(forces[i])).epsilon(1e-12));
  }
}

TEST_CASE("LuGre's integrator agrees with its differential equation under changing velocity") {
  std::vector<std::vector<double>> path;
  const double dt = 1e-3;
  for (int i = 0; i <= 60; ++i) path.push_back({2e-5 * std::sin(0.2 * i), 3.0 + dt * i});
  const auto rows = evaluate("lugre", kParameters, path);
  double z = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double v = (path[i][0] - path[i - 1][0]) / dt;
    const auto rate = [&](double at) {
      return v - 1e5 * std::abs(v) * at / lugre::stribeck_force(kBristles, v);
    };
    const int n = 100;
    const double h = dt / n;
    for (int j = 0; j < n; ++j) {
      const double k1 = rate(z);
      const double k2 = rate(z + 0.5 * h * k1);
      const double k3 = rate(z + 0.5 * h * k2);
      const double k4 = rate(z + h * k3);
      z += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
    // The rounding of a time near 3 s over a row of 1 ms dominates.
    CHECK(rows[i][2] == Approx(z).epsilon(1e-9).margin(1e-14));
    CHECK(rows[i][0] ==
          Approx(1e5 * z + 316.2277660168379 * rate(z) + 0.4 * v).epsilon(1e-9).margin(1e-9));
  }
}

TEST_CASE("LuGre's force needs time to move") {
  const auto rows =
      evaluate("lugre", kParameters, {{0.0, 0.0}, {1e-5, 0.1}, {1e-5, 0.1}, {2e-5, 0.1}});
  CHECK(rows[2] == rows[1]);
  CHECK(std::isnan(rows[3][0]));
  const std::vector<std::vector<double>> odd{{1.0}, {0.5}, {0.001}, {1e5}, {0.0}, {0.0}};
  CHECK(lugre::violation(odd).value() == "static_force must not be below coulomb_force");
}
