// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/ellipse_point.hpp"
#include "reference/orthotropic_sliding.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using ellipse_point::Vector;

namespace {

/// The force of steady sliding at 45 degrees with K V dt per increment, normal force 100,
/// coefficients 0.3 and 0.1, by either point of the ellipse.
Vector steady_by(Vector (*point)(Vector, Vector), double stretch) {
  const double step = stretch * std::sqrt(0.5);
  Vector force{0.0, 0.0};
  // The distance to the steady force falls by a factor of e in 16 of trial force: 1200 leaves
  // rounding only. Large increments need a few more of their own.
  const int increments = std::max(static_cast<int>(1200.0 / stretch), 100);
  for (int i = 0; i < increments; ++i)
    force = point({force.x + step, force.y + step}, {30.0, 10.0});
  return force;
}

}  // namespace

TEST_CASE("the closest and the ratio's point of the ellipse have the printed components") {
  const std::vector<double> trial{60.0 * std::sqrt(0.5), 60.0 * std::sqrt(0.5), 30.0, 10.0};
  const auto closest = evaluate("ellipse_closest_point", {}, {trial})[0];
  CHECK_THAT(closest[0], printed("24.687131330648"));
  CHECK_THAT(closest[1], printed("5.681798880473"));
  CHECK(closest[2] == Approx(std::hypot(trial[0] - closest[0], trial[1] - closest[1])));
  const auto ratio = evaluate("ellipse_ratio_point", {}, {trial})[0];
  CHECK_THAT(ratio[0], printed("26.939972582437"));
  CHECK_THAT(ratio[1], printed("4.399973197615"));
}

TEST_CASE("steady sliding at 45 degrees has the printed force by the closest point") {
  const auto sliding = evaluate("orthotropic_steady_sliding", {}, {{2.0, 2.0, 100.0, 0.3, 0.1}})[0];
  CHECK_THAT(sliding[0], printed("28.460498941515"));
  CHECK_THAT(sliding[1], printed("3.162277660168"));
  CHECK(sliding[3] == Approx(2.0 * (sliding[0] + sliding[1])).epsilon(1e-14));
  for (const double stretch : {0.5, 1.0, 10.0, 300.0}) {
    CAPTURE(stretch);
    const Vector force = steady_by(ellipse_point::closest, stretch);
    CHECK(force.x == Approx(sliding[0]).epsilon(1e-12));
    CHECK(force.y == Approx(sliding[1]).epsilon(1e-12));
  }
}

TEST_CASE(
    "steady sliding by the ratio's point has the printed force and depends on the increment") {
  const Vector unit = steady_by(ellipse_point::by_ratio, 1.0);
  CHECK_THAT(unit.x, printed("28.8035165194"));
  CHECK_THAT(unit.y, printed("2.7959779866"));
  // First order: a tenth of the increment leaves about a tenth of the difference.
  const double exact = steady_by(ellipse_point::closest, 1.0).x;
  const double tenth = steady_by(ellipse_point::by_ratio, 0.1).x;
  CHECK((tenth - exact) / (unit.x - exact) == Approx(0.1).epsilon(0.15));
}

TEST_CASE("the closest point is on the ellipse, square to it and in the trial's quadrant") {
  for (const double a : {0.01, 1.0, 30.0}) {
    for (const double b : {1.0, 10.0}) {
      for (int i = 0; i < 24; ++i) {
        const double angle = std::numbers::pi * i / 12.0 + 0.01;
        const double reach = 1.01 * std::max(a, b) * (1.0 + 0.3 * i);
        const Vector trial{reach * std::cos(angle), reach * std::sin(angle)};
        const Vector f = ellipse_point::closest(trial, {a, b});
        CAPTURE(a, b, angle);
        CHECK(std::hypot(f.x / a, f.y / b) == Approx(1.0).epsilon(1e-14));
        CHECK(f.x * trial.x >= 0.0);
        CHECK(f.y * trial.y >= 0.0);
        const Vector gap{trial.x - f.x, trial.y - f.y};
        const Vector normal{f.x / (a * a), f.y / (b * b)};
        const double cross = gap.x * normal.y - gap.y * normal.x;
        // The normal of an ellipse a hundred times as long as wide turns a hundred times as fast.
        CHECK(std::abs(cross) < 1e-12 * std::hypot(gap.x, gap.y) * std::hypot(normal.x, normal.y));
      }
    }
  }
}

