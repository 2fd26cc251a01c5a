// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/helical_capstan.hpp"
#include "reference/moving_belt.hpp"
#include "reference/power_law_capstan.hpp"
#include "reference/v_groove_capstan.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using std::numbers::pi;

namespace {

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

}  // namespace

TEST_CASE("a V-groove raises the coefficient to the printed value") {
  const double angle = 38.0 / 180.0 * pi;
  CHECK_THAT(v_groove_capstan::apparent_coefficient(0.3, angle), printed("0.921466046027173"));
  const auto row = evaluate(v_groove_capstan::kForm, {{0.3}, {pi}, {angle}}, {{50.0}}).back();
  CHECK(row[2] == exact(50.0 * std::exp(0.921466046027173 * pi)));
  CHECK(row[3] == exact(50.0 * std::exp(-0.921466046027173 * pi)));
  const auto flat = evaluate(v_groove_capstan::kForm, {{0.3}, {pi}, {pi}}, {{50.0}}).back();
  CHECK(flat[4] == exact(0.3 * pi));
}

TEST_CASE("a moving belt has the printed tension and leaves its pulley at high speed") {
  CHECK_THAT(moving_belt::far_tension(0.3 * pi, 200.0, 50.0, 1.0), printed("434.94985928122"));
  CHECK(moving_belt::far_tension(0.3 * pi, 434.94985928122, 50.0, -1.0) == exact(200.0));
  const auto rows = evaluate(moving_belt::kForm, {{0.3}, {pi}, {0.5}},
                             {{200.0, 10.0}, {200.0, -10.0}, {200.0, 0.0}, {200.0, 20.0}});
  CHECK_THAT(rows[0][2], printed("434.94985928122"));
  CHECK(rows[1] == rows[0]);
  CHECK(rows[2][2] == exact(200.0 * std::exp(0.3 * pi)));
  CHECK(rows[3][0] == 0.0);
  CHECK(rows[3][2] == 200.0);
}

TEST_CASE("a helical belt has the printed ratio") {
  const auto row =
      evaluate(helical_capstan::kForm, {{0.2}, {4.0 * pi}, {pi / 6.0}}, {{1.0}}).back();
  CHECK_THAT(row[2], printed("8.81592052121342"));
  CHECK(helical_capstan::turning_angle(3.0, 0.0) == 3.0);

  // The turning of a helix's tangent, added up over small chords.
  const double psi = pi / 6.0;
  const auto tangent = [&](double angle) {
    return capstan::Position{-std::sin(angle) * std::cos(psi), std::cos(angle) * std::cos(psi),
                             std::sin(psi)};
  };
  double turning = 0.0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const auto t0 = tangent(4.0 * pi * i / n);
    const auto t1 = tangent(4.0 * pi * (i + 1) / n);
    turning += capstan::wrap_angle({0, 0, 0}, t0, {t0[0] + t1[0], t0[1] + t1[1], t0[2] + t1[2]});
  }
  // Chords fall short by the square of the step.
  CHECK(turning == Approx(helical_capstan::turning_angle(4.0 * pi, psi)).epsilon(1e-5));
}

TEST_CASE("pressure-dependent belt friction has the printed tensions and apparent coefficients") {
  const double tensions[] = {1.0, 10.0, 100.0};
  const char* rising[] = {"4.3435040361548", "32.6652989463711", "258.945960123606"};
  const char* apparent[] = {"0.467495810533995", "0.376792397254507", "0.302855688398301"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row =
        evaluate(power_law_capstan::kForm, {{0.4}, {0.9}, {10.0}, {pi}}, {{tensions[i]}}).back();
    CHECK_THAT(row[2], printed(rising[i]));
    CHECK_THAT(row[4], printed(apparent[i]));
    CHECK(row[0] == exact(row[2] - tensions[i]));
    const auto back =
        evaluate(power_law_capstan::kForm, {{0.4}, {0.9}, {10.0}, {pi}}, {{row[2]}}).back();
    CHECK(back[3] == Approx(tensions[i]).epsilon(1e-12));
  }
}

TEST_CASE("pressure-dependent belt friction solves its differential equation") {
  // dT/dalpha = a R^(1-n) T^n by Runge and Kutta.
  const auto slope = [](double t) { return 0.4 * std::pow(10.0, 0.1) * std::pow(t, 0.9); };
  double t = 10.0;
  const int n = 200;
  const double h = pi / n;
  for (int i = 0; i < n; ++i) {
    const double k1 = slope(t);
    const double k2 = slope(t + 0.5 * h * k1);
    const double k3 = slope(t + 0.5 * h * k2);
    const double k4 = slope(t + h * k3);
    t += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  // The method's fourth-order error dominates.
  CHECK(t == Approx(32.6652989463711).epsilon(1e-9));
}

TEST_CASE("pressure-dependent belt friction tends to the capstan, and its tension can run out") {
  for (const double n : {1.0, 1.0 - 1e-9}) {
    const auto row =
        evaluate(power_law_capstan::kForm, {{0.2}, {n}, {1.0}, {pi}}, {{100.0}}).back();
    // At 1 - n = 1e-9 the law itself differs by about that much.
    CHECK(row[2] == Approx(187.445608758534).epsilon(1e-8));
    CHECK(row[3] == Approx(53.3488091091103).epsilon(1e-8));
  }
  const auto rows =
      evaluate(power_law_capstan::kForm, {{1.0}, {0.5}, {1.0}, {pi}}, {{2.0}, {0.0}, {-1.0}});
  CHECK(rows[0][3] == 0.0);
  CHECK(rows[1][2] == 0.0);
  CHECK(rows[2][2] == -1.0);
}
