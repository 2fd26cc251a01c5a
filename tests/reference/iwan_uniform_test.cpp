// SPDX-License-Identifier: Apache-2.0
#include "reference/iwan_uniform.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "reference/parallel_sliders.hpp"
#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;
using parallel_sliders::Slider;

namespace {

const std::vector<std::vector<double>> kParameters{{1000.0}, {20.0}};

// Exact cases: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

/// n equal sliders that yield at the middles of n classes of the motions 0 .. 0.04.
std::vector<Slider> classes(int n) {
  std::vector<Slider> sliders;
  for (int i = 0; i < n; ++i) {
    sliders.push_back({1000.0 / n, 1000.0 / n * 0.04 * (i + 0.5) / n});
  }
  return sliders;
}

}  // namespace

TEST_CASE("a uniform Iwan model has its known backbone and loop energies") {
  const iwan_uniform::Joint iwan{1000.0, 20.0};
  CHECK(iwan_uniform::backbone(iwan, 0.01) == exact(8.75));
  CHECK(iwan_uniform::backbone(iwan, 0.02) == exact(15.0));
  CHECK(iwan_uniform::backbone(iwan, -0.03) == exact(-18.75));
  CHECK(iwan_uniform::backbone(iwan, 0.04) == exact(20.0));
  CHECK(iwan_uniform::backbone(iwan, 0.1) == exact(20.0));
  CHECK(iwan_uniform::loop_energy(iwan, 0.01) == exact(1.0 / 60.0));
  CHECK(iwan_uniform::loop_energy(iwan, 0.02) == exact(2.0 / 15.0));
  CHECK(iwan_uniform::loop_energy(iwan, 0.04) == exact(16.0 / 15.0));
  CHECK(iwan_uniform::loop_energy(iwan, 0.06) == exact(8.0 / 3.0));
}

TEST_CASE("equal sliders approach the uniform Iwan model with the square of their number") {
  const iwan_uniform::Joint iwan{1000.0, 20.0};
  const auto error = [&](int n) {
    const auto sliders = classes(n);
    // At the middle of a class the error is largest, at its edges it is nil.
    const double u = 0.04 * (n / 2 + 0.5) / n;
    return std::abs(parallel_sliders::backbone(sliders, u) - iwan_uniform::backbone(iwan, u));
  };
  // The error is exactly proportional to 1/n^2; what remains is rounding against the small error.
  CHECK(error(10) / error(20) == Approx(4.0).epsilon(1e-9));
  CHECK(error(20) / error(40) == Approx(4.0).epsilon(1e-9));
}

TEST_CASE(
    "the loop energy of equal sliders approaches the uniform Iwan model's as their force does") {
  const iwan_uniform::Joint iwan{1000.0, 20.0};
  const auto error = [&](int n) {
    return parallel_sliders::loop_energy(classes(n), 0.04) - iwan_uniform::loop_energy(iwan, 0.04);
  };
  CHECK(error(10) / error(20) == Approx(4.0).epsilon(1e-9));
  CHECK(error(20) / error(40) == Approx(4.0).epsilon(1e-9));
}

TEST_CASE("a uniform Iwan joint closes its loops and remembers where it turned") {
  const auto rows =
      evaluate("iwan_uniform", kParameters,
               {{0}, {0.03}, {0.01}, {0.02}, {0.01}, {0.03}, {0.04}, {-0.04}, {0.0}, {0.04}});
  CHECK(rows[1][0] == exact(18.75));
  CHECK(rows[2][0] == exact(18.75 - 2.0 * 8.75));
  CHECK(rows[4][0] == exact(rows[2][0]));
  CHECK(rows[4][1] - rows[2][1] == exact(1000.0 * 1000.0 * 0.005 * 0.005 * 0.005 / 60.0));
  CHECK(rows[5][0] == exact(18.75));
  CHECK(rows[5][1] - rows[1][1] == exact(1.0 / 60.0 + 1.0 / 480.0));
  CHECK(rows[6][0] == exact(20.0));
  CHECK(rows[7][0] == exact(-20.0));
  CHECK(rows[9][0] == exact(20.0));
  CHECK(rows[9][1] - rows[6][1] == exact(16.0 / 15.0));
  CHECK(rows[9][3] - rows[6][3] == exact(16.0 / 15.0));
}

TEST_CASE("a uniform Iwan joint follows many equal sliders on any path") {
  std::vector<double> stiffnesses;
  std::vector<double> limits;
  for (const Slider& slider : classes(1000)) {
    stiffnesses.push_back(slider.stick_stiffness);
    limits.push_back(slider.limit);
  }
  std::vector<std::vector<double>> path;
  for (int i = 0; i < 150; ++i) {
    path.push_back({0.3 + 0.03 * std::sin(1.1 * i) + 0.025 * std::cos(0.37 * i)});
  }
  const auto joint = evaluate("iwan_uniform", kParameters, path);
  const auto sliders = evaluate("parallel_sliders", {stiffnesses, limits}, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    // 1/n^2 of the yield force, and of the energy of a loop times the number of loops.
    CHECK(joint[i][0] == Approx(sliders[i][0]).margin(2e-5));
    CHECK(joint[i][1] == Approx(sliders[i][2]).epsilon(1e-5).margin(1e-5));
    CHECK(joint[i][2] == Approx(sliders[i][3]).margin(2e-5));
    CHECK(joint[i][3] == Approx(sliders[i][4]).epsilon(1e-5).margin(1e-5));
  }
}

TEST_CASE("increments between the turning points change nothing for a uniform Iwan joint") {
  const std::vector<double> turns{0.0, 0.03, 0.005, 0.02, -0.035, 0.05};
  std::vector<std::vector<double>> coarse;
  std::vector<std::vector<double>> fine;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    coarse.push_back({turns[i]});
    for (int j = 1; i > 0 && j < 7; ++j) {
      fine.push_back({turns[i - 1] + (turns[i] - turns[i - 1]) * j / 7});
    }
    fine.push_back({turns[i]});
  }
  const auto a = evaluate("iwan_uniform", kParameters, coarse).back();
  const auto b = evaluate("iwan_uniform", kParameters, fine).back();
  // Forty increments' roundings add up.
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(b[i] == Approx(a[i]).epsilon(1e-12));
}
