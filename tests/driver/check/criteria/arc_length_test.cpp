// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/arc_length.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace slipbench::driver::check {
namespace {

constexpr double kPi = std::numbers::pi;

/// An ellipse about (2, 100), run through once from an angle on; in a box of its own that of a
/// circle of radius 1/2.
Series ellipse(double a, double b, int rows, double start = 0.0, double turn = 1.0) {
  Series curve;
  for (int i = 0; i <= rows; ++i) {
    const double angle = start + turn * 2.0 * kPi * i / rows;
    curve.abscissa.push_back(2.0 + a * std::cos(angle));
    curve.value.push_back(100.0 + b * std::sin(angle));
    curve.time.push_back(10.0 * i / rows);
  }
  return curve;
}

cases::Tolerance within(double absolute) {
  return {.absolute = absolute, .relative = {}, .why = ""};
}

struct Distance {
  double largest;
  double mean;
  bool closed;
  CurvePoint where;
};
Distance distance(const Series& result, const Series& reference) {
  const CurveComparison found = compare_arc_length(result, reference, within(0.1));
  REQUIRE(found.fault == "");
  REQUIRE(found.measures.size() == 2);
  REQUIRE(found.measures[0].where);
  CHECK(found.measures[1].name == "mean distance");
  CHECK(found.measures[1].passed());
  CHECK(found.compared == static_cast<std::int64_t>(reference.size()));
  return {found.measures[0].deviation, found.measures[1].deviation,
          found.measures[0].name == "largest distance of closed loops", *found.measures[0].where};
}

TEST_CASE("a curve is at no distance from itself") {
  const Series loop = ellipse(0.3, 40.0, 97);
  CHECK(distance(loop, loop).largest == 0.0);
  CHECK(distance(loop, loop).closed);
  const Series open{{0.0, 1.0, 1.0, 0.5}, {0.0, 2.0, -1.0, 3.0}, {}};
  CHECK(distance(open, open).largest == 0.0);
  CHECK_FALSE(distance(open, open).closed);
}

TEST_CASE("it does not matter where a loop begins") {
  const Series loop = ellipse(0.3, 40.0, 360);
  for (const int rows : {1, 77, 180, 359}) {
    // The same polygon from another of its corners: only rounding is left.
    const Series other = ellipse(0.3, 40.0, 360, 2.0 * kPi * rows / 360);
    CHECK(distance(other, loop).largest < 1e-10);
  }
  // Corners between the corners: the chords' sagitta, (2 pi/360)^2/8 of the radius.
  CHECK(distance(ellipse(0.3, 40.0, 360, 0.4321), loop).largest < 4e-5);
}

TEST_CASE("similar ellipses are at the distance of their radii") {
  // In the box the reference is a circle of radius 1/2 and the result one of 0.55.
  const Distance found = distance(ellipse(0.33, 44.0, 3600, 1.0), ellipse(0.3, 40.0, 3600));
  CHECK(found.closed);
  CHECK(found.largest == Approx(0.05).epsilon(1e-4));
  CHECK(found.mean == Approx(0.05).epsilon(1e-4));
}

TEST_CASE("an ellipse that is longer along one axis is farthest at its ends") {
  // By symmetry quarters of both lengths fall on the axes: 0.05 there, and less elsewhere.
  const Distance found = distance(ellipse(0.33, 40.0, 3600, 2.0), ellipse(0.3, 40.0, 3600));
  CHECK(found.largest == Approx(0.05).epsilon(2e-3));
  CHECK(found.mean < 0.045);
  CHECK(std::abs(found.where.abscissa - 2.0) == Approx(0.3).epsilon(1e-3));
  CHECK(found.where.value == Approx(100.0).margin(2.0));
  CHECK(found.where.reference == Approx(100.0).margin(2.0));
}

TEST_CASE("a loop that is displaced is at the distance of its displacement") {
  Series moved = ellipse(0.3, 40.0, 720, 0.7);
  for (double& x : moved.abscissa.change()) x += 0.06;  // a tenth of the box
  for (double& y : moved.value.change()) y -= 4.0;      // a twentieth
  CHECK(distance(moved, ellipse(0.3, 40.0, 720)).largest ==
        Approx(std::hypot(0.1, 0.05)).epsilon(1e-3));
}

TEST_CASE("a loop in the other direction is far away") {
  const Series loop = ellipse(0.3, 40.0, 360);
  const Distance found = distance(ellipse(0.3, 40.0, 360, 0.0, -1.0), loop);
  // A circle against its mirror image: opposite points meet, wherever it begins.
  CHECK(found.largest == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("open curves are compared from their first rows on") {
  const Series reference{{0.0, 1.0}, {0.0, 10.0}, {}};
  const Series shifted{{0.0, 1.0}, {1.0, 11.0}, {0.0, 2.0}};
  const Distance found = distance(shifted, reference);
  CHECK(found.largest == Approx(0.1).epsilon(1e-14));
  CHECK(found.mean == Approx(0.1).epsilon(1e-12));  // a sum of 1000
  const Series backwards{{1.0, 0.0}, {10.0, 0.0}, {}};
  CHECK(distance(backwards, reference).largest == Approx(std::sqrt(2.0)).epsilon(1e-14));
  // The farthest point, and where the result was then.
  const Series bent{{0.0, 0.5, 1.0}, {0.0, 8.0, 10.0}, {0.0, 3.0, 4.0}};
  CHECK(distance(bent, reference).where.time > 2.5);
  CHECK(distance(bent, reference).where.time < 3.5);
}

TEST_CASE("the largest distance is found at a corner between the equal parts") {
  // Straight along the abscissa, there and back a part of the way. The reference of one value is
  // scaled by its magnitude, so both run along one line.
  const Series reference{{0.0, 1.0}, {1.0, 1.0}, {}};
  const Series folded{{0.0, 0.51234, 0.1, 1.0}, {1.0, 1.0, 1.0, 1.0}, {}};
  const double length = 0.51234 + 0.41234 + 0.9;
  const Distance found = distance(folded, reference);
  CHECK(found.largest == Approx((0.51234 + 0.41234) / length - 0.1).epsilon(1e-13));
  CHECK(found.where.abscissa == Approx((0.51234 + 0.41234) / length).epsilon(1e-13));
}

/// The loop of an elastic slider between +-0.1, its corners on rows whatever their number.
Series slider_loop(int rows_of_a_side) {
  const std::vector<double> x{0.1, 0.06, -0.1, -0.06, 0.1}, y{20.0, -20.0, -20.0, 20.0, 20.0};
  Series curve{{x[0]}, {y[0]}, {}};
  for (std::size_t k = 1; k < x.size(); ++k) {
    for (int i = 1; i <= rows_of_a_side; ++i) {
      const double part = static_cast<double>(i) / rows_of_a_side;
      curve.abscissa.push_back(x[k - 1] + part * (x[k] - x[k - 1]));
      curve.value.push_back(y[k - 1] + part * (y[k] - y[k - 1]));
    }
  }
  return curve;
}

TEST_CASE("rows that are close or far apart do not move a loop") {
  const Series coarse = slider_loop(1);
  for (const int rows : {2, 10, 1000, 20000}) {
    CHECK(distance(slider_loop(rows), coarse).largest < 1e-9);
    CHECK(distance(coarse, slider_loop(rows)).largest < 1e-9);
  }
  // Rows that rest in a place are no length.
  Series resting = coarse;
  resting.abscissa.change().insert(resting.abscissa.change().begin() + 2, 5, coarse.abscissa[2]);
  resting.value.change().insert(resting.value.change().begin() + 2, 5, coarse.value[2]);
  CHECK(distance(resting, coarse).largest < 1e-12);
}

TEST_CASE("the distance of curves does not depend on the units") {
  const Series f = ellipse(0.34, 41.0, 100, 0.3), r = ellipse(0.3, 40.0, 130);
  const double plain = distance(f, r).largest;
  CHECK(plain > 0.05);
  Series f_scaled = f, r_scaled = r;
  for (Series* curve : {&f_scaled, &r_scaled}) {
    for (double& x : curve->abscissa.change()) x *= 1e3;
    for (double& y : curve->value.change()) y *= -1e-6;
  }
  CHECK(distance(f_scaled, r_scaled).largest == Approx(plain).epsilon(1e-9));
}

TEST_CASE("curves are closed if both ends meet within two percent of the box") {
  Series gap = ellipse(0.3, 40.0, 1000);
  gap.abscissa.change().resize(996);  // 5 of 1000 rows: 1.6 % of the box
  gap.value.change().resize(996);
  gap.time.change().clear();
  const Series whole = ellipse(0.3, 40.0, 1000);
  CHECK(distance(gap, whole).closed);
  // The missing piece is straight.
  CHECK(distance(gap, whole).largest < 1e-3);
  gap.abscissa.change().resize(990);
  gap.value.change().resize(990);
  CHECK_FALSE(distance(gap, whole).closed);
}

TEST_CASE("a reference of one value is scaled by that") {
  const Series plateau{{0.0, 1.0}, {20.0, 20.0}, {}};
  const Series higher{{0.0, 1.0}, {21.0, 21.0}, {}};
  CHECK(distance(higher, plateau).largest == Approx(0.05).epsilon(1e-13));
}

TEST_CASE("no distance without a reference that moves, or numbers") {
  const Series loop = ellipse(0.3, 40.0, 36);
  const auto fault = [](const Series& f, const Series& r) {
    const CurveComparison found = compare_arc_length(f, r, within(1e9));
    CHECK(found.measures.empty());
    return found.fault;
  };
  CHECK_THAT(fault(loop, Series{{2.0, 2.0}, {0.0, 200.0}, {}}),
             Catch::Contains("only one point in common"));
  CHECK_THAT(fault(Series{{2.0}, {0.0}, {}}, Series{{2.0, 2.0}, {0.0, 200.0}, {}}),
             Catch::Contains("does not move"));
  CHECK_THAT(fault(loop, Series{{1.0, 3.0}, {0.0, 0.0}, {}}), Catch::Contains("zero throughout"));
  CHECK(fault(loop, Series{}) != "");
  CHECK(fault(Series{}, loop) != "");
  Series broken = loop;
  broken.value.change()[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK(fault(broken, loop) != "");
  CHECK(fault(loop, broken) != "");
  broken.value.change()[7] = 1e200;
  CHECK_THAT(fault(broken, loop), Catch::Contains("too far"));
  CHECK(fault(Series{{2.0, 2.0}, {100.0, 100.0}, {}}, loop) != "");
  Series elsewhere = loop;
  for (double& x : elsewhere.abscissa.change()) x += 5.0;
  CHECK(fault(elsewhere, loop) != "");
}

}  // namespace
}  // namespace slipbench::driver::check
