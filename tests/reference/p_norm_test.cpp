// SPDX-License-Identifier: Apache-2.0
#include "reference/p_norm.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::p_norm;
using std::numbers::pi;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

/// The force on the curve P = limit at the angle of its scaled components.
Pair on_limit(double limit, double p, double angle) {
  const double x[] = {std::cos(angle), std::sin(angle)};
  const double size = norm(x, p);
  return {limit * x[0] / size, limit * x[1] / size};
}

}  // namespace

TEST_CASE("the spot weld's potential has the printed magnitude") {
  const auto row = evaluate(kNormForm, {{1.5}, {0.02, 0.05}}, {{3.56561, 2.31606, 9.0}}).back();
  CHECK_THAT(row[0], printed("193.693"));
  CHECK(row[1] == exact(3.56561 / 0.02));
}

TEST_CASE("a p-norm adds, takes the root of squares, and tends to the maximum") {
  const double x[] = {3.0, -4.0};
  CHECK(norm(x, 1.0) == exact(7.0));
  CHECK(norm(x, 2.0) == exact(5.0));
  CHECK(norm(x, kInfinity) == 4.0);
  CHECK(norm(x, 500.0) == exact(4.0));
  const double huge[] = {3e300, 4e300};
  CHECK(norm(huge, 3.0) == exact(std::cbrt(91.0) * 1e300));
  const double none[] = {0.0, 0.0};
  CHECK(norm(none, 1.5) == 0.0);
  CHECK(evaluate(kNormForm, {{2.0}, {1.0, 1.0, 0.5}}, {{2.0, 3.0, 3.0}}).back()[0] == exact(7.0));
  CHECK(kNormForm.violation(std::vector<std::vector<double>>{{2.0}, {1, 1, 1, 1}}).has_value());
}

TEST_CASE("steady slip with the exponent 2 follows the direction of slip") {
  const auto slip = steady_slip(105.0, 2.0, {1.0, 0.24}, {0.3, 1.25});
  CHECK_THAT(slip.force.first, printed("74.2462120245875"));
  CHECK_THAT(slip.force.second, printed("17.819090885901"));
  CHECK_THAT(slip.power, printed("44.5477272147525"));
}

TEST_CASE("steady slip dissipates the most that the limit allows") {
  for (const double p : {1.2, 1.5, 2.0, 3.0, 8.0, kInfinity}) {
    for (const double angle : {0.1, 0.8, 1.3, 2.5, -1.0}) {
      const Pair scale{2.0, 0.7};
      const Pair rate{std::cos(angle), std::sin(angle)};
      const auto slip = steady_slip(20.0, p, scale, rate);
      const double x[] = {slip.force.first / scale.first, slip.force.second / scale.second};
      CHECK(norm(x, p) == Approx(20.0).epsilon(1e-12));
      CHECK(slip.force.first * rate.first + slip.force.second * rate.second ==
            Approx(slip.power).epsilon(1e-12));
      double most = 0.0;
      for (int i = 0; i < 2000; ++i) {
        const Pair y = on_limit(20.0, p, 2.0 * pi * i / 2000);
        most = std::max(most,
                        y.first * scale.first * rate.first + y.second * scale.second * rate.second);
      }
      CHECK(most <= slip.power * (1.0 + 1e-12));
      // Two thousand directions; where a corner of the limit lies between two, they miss the first
      // power of the spacing.
      CHECK(most == Approx(slip.power).epsilon(4e-3));
    }
  }
}

TEST_CASE("an elastic slider with a p-norm settles to the force of steady slip") {
  // Rate form f' = k (u' - lambda dP/df) with P held at the limit, by small explicit steps that are
  // pulled back onto the limit; it rests where the closed form says.
  const double p = 1.5;
  const double limit = 20.0;
  const Pair rate{0.8, 0.6};
  Pair f = on_limit(limit, p, 0.2);
  for (int i = 0; i < 10000; ++i) {
    const double x[] = {f.first, f.second};
    const double size = norm(x, p);
    const Pair normal{std::copysign(std::pow(std::abs(f.first) / size, p - 1.0), f.first),
                      std::copysign(std::pow(std::abs(f.second) / size, p - 1.0), f.second)};
    const double lambda = (normal.first * rate.first + normal.second * rate.second) /
                          (normal.first * normal.first + normal.second * normal.second);
    const double step = 0.1;
    f.first += step * (rate.first - lambda * normal.first);
    f.second += step * (rate.second - lambda * normal.second);
    const double moved[] = {f.first, f.second};
    const double back = limit / norm(moved, p);
    f = {f.first * back, f.second * back};
  }
  const auto steady = steady_slip(limit, p, {1.0, 1.0}, rate);
  // The transient has died out; its rounding noise is left.
  CHECK(f.first == Approx(steady.force.first).epsilon(1e-9));
  CHECK(f.second == Approx(steady.force.second).epsilon(1e-9));
}

TEST_CASE("a p-norm slider takes the direction of the last motion") {
  const auto rows = evaluate(kSliderForm, {{1.5}, {0.2}, {100.0}, {1.0}, {1.0}},
                             {{0.5, 0.5}, {0.6, 0.5}, {0.6, 0.5}, {0.6, 0.2}, {0.5, 0.1}});
  CHECK(rows[0] == std::vector<double>{0.0, 0.0});
  CHECK(rows[1][0] == exact(20.0));
  CHECK(rows[1][1] == 0.0);
  CHECK(rows[2] == rows[1]);
  CHECK(rows[3][1] == exact(-20.0));
  CHECK(rows[4][0] == exact(-20.0 / std::pow(2.0, 2.0 / 3.0)));
  CHECK(rows[4][1] == exact(rows[4][0]));
  // Any force inside the box would do where nothing slips; none is taken.
  const auto resting = steady_slip(20.0, kInfinity, {1.0, 1.0}, {0.0, -3.0});
  CHECK(resting.force.first == 0.0);
  CHECK(resting.force.second == -20.0);
  CHECK(steady_slip(20.0, 1.5, {1.0, 1.0}, {0.0, 0.0}).power == 0.0);
  CHECK(kSliderForm.violation(std::vector<std::vector<double>>{{1.0}, {0.2}, {100.0}, {1}, {1}})
            .has_value());
}

TEST_CASE("a maximum makes two independent Coulomb sliders") {
  const auto rows = evaluate(kBoxForm, {{0.2}, {100.0}, {1000.0}, {1.0}, {0.5}},
                             {{0.0, 0.0}, {0.05, 0.02}, {0.05, 0.1}, {0.045, 0.1}});
  CHECK(rows[1][0] == exact(20.0));
  CHECK(rows[1][1] == exact(1000.0 * 0.25 * 0.02));
  CHECK(rows[2][0] == exact(20.0));
  CHECK(rows[2][1] == exact(10.0));
  CHECK(rows[3][0] == exact(15.0));
  // 20 over 0.03 and 10 over 0.1 - 0.04.
  CHECK(rows[3][2] == exact(0.6 + 0.6));
  CHECK(rows[3][3] == exact(15.0 * 15.0 / 2000.0 + 10.0 * 10.0 / 500.0));
  const auto steady = steady_slip(20.0, kInfinity, {1.0, 0.5}, {0.01, 0.3});
  CHECK(steady.force.first == exact(rows[2][0]));
  CHECK(steady.force.second == exact(rows[2][1]));
}