TEST_CASE("steady sliding dissipates more than any other force of the ellipse") {
  const orthotropic_sliding::Vector mu{0.3, 0.1};
  for (int i = 0; i < 16; ++i) {
    const double direction = 2.0 * std::numbers::pi * i / 16.0;
    const orthotropic_sliding::Vector v{std::cos(direction), std::sin(direction)};
    const auto f = orthotropic_sliding::force(mu, 100.0, v);
    const double power = f.x * v.x + f.y * v.y;
    CHECK(std::hypot(f.x / 30.0, f.y / 10.0) == Approx(1.0).epsilon(1e-14));
    for (int j = 0; j < 100; ++j) {
      const double t = 2.0 * std::numbers::pi * j / 100.0;
      CHECK(30.0 * std::cos(t) * v.x + 10.0 * std::sin(t) * v.y <= power * (1.0 + 1e-14));
    }
  }
}

TEST_CASE("equal coefficients give the radial force in every form") {
  const Vector trial{-36.0, 48.0};
  for (const Vector f : {ellipse_point::closest(trial, {20.0, 20.0}),
                         ellipse_point::by_ratio(trial, {20.0, 20.0})}) {
    CHECK(f.x == Approx(-12.0).epsilon(1e-14));
    CHECK(f.y == Approx(16.0).epsilon(1e-14));
  }
  const auto sliding = orthotropic_sliding::force({0.2, 0.2}, 100.0, {-3.0, 4.0});
  CHECK(sliding.x == Approx(-12.0).epsilon(1e-15));
  CHECK(sliding.y == Approx(16.0).epsilon(1e-15));
}

TEST_CASE("trials inside stay, trials on an axis keep to it, an axis without length has no force") {
  for (const char* name : {"ellipse_closest_point", "ellipse_ratio_point"}) {
    CAPTURE(std::string(name));
    const auto rows = evaluate(name, {},
                               {{12.0, -6.0, 30.0, 10.0},
                                {50.0, 0.0, 30.0, 10.0},
                                {0.0, -50.0, 30.0, 10.0},
                                {50.0, -50.0, 0.0, 10.0},
                                {50.0, 4.0, 0.0, 10.0},
                                {50.0, 4.0, 0.0, 0.0}});
    CHECK(rows[0] == std::vector<double>{12.0, -6.0, 0.0});
    CHECK(rows[1][0] == Approx(30.0).epsilon(1e-15));
    CHECK(rows[1][1] == Approx(0.0).margin(1e-15));
    CHECK(rows[2][0] == Approx(0.0).margin(1e-15));
    CHECK(rows[2][1] == Approx(-10.0).epsilon(1e-15));
    CHECK(rows[3][0] == 0.0);
    CHECK(rows[3][1] == -10.0);
    CHECK(rows[4][1] == 4.0);
    CHECK(rows[5][2] == Approx(std::hypot(50.0, 4.0)));
  }
}

TEST_CASE("a body at rest, or one that slides without friction, has no orthotropic force") {
  const auto rows = evaluate("orthotropic_steady_sliding", {},
                             {{0.0, 0.0, 100.0, 0.3, 0.1},
                              {1.0, 0.0, 100.0, 0.0, 0.1},
                              {1.0, 1.0, 0.0, 0.3, 0.1},
                              {1.0, 2.0, 100.0, 0.0, 0.1}});
  CHECK(rows[0] == std::vector<double>(5, 0.0));
  CHECK(rows[1][2] == 0.0);
  CHECK(rows[2][2] == 0.0);
  CHECK(rows[3][0] == 0.0);
  CHECK(rows[3][1] == Approx(10.0).epsilon(1e-15));
}
