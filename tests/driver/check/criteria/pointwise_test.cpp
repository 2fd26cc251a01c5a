// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/pointwise.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

double largest(const PointwiseComparison& comparison) {
  double size = 0.0;
  for (const CurvePoint& p : comparison.points) {
    size = std::max(size, std::abs(p.value - p.reference));
  }
  return size;
}

TEST_CASE("the result is interpolated at the rows of the reference") {
  const Series result{{0, 1, 2}, {0, 10, 0}, {0, 5, 10}};
  const Series reference{{0.5, 1.5}, {5, 4}, {}};
  const PointwiseComparison found = compare_points(result, reference);
  REQUIRE(found.fault.empty());
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].value == Approx(5.0));
  CHECK(found.points[0].time == Approx(2.5));
  CHECK(found.points[1].abscissa == 1.5);
  CHECK(found.points[1].value == Approx(5.0));
  CHECK(found.points[1].reference == 4.0);
}

TEST_CASE("only the common range is compared, its ends included in spite of rounding") {
  double t = 0.0;
  Series result;
  for (int i = 0; i <= 10; ++i, t += 0.1) {
    result.abscissa.push_back(t);
    result.value.push_back(2.0 * t);
  }
  REQUIRE(result.abscissa.back() < 1.0);  // a sum of tenths
  const Series reference = sampled({-0.5, 0.0, 0.5, 1.0, 1.5}, [](double x) { return 2.0 * x; });
  const PointwiseComparison found = compare_points(result, reference);
  REQUIRE(found.points.size() == 3);
  CHECK(largest(found) < 1e-12);  // rounding of the sum
  CHECK(found.points.back().abscissa == 1.0);
}

TEST_CASE("a reference without a row in the common range compares nothing") {
  const Series result = sampled({2.0, 3.0}, [](double x) { return x; });
  const Series reference = sampled({0.0, 10.0}, [](double x) { return x; });
  CHECK(compare_points(result, reference).fault ==
        "no row of the reference lies in the common range, 2 to 3");
}

TEST_CASE("a loop is compared branch by branch, whatever its sampling") {
  const std::vector<double> turns{0, 0.1, -0.1, 0.1};
  const Series fine = slider(zigzag(turns, 1000, true));
  for (const int rows : {10, 37, 1000}) {
    const Series reference = slider(zigzag(turns, rows));
    const PointwiseComparison found = compare_points(fine, reference);
    REQUIRE(found.fault.empty());
    CHECK(found.points.size() == reference.size());
    // Kinks of the ragged fine curve fall within its rows: less than a row's force.
    CHECK(largest(found) < 1.25 * 0.2 / 1000 * kStiffness);
  }
}

TEST_CASE("the branch matters: a loop and its mirror image are far apart") {
  const std::vector<double> turns{0, 0.1, -0.1, 0.1};
  const Series result = slider(zigzag(turns, 50));
  Series reference = slider(zigzag(turns, 40));
  for (std::size_t i = 41; i < 80; ++i) reference.value.change()[i] = 20.0;
  CHECK(largest(compare_points(result, reference)) == Approx(40.0));
}

TEST_CASE("a reversal is one point though it belongs to two branches") {
  const Series result = slider(zigzag({0, 0.1, 0}, 9));
  const Series reference = slider(zigzag({0, 0.1, 0}, 2));
  CHECK(compare_points(result, reference).points.size() == 5);
}

TEST_CASE("a reference that ends within a branch is compared as far as it goes") {
  const Series result = slider(zigzag({0, 0.1, -0.1}, 50));
  const Series reference = slider(zigzag({0, 0.1, 0.05}, 10));
  CHECK(compare_points(result, reference).points.size() == reference.size());
  CHECK(compare_points(reference, result).points.size() == 51 + 12);
}

TEST_CASE("a branch that has nothing in common is a fault, not a gap") {
  const Series result = slider(zigzag({0, 1, 0.9, 2}, 5));
  const Series reference = slider(zigzag({0, 0.5, 0.4, 2}, 5));
  CHECK_THAT(compare_points(result, reference).fault,
             Catch::Contains("branch 2 of 3 of the reference has no row that the result covers: it "
                             "has rows between 0.4 and 0.5, the result goes from 0.9 to 1 there"));
}

TEST_CASE("a jump at the same instant does not fail by the side that is taken") {
  const Series result{{0, 1, 1, 2}, {0, 0, 20, 20}, {0, 1, 1, 2}};
  const Series reference{{0, 1 - 1e-15, 1 + 1e-15, 1.5}, {0, 0, 20, 20}, {}};
  const PointwiseComparison found = compare_points(result, reference);
  REQUIRE(found.points.size() == 4);
  CHECK(largest(found) == 0.0);
  const Series later{{0, 1.1, 1.1, 2}, {0, 0, 20, 20}, {}};
  CHECK(largest(compare_points(result, later)) == 20.0);
}

