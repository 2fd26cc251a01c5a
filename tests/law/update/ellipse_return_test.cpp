// SPDX-License-Identifier: Apache-2.0
#include "law/update/ellipse_return.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/dice.hpp"

namespace {

using namespace slipbench::law;
using slipbench::test::Dice;

double length(const PlaneVector& v) { return std::hypot(v[0], v[1]); }
double level(const PlaneVector& f, const PlaneVector& a) {
  return std::hypot(f[0] / a[0], f[1] / a[1]);
}
PlaneVector scaled(const PlaneVector& v, double factor) { return {v[0] * factor, v[1] * factor}; }
void check_near(const PlaneVector& value, const PlaneVector& expected, double tolerance) {
  CHECK(std::abs(value[0] - expected[0]) <= tolerance);
  CHECK(std::abs(value[1] - expected[1]) <= tolerance);
}

const PlaneVector kBounds{30.0, 10.0};

TEST_CASE("the trial of the reference comes back to the closest point and to that of the program") {
  const double f = 30.0 * std::numbers::sqrt2;  // printed as 42.42640687
  // The reference is printed with twelve digits behind the point.
  check_near(closest_on_ellipse({f, f}, kBounds), {24.687131330648, 5.681798880473}, 1e-12);
  check_near(ratio_on_ellipse({f, f}, kBounds), {26.939972582437, 4.399973197615}, 1e-12);
}

TEST_CASE("a force inside stays as it is, bit by bit") {
  for (const PlaneVector f : {PlaneVector{29.9, 0.1}, PlaneVector{-3.0, 9.0}, PlaneVector{}}) {
    CHECK(closest_on_ellipse(f, kBounds) == f);
    CHECK(ratio_on_ellipse(f, kBounds) == f);
  }
}

TEST_CASE("a returned force is not returned again") {
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    const PlaneVector a{dice.between(0.1, 50.0), dice.between(0.1, 50.0)};
    const PlaneVector trial{dice.between(-200.0, 200.0), dice.between(-200.0, 200.0)};
    for (const PlaneVector f : {closest_on_ellipse(trial, a), ratio_on_ellipse(trial, a)}) {
      REQUIRE(within_ellipse(f, a));
      REQUIRE(closest_on_ellipse(f, a) == f);
    }
  }
}

TEST_CASE("the closest point is on the ellipse, and what is left of the trial is normal to it") {
  Dice dice(11);
  for (int i = 0; i < 5000; ++i) {
    // Half axes up to twelve decades apart, trials up to eight decades outside.
    const PlaneVector a{1.0, std::pow(10.0, dice.between(-12.0, 0.0))};
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const double out = 1.0 + std::pow(10.0, dice.between(-8.0, 8.0));
    const PlaneVector trial{out * a[0] * std::cos(angle), out * a[1] * std::sin(angle)};
    const PlaneVector f = closest_on_ellipse(trial, a);
    // Rounding of the point and of the check.
    REQUIRE(std::abs(level(f, a) - 1.0) <= 4e-15);
    const PlaneVector normal{f[0] / (a[0] * a[0]), f[1] / (a[1] * a[1])};
    const PlaneVector rest{trial[0] - f[0], trial[1] - f[1]};
    const double turned = rest[0] * normal[1] - rest[1] * normal[0];
    // The rest is a difference: it has the rounding of the trial, which the normal magnifies.
    const double rounding =
        8e-16 * (std::abs(trial[0] * normal[1]) + std::abs(trial[1] * normal[0]));
    REQUIRE(std::abs(turned) <= 4.0 * rounding);
    REQUIRE(rest[0] * normal[0] + rest[1] * normal[1] > -rounding);
  }
}

TEST_CASE("no other point of the ellipse is closer to the trial") {
  Dice dice(13);
  for (int i = 0; i < 300; ++i) {
    const PlaneVector a{dice.between(0.2, 3.0), dice.between(0.2, 3.0)};
    const PlaneVector trial{dice.between(-9.0, 9.0), dice.between(-9.0, 9.0)};
    if (within_ellipse(trial, a)) continue;
    const PlaneVector f = closest_on_ellipse(trial, a);
    const double distance = std::hypot(trial[0] - f[0], trial[1] - f[1]);
    for (int k = 0; k < 720; ++k) {
      const double angle = k * std::numbers::pi / 360.0;
      const double other =
          std::hypot(trial[0] - a[0] * std::cos(angle), trial[1] - a[1] * std::sin(angle));
      REQUIRE(other >= distance * (1.0 - 1e-14));  // rounding
    }
  }
}

