// SPDX-License-Identifier: Apache-2.0
#include "law/connection/belt.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace slipbench::law;
using std::numbers::pi;

TEST_CASE("the wrap angle is that between the prolonged first segment and the second") {
  const Point a{0, 0, 0}, b{2, 0, 0};
  CHECK(wrap_angle(a, b, {5, 0, 0}) == 0.0);
  CHECK(wrap_angle(a, b, {2, 7, 0}) == Approx(pi / 2).epsilon(1e-15));
  CHECK(wrap_angle(a, b, {2, 0, -7}) == Approx(pi / 2).epsilon(1e-15));
  CHECK(wrap_angle(a, b, {1, 1, 0}) == Approx(0.75 * pi).epsilon(1e-15));
  CHECK(wrap_angle(a, b, {-3, 0, 0}) == pi);
  // A 3-4-5 triangle, turned out of all axes: acos(-(-3*3)/(3*5)).
  CHECK(wrap_angle({1, 1, 1}, {1, 4, 1}, {1, 1, 5}) == Approx(std::acos(-0.6)).epsilon(1e-15));
}

TEST_CASE("the wrap angle is accurate for a belt that is nearly straight and one that turns back") {
  for (const double small : {1e-3, 1e-7, 1e-12, 1e-150}) {
    // atan(small) = small - small^3/3: relative rounding of a few digits.
    CHECK(wrap_angle({-1, 0, 0}, {0, 0, 0}, {1, small, 0}) ==
          Approx(std::atan(small)).epsilon(4e-16));
    CHECK(wrap_angle({-1, 0, 0}, {0, 0, 0}, {-1, small, 0}) ==
          Approx(pi - std::atan(small)).epsilon(4e-16));
  }
}

TEST_CASE("the wrap angle does not depend on the lengths of the segments or their unit") {
  for (const double factor : {1e-200, 1e-3, 1e3, 1e150}) {
    CHECK(wrap_angle({-2 * factor, 0, 0}, {0, 0, 0}, {3 * factor, 3 * factor, 0}) ==
          Approx(pi / 4).epsilon(1e-15));
  }
}

TEST_CASE("nodes that coincide have no wrap angle") {
  CHECK(std::isnan(wrap_angle({1, 2, 3}, {1, 2, 3}, {0, 0, 0})));
  CHECK(std::isnan(wrap_angle({0, 0, 0}, {1, 2, 3}, {1, 2, 3})));
}

TEST_CASE("material that flows in at a slackens the segment, what leaves at b tightens it") {
  // 101 of belt over a distance of 101 mm at one per cent: 100 of material.
  const double start = initial_reference_length(101.0, 0.01);
  CHECK(start == Approx(100.0).epsilon(1e-15));
  CHECK(strain(101.0, start) == Approx(0.01).epsilon(1e-13));  // a difference of nearby lengths
  CHECK(strain(101.0, reference_length(start, 1.0, 0.0)) == Approx(0.0).margin(1e-15));
  CHECK(strain(101.0, reference_length(start, 0.0, 1.0)) == Approx(2.0 / 99.0).epsilon(1e-13));
  CHECK(reference_length(start, 2.5, 2.5) == start);
}

/// c on a circle about b, at `angle` from the prolonged segment ab.
Point at(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }
constexpr Point kA{-2, 0, 0};
constexpr Point kB{0, 0, 0};

TEST_CASE("half turns say which of all angles of the nodes is meant") {
  for (int half = 0; half < 7; ++half) {
    for (const double part : {0.1, 0.5, 0.9}) {
      const double angle = (half + part) * pi;
      CHECK(begin_turn(half, kA, kB, at(angle)).angle == Approx(angle).epsilon(1e-14));
    }
  }
  CHECK(begin_turn(2, kA, kB, at(0.0)).angle == 2 * pi);
  CHECK(begin_turn(1, kA, kB, {-5, 0, 0}).angle == Approx(pi).epsilon(1e-15));
}

