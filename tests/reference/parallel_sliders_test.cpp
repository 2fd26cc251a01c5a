// SPDX-License-Identifier: Apache-2.0
#include "reference/parallel_sliders.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "reference/masing.hpp"
#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;
using parallel_sliders::Slider;

namespace {

const std::vector<Slider> kThree{{1000.0, 10.0}, {500.0, 15.0}, {250.0, 20.0}};
const std::vector<std::vector<double>> kThreeParameters{{1000.0, 500.0, 250.0}, {10.0, 15.0, 20.0}};

// Exact cases: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

}  // namespace

TEST_CASE("parallel sliders follow their backbone from rest") {
  const double motions[] = {0.01, 0.02, 0.03, 0.05, 0.08, 0.1};
  const double forces[] = {17.5, 25.0, 32.5, 37.5, 45.0, 45.0};
  std::vector<std::vector<double>> path{{0.0}};
  for (const double u : motions) path.push_back({u});
  const auto rows = evaluate("parallel_sliders", kThreeParameters, path);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(parallel_sliders::backbone(kThree, motions[i]) == exact(forces[i]));
    CHECK(parallel_sliders::backbone(kThree, -motions[i]) == exact(-forces[i]));
    CHECK(rows[i + 1][0] == exact(forces[i]));
  }
}

TEST_CASE("parallel sliders unload on Masing's branch and remember where they turned") {
  const auto backbone = [](double u) { return parallel_sliders::backbone(kThree, u); };
  const double motions[] = {0.04, 0.0, -0.1};
  const double forces[] = {-20.0, -30.0, -45.0};
  for (int i = 0; i < 3; ++i) {
    CHECK(masing::branch(backbone, 0.1, 45.0, motions[i]) == exact(forces[i]));
  }
  CHECK(masing::branch(backbone, 0.04, -20.0, 0.06) == exact(15.0));
  CHECK(masing::branch(backbone, 0.04, -20.0, 0.1) == exact(45.0));

  const auto down =
      evaluate("parallel_sliders", kThreeParameters, {{0}, {0.1}, {0.04}, {0}, {-0.1}});
  for (std::size_t i = 0; i < 3; ++i) CHECK(down[i + 2][0] == exact(forces[i]));
  const auto minor =
      evaluate("parallel_sliders", kThreeParameters, {{0}, {0.1}, {0.04}, {0.06}, {0.1}});
  CHECK(minor[3][0] == exact(15.0));
  CHECK(minor[4][0] == exact(45.0));
  CHECK(minor[4][2] - minor[1][2] == exact(0.8));
}

TEST_CASE("parallel sliders dissipate the loop energies of the formula") {
  const double amplitudes[] = {0.1, 0.05, 0.025, 0.03};
  const double energies[] = {9.4, 2.8, 0.6, 0.8};
  for (int i = 0; i < 4; ++i) {
    const double a = amplitudes[i];
    CHECK(parallel_sliders::loop_energy(kThree, a) == exact(energies[i]));
    const auto rows = evaluate("parallel_sliders", kThreeParameters, {{0}, {a}, {-a}, {a}});
    CHECK(rows[3][2] - rows[1][2] == exact(energies[i]));
  }
  CHECK(parallel_sliders::loop_energy(kThree, 0.01) == 0.0);
}

TEST_CASE("parallel sliders' work is their dissipation and their stored energy") {
  std::vector<std::vector<double>> path;
  for (int i = 0; i <= 1000; ++i) {
    const double t = 0.017 * i;
    path.push_back({0.05 * std::sin(t) + 0.04 * std::cos(3.1 * t)});
  }
  for (const auto& row : evaluate("parallel_sliders", kThreeParameters, path)) {
    // The roundings of a thousand increments add up.
    CHECK(row[4] == Approx(row[2] + row[3]).epsilon(1e-11).margin(1e-12));
  }
}

TEST_CASE("two half sliders in parallel are one Coulomb slider") {
  const std::vector<std::vector<double>> path{{0.0}, {0.05}, {0.015}, {-0.08}, {0.1}};
  const auto halves = evaluate("parallel_sliders", {{500.0, 500.0}, {10.0, 10.0}}, path);
  const auto one = evaluate("coulomb_slider", {{0.2}, {100.0}, {1000.0}, {1e300}}, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const std::size_t column : {0u, 2u, 3u, 4u}) {
      CHECK(halves[i][column] == exact(one[i][column]));
    }
    CHECK(halves[i][1] == exact(2.0 * one[i][1]));  // each of the two slips as far
  }
}

TEST_CASE("parallel sliders need as many limits as stiffnesses") {
  const std::vector<std::vector<double>> uneven{{1.0, 2.0}, {3.0}};
  const std::vector<std::vector<double>> none{{}, {}};
  CHECK(parallel_sliders::violation(uneven).value() ==
        "stick_stiffnesses has 2 entries and limits has 1; each slider needs one of both");
  CHECK(parallel_sliders::violation(none).has_value());
  CHECK_FALSE(parallel_sliders::violation(kThreeParameters).has_value());
}