TEST_CASE("equal half axes give the radial return") {
  Dice dice(17);
  for (int i = 0; i < 2000; ++i) {
    const double a = std::pow(10.0, dice.between(-6.0, 6.0));
    const double out = a * std::pow(10.0, dice.between(0.0, 10.0));
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const PlaneVector n{std::cos(angle), std::sin(angle)};
    const PlaneVector trial = scaled(n, out);
    // Rounding.
    check_near(closest_on_ellipse(trial, {a, a}), scaled(n, a), 1e-15 * a);
    check_near(ratio_on_ellipse(trial, {a, a}), scaled(n, a), 1e-15 * a);
    check_near(steady_on_ellipse(n, {a, a}), scaled(n, a), 1e-15 * a);
  }
}

TEST_CASE("the size of the numbers does not matter") {
  const PlaneVector trial{80.0, -55.0};
  const PlaneVector closest = closest_on_ellipse(trial, kBounds);
  const PlaneVector ratio = ratio_on_ellipse(trial, kBounds);
  const PlaneVector steady = steady_on_ellipse(trial, kBounds);
  for (const double size : {1e-300, 1e-150, 1e-9, 1e9, 1e150, 1e300}) {
    const PlaneVector a = scaled(kBounds, size);
    // Rounding of a few operations.
    check_near(scaled(closest_on_ellipse(scaled(trial, size), a), 1.0 / size), closest, 1e-13);
    check_near(scaled(ratio_on_ellipse(scaled(trial, size), a), 1.0 / size), ratio, 1e-13);
    check_near(scaled(steady_on_ellipse(trial, a), 1.0 / size), steady, 1e-13);
    check_near(steady_on_ellipse(scaled(trial, size), kBounds), steady, 1e-13);
  }
}

TEST_CASE("far outside the closest point is the steady force") {
  const PlaneVector steady = steady_on_ellipse({1.0, 1.0}, kBounds);
  // Printed with twelve digits behind the point.
  check_near(steady, {28.460498941515, 3.162277660168}, 1e-12);
  for (const double out : {1e12, 1e100, 1e307}) {
    // The closest point differs from its limit by a^2/out.
    check_near(closest_on_ellipse({out, out}, kBounds), steady, 2e2 / 1e12);
    check_near(closest_on_ellipse({out, out}, scaled(kBounds, 1e-5)), scaled(steady, 1e-5),
               2e-3 / 1e12);
  }
  CHECK(steady_on_ellipse({0.0, 0.0}, kBounds) == PlaneVector{});
  CHECK(steady_on_ellipse({1.0, 1.0}, {0.0, 0.0}) == PlaneVector{});
}

TEST_CASE("without a bound along one axis the other is bounded alone") {
  for (const auto& to_ellipse : {closest_on_ellipse, ratio_on_ellipse}) {
    CHECK(to_ellipse({5.0, 4.0}, {0.0, 3.0}) == PlaneVector{0.0, 3.0});
    CHECK(to_ellipse({5.0, -2.0}, {0.0, 3.0}) == PlaneVector{0.0, -2.0});
    CHECK(to_ellipse({-5.0, 2.0}, {4.0, 0.0}) == PlaneVector{-4.0, 0.0});
    CHECK(to_ellipse({-5.0, 2.0}, {1e-4, 0.0}) == PlaneVector{-1e-4, 0.0});
    CHECK(to_ellipse({-5.0, 2.0}, {0.0, 0.0}) == PlaneVector{});
  }
  CHECK(within_ellipse({0.0, 2.0}, {0.0, 3.0}));
  CHECK_FALSE(within_ellipse({1e-9, 2.0}, {0.0, 3.0}));
}

TEST_CASE("a trial on an axis is cut on that axis, either way round") {
  for (const auto& to_ellipse : {closest_on_ellipse, ratio_on_ellipse}) {
    check_near(to_ellipse({-70.0, 0.0}, kBounds), {-30.0, 0.0}, 4e-15);
    check_near(to_ellipse({0.0, 70.0}, kBounds), {0.0, 10.0}, 2e-15);
    const PlaneVector f = to_ellipse({40.0, 20.0}, kBounds);
    CHECK(to_ellipse({-40.0, 20.0}, kBounds) == PlaneVector{-f[0], f[1]});
    CHECK(to_ellipse({40.0, -20.0}, kBounds) == PlaneVector{f[0], -f[1]});
    const PlaneVector swapped = to_ellipse({20.0, 40.0}, {10.0, 30.0});
    check_near(swapped, {f[1], f[0]}, 1e-14);
  }
}