TEST_CASE("a turn is followed through turns and straight lines, to and fro") {
  for (const double begin : {0.4, 2.0, 4.0, 7.5}) {
    BeltTurn turn = begin_turn(static_cast<int>(begin / pi), kA, kB, at(begin));
    double angle = begin;
    const auto go = [&](double to, double step) {
      while (std::abs(to - angle) > 1e-9) {
        angle += std::copysign(std::min(step, std::abs(to - angle)), to - angle);
        turn = follow_turn(turn, kA, kB, at(angle));
        REQUIRE(turn.angle == Approx(angle).margin(1e-13));
      }
    };
    // Steps that hit multiples of pi, and steps that do not.
    go(std::ceil(begin / pi) * pi, 0.3);
    go(6 * pi, pi / 8);
    go(-2 * pi, 0.37);
    go(begin, 1.5);
  }
}

TEST_CASE("a turn is followed in any plane, whatever the lengths") {
  struct Plane {
    Point along, aside, axis;
  };
  // The axis of the second one is at right angles to (1, 1, 1).
  const double half = std::sqrt(0.5);
  const std::vector<Plane> planes = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{0, 0, 1}, {half, half, 0}, {-half, half, 0}},
      {{2 / 7.0, 3 / 7.0, 6 / 7.0}, {3 / 7.0, -6 / 7.0, 2 / 7.0}, {6 / 7.0, 2 / 7.0, -3 / 7.0}}};
  for (const Plane& plane : planes) {
    for (const double length : {1e-9, 1.0, 1e9}) {
      const Point b{0.25 * length, -0.5 * length, 0.75 * length};
      const auto place = [&](double angle, double distance) {
        Point p = b;
        for (std::size_t i = 0; i < p.size(); ++i) {
          p[i] += distance * (std::cos(angle) * plane.along[i] + std::sin(angle) * plane.aside[i]);
        }
        return p;
      };
      const Point a = place(pi, length);
      BeltTurn turn = begin_turn(0, a, b, place(0.5, 3.0 * length));
      for (const double angle : {2.0, pi, 4.0, 2 * pi, 7.0, 5.0, pi, 2.0, 0.0, -1.0, -pi, -4.0}) {
        turn = follow_turn(turn, a, b, place(angle, 3.0 * length));
        REQUIRE(turn.angle == Approx(angle).margin(1e-13));
        for (std::size_t i = 0; i < 3; ++i) {
          REQUIRE(turn.axis[i] == Approx(plane.axis[i]).margin(1e-13));
        }
      }
    }
  }
}

TEST_CASE("out of a straight line a belt turns on, to whichever side") {
  for (int half = 0; half < 4; ++half) {
    for (double side = 0.0; side < 6.0; side += 0.5) {
      const auto at_side = [&](double angle) {
        return Point{std::cos(angle), std::sin(angle) * std::cos(side),
                     std::sin(angle) * std::sin(side)};
      };
      BeltTurn turn = begin_turn(half, kA, kB, {half % 2 == 0 ? 1.0 : -1.0, 0, 0});
      for (const double further : {0.1, 1.0, 2.0, 3.0}) {
        turn = follow_turn(turn, kA, kB, at_side(half * pi + further));
        REQUIRE(turn.angle == Approx(half * pi + further).epsilon(1e-13));
      }
    }
  }
}

TEST_CASE("around a straight line the axis turns and the angle comes back") {
  // c circles about the prolonged segment at 0.3 from it: the angle stays.
  const auto beside = [](double round) {
    return Point{std::cos(0.3), std::sin(0.3) * std::cos(round), std::sin(0.3) * std::sin(round)};
  };
  BeltTurn turn = begin_turn(2, kA, kB, beside(0.0));
  for (double round = 0.1; round < 7.0; round += 0.1) {
    turn = follow_turn(turn, kA, kB, beside(round));
    CHECK(turn.angle == Approx(2 * pi + 0.3).epsilon(1e-14));
  }
}

}  // namespace