TEST_CASE("the very rows of a result are compared row by row, even in a dwell") {
  const Series result{{0, 1, 1, 1}, {0, 0, 10, 20}, {0, 1, 2, 3}};
  const Series reference{{0, 1, 1, 1}, {0, 20, 10, 0}, {0, 1, 2, 3}};
  const PointwiseComparison found = compare_points(result, reference);
  REQUIRE(found.points.size() == 4);
  CHECK(found.points[1].value == 0.0);
  CHECK(largest(found) == 20.0);
  CHECK(found.points[2].time == 2.0);
}

TEST_CASE("a dwell is judged alike whether the abscissas of the curves are identical or not") {
  const Series result{{0, 1, 1, 1, 2}, {0, 0, 10, 20, 20}, {0, 1, 2, 3, 4}};
  // Half an increment late in the dwell: all of its values were taken by the result, too.
  Series reference{{0, 1, 1, 1, 2}, {0, 5, 15, 20, 20}, {}};
  CHECK(largest(compare_points(result, reference)) == 0.0);
  reference.abscissa = {0, 1, 1, 1, 1.5};
  CHECK(largest(compare_points(result, reference)) == 0.0);
  reference.value = {0, -1, 15, 20, 20};
  CHECK(largest(compare_points(result, reference)) == 1.0);
  // Where no two rows share a place, rows belong together whatever is known of the times.
  const Series moving{{0, 1, 2}, {0, 3, 4}, {0, 1, 2}};
  CHECK(compare_points(moving, {{0, 1, 2}, {0, 1, 4}, {}}).points[1].value == 3.0);
}

/// A force over the slip, which rests at 1 while the force reverses, or that much later.
Series reversal(double late, bool with_times) {
  Series curve{{0.0, 0.5, 0.9 + late, 1.0 + late, 1.0 + late, 1.0 + late, 1.1 + late, 2.0},
               {20, 20, 20, 20, 4, -17, -20, -20},
               {}};
  for (std::size_t i = 0; with_times && i < curve.size(); ++i) {
    curve.time.push_back(static_cast<double>(i));
  }
  return curve;
}

TEST_CASE("where the abscissa rests depends on the increments, and fails nothing by itself") {
  for (const double late : {1e-3, -1e-3, 0.05, -0.05}) {
    CAPTURE(late);
    CHECK(largest(compare_points(reversal(late, true), reversal(0.0, false))) == 0.0);
  }
  // Further away than an increment of either curve it is a jump at another place.
  CHECK(largest(compare_points(reversal(0.3, true), reversal(0.0, false))) > 20.0);
  // What the result never had is not met.
  Series higher = reversal(1e-3, false);
  higher.value.change()[3] = 23.0;
  CHECK(largest(compare_points(reversal(0.0, true), higher)) == 3.0);
  // A row that neither rests nor is next to the rest is compared where it is.
  Series wrong = reversal(0.0, false);
  wrong.value.change()[1] = 3.0;
  CHECK(largest(compare_points(reversal(1e-3, true), wrong)) == 17.0);
}

TEST_CASE("a reference of which only one row is met of several is a fault that counts them") {
  const Series result = sampled({0, 1, 2, 5}, [](double x) { return x; });
  const Series reference = sampled({0, 1000, 2000}, [](double x) { return x; });
  CHECK(compare_points(result, reference).fault ==
        "only 1 of the reference's 3 rows, at 0, lies in the common range, 0 to 5");
  const Series two = sampled({0, 4, 1000}, [](double x) { return x; });
  CHECK(compare_points(result, two).points.size() == 2);
}

TEST_CASE("the one measure of a pointwise comparison is its worst point") {
  const Series result{{0, 1, 2}, {0, 10.5, 21}, {0, 3, 6}};
  const Series reference{{0, 1, 2}, {0, 10, 20}, {}};
  const CurveComparison found = compare_pointwise(result, reference, relative(0.04));
  REQUIRE(found.measures.size() == 1);
  CHECK(found.compared == 3);
  CHECK(found.measures[0].deviation == 1.0);
  CHECK(found.measures[0].scale == 20.0);
  CHECK(found.measures[0].tolerance == Approx(0.8));
  CHECK(found.measures[0].where->time == 6.0);
  CHECK_FALSE(passed(found));
  CHECK(passed(compare_pointwise(result, reference, absolute(1.0))));
}

}  // namespace
}  // namespace slipbench::driver::check