TEST_CASE("the program's return follows its own formulas") {
  Dice dice(19);
  for (int i = 0; i < 2000; ++i) {
    const PlaneVector a{dice.between(1.0, 9.0), dice.between(1.0, 9.0)};
    const PlaneVector f{dice.between(-30.0, 30.0), dice.between(-30.0, 30.0)};
    if (within_ellipse(f, a)) continue;
    const PlaneVector q{f[0] / (a[0] * a[0]), f[1] / (a[1] * a[1])};
    const double e = q[0] * f[0] + q[1] * f[1];
    const double part = (e - std::sqrt(e)) / (q[0] * q[0] + q[1] * q[1]);
    const PlaneVector g{f[0] - q[0] * part, f[1] - q[1] * part};
    const double angle = std::atan(std::abs(g[1] / g[0]));
    const double radius = ellipse_radius({std::cos(angle), std::sin(angle)}, a);
    const PlaneVector expected{std::copysign(radius * std::cos(angle), f[0]),
                               std::copysign(radius * std::sin(angle), f[1])};
    // The formula subtracts large terms: e of rounding, at most 9^2 30^2 / 1.
    check_near(ratio_on_ellipse(f, a), expected, 1e-11);
  }
}

TEST_CASE("the changes of both returns meet difference quotients") {
  Dice dice(23);
  const auto compare = [&](const auto& point, const auto& change, const PlaneVector& trial,
                           const PlaneVector& a) {
    for (std::size_t k = 0; k < 4; ++k) {
      PlaneVector dt{}, da{};
      (k < 2 ? dt[k] : da[k - 2]) = 1.0;
      const double h = 1e-5;
      const auto at = [&](double x) {
        return point({trial[0] + x * dt[0], trial[1] + x * dt[1]},
                     {a[0] + x * da[0], a[1] + x * da[1]});
      };
      const PlaneVector up = at(h), down = at(-h);
      // Central differences: h^2 times the third derivative of numbers of size one.
      check_near(change(trial, a, dt, da),
                 {(up[0] - down[0]) / (2 * h), (up[1] - down[1]) / (2 * h)}, 2e-8);
    }
  };
  for (int i = 0; i < 200; ++i) {
    const PlaneVector a{dice.between(1.0, 3.0), dice.between(1.0, 3.0)};
    const PlaneVector trial{dice.between(-6.0, 6.0), dice.between(-6.0, 6.0)};
    if (std::abs(level(trial, a) - 1.0) < 1e-3) continue;
    compare(closest_on_ellipse, closest_on_ellipse_change, trial, a);
    // Where G crosses an axis the program's return has a kink.
    const PlaneVector f = ratio_on_ellipse(trial, a);
    if (std::min(std::abs(f[0]), std::abs(f[1])) > 0.05) {
      compare(ratio_on_ellipse, ratio_on_ellipse_change, trial, a);
    }
  }
  compare(closest_on_ellipse, closest_on_ellipse_change, {0.5, 4.0}, {2.0, 1.5});
  CHECK(closest_on_ellipse_change({0.5, 4.0}, {0.0, 1.5}, {1.0, 1.0}, {0.0, 0.7}) ==
        PlaneVector{0.0, 0.7});
  CHECK(ratio_on_ellipse_change({0.5, -4.0}, {0.0, 1.5}, {1.0, 1.0}, {0.0, 0.7}) ==
        PlaneVector{0.0, -0.7});
  CHECK(closest_on_ellipse_change({0.5, 1.0}, {0.0, 1.5}, {1.0, 1.0}, {0.0, 0.7}) ==
        PlaneVector{0.0, 1.0});
}

TEST_CASE("the radius of the ellipse is that of its points") {
  CHECK(ellipse_radius({1.0, 0.0}, kBounds) == 30.0);
  CHECK(ellipse_radius({0.0, -1.0}, kBounds) == 10.0);
  const PlaneVector f = closest_on_ellipse({50.0, 60.0}, kBounds);
  CHECK(std::abs(ellipse_radius(scaled(f, 1.0 / length(f)), kBounds) - length(f)) < 1e-14);
  CHECK(ellipse_radius({0.6, 0.8}, {0.0, 10.0}) == 0.0);
  CHECK(ellipse_radius({0.0, 1.0}, {0.0, 10.0}) == 10.0);
  CHECK(ellipse_radius({0.0, 0.0}, kBounds) == 0.0);
}

}  // namespace
