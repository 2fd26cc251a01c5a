// SPDX-License-Identifier: Apache-2.0
#include "reference/coulomb_slider.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using coulomb_slider::Slider;

namespace {

constexpr Slider kBase{1000.0, 20.0};
const std::vector<std::vector<double>> kBaseParameters{
    {0.2}, {100.0}, {1000.0}, {std::numeric_limits<double>::infinity()}};

// Exact cases: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-15); }

// Exact formulas over many increments: roundings of about one unit in the last place each add up.
Approx summed(double value) { return Approx(value).epsilon(1e-11).margin(1e-12); }

}  // namespace

TEST_CASE("a Coulomb slider sticks up to its limit and slips beyond") {
  CHECK(coulomb_slider::limit(0.2, 100.0) == exact(20.0));
  const auto rows = evaluate("coulomb_slider", kBaseParameters, {{0.0}, {0.01}, {0.02}, {0.1}});
  CHECK(rows[0] == std::vector<double>(5, 0.0));
  CHECK(rows[1][0] == exact(10.0));
  CHECK(rows[1][1] == 0.0);
  CHECK(rows[2][0] == exact(20.0));
  CHECK(rows[2][1] == 0.0);
  CHECK(rows[3][0] == exact(20.0));
  CHECK(rows[3][1] == exact(0.08));
}

TEST_CASE("a Coulomb slider's path starts free of force wherever its motion starts") {
  const auto rows = evaluate("coulomb_slider", kBaseParameters, {{5.0}, {5.01}, {5.1}});
  CHECK(rows[0][0] == 0.0);
  // The motion 5 carries a rounding of 1e-15, which the stiffness turns into 1e-12.
  CHECK(rows[1][0] == Approx(10.0).epsilon(1e-12));
  CHECK(rows[2][1] == Approx(0.08).epsilon(1e-12));
}

TEST_CASE("a Coulomb slider's totals over a triangle are those of the loop") {
  const auto rows = evaluate("coulomb_slider", kBaseParameters, {{0.0}, {0.1}, {-0.1}, {0.1}});
  CHECK(rows[1][1] == exact(0.08));
  CHECK(rows[2][1] == exact(0.24));
  CHECK(rows[3][1] == exact(0.40));
  CHECK(rows[3][2] == exact(8.0));
  CHECK(rows[3][2] - rows[1][2] == exact(6.4));
}

TEST_CASE("a Coulomb slider's loop has its known corners, energy and slip") {
  const auto corners = coulomb_slider::loop_vertices(kBase, 0.1);
  const double motions[] = {0.1, 0.06, -0.1, -0.06};
  const double forces[] = {20.0, -20.0, -20.0, 20.0};
  std::vector<std::vector<double>> path{{0.0}};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(corners[i].motion == exact(motions[i]));
    CHECK(corners[i].force == forces[i]);
    path.push_back({corners[i].motion});
  }
  const auto rows = evaluate("coulomb_slider", kBaseParameters, path);
  for (std::size_t i = 0; i < 4; ++i) CHECK(rows[i + 1][0] == exact(forces[i]));
  CHECK(coulomb_slider::loop_energy(kBase, 0.1) == exact(6.4));
  CHECK(coulomb_slider::loop_slip(kBase, 0.1) == exact(0.32));
  CHECK(coulomb_slider::loop_energy(kBase, 0.02) == 0.0);
  CHECK(coulomb_slider::loop_energy(kBase, 0.01) == 0.0);
}

TEST_CASE("a Coulomb slider's harmonic balance has the printed numbers and the loop's energy") {
  const auto balance = coulomb_slider::harmonic_balance(kBase, 0.1);
  CHECK_THAT(balance.slip_angle, printed("0.927295218001612"));
  CHECK_THAT(balance.equivalent_stiffness, printed("142.378489932647"));
  CHECK_THAT(balance.loss_stiffness, printed("203.718327157626"));
  CHECK(std::numbers::pi * balance.loss_stiffness * 0.01 == exact(6.4));
  CHECK(coulomb_slider::harmonic_balance(kBase, 0.02).loss_stiffness == 0.0);
  CHECK(coulomb_slider::harmonic_balance(kBase, 0.01).equivalent_stiffness == 1000.0);
}

TEST_CASE("a force limit caps a Coulomb slider") {
  auto parameters = kBaseParameters;
  parameters[3] = {15.0};
  const auto rows = evaluate("coulomb_slider", parameters, {{0.0}, {0.015}, {0.1}});
  CHECK(rows[1][0] == exact(15.0));
  CHECK(rows[1][1] == 0.0);
  CHECK(rows[2][0] == exact(15.0));
  CHECK(rows[2][1] == exact(0.085));
}

TEST_CASE("a Coulomb slider without a limit neither resists nor slips") {
  auto parameters = kBaseParameters;
  parameters[0] = {0.0};
  for (const auto& row : evaluate("coulomb_slider", parameters, {{0.0}, {0.1}, {-0.3}})) {
    CHECK(row == std::vector<double>(5, 0.0));
  }
}

TEST_CASE("a Coulomb slider's work is its dissipation and its stored energy") {
  std::vector<std::vector<double>> path;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.013 * i;
    path.push_back({0.05 * std::sin(t) + 0.06 * std::sin(2.7 * t + 0.3)});
  }
  double slip = 0.0;
  for (const auto& row : evaluate("coulomb_slider", kBaseParameters, path)) {
    CHECK(row[4] == summed(row[2] + row[3]));
    CHECK(std::abs(row[0]) <= 20.0);
    CHECK(row[1] >= slip);
    slip = row[1];
  }
  CHECK(slip > 1.0);
}

TEST_CASE("increments between the turning points change nothing for a Coulomb slider") {
  const std::vector<double> turns{0.0, 0.07, -0.03, 0.01, -0.1, 0.2};
  std::vector<std::vector<double>> coarse;
  std::vector<std::vector<double>> fine;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    coarse.push_back({turns[i]});
    if (i > 0) {
      for (int j = 1; j < 7; ++j)
        fine.push_back({turns[i - 1] + (turns[i] - turns[i - 1]) * j / 7});
    }
    fine.push_back({turns[i]});
  }
  const auto a = evaluate("coulomb_slider", kBaseParameters, coarse).back();
  const auto b = evaluate("coulomb_slider", kBaseParameters, fine).back();
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(b[i] == summed(a[i]));
}
