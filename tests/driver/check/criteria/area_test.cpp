// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/area.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

TEST_CASE("the area has its sign, and its scale does not cancel") {
  const Series result = sampled({0, 1, 3}, [](double x) { return x - 1.0; });
  const Series reference = sampled({0, 3}, [](double x) { return x - 1.0; });
  const CurveComparison found = compare_area(result, reference, relative(1e-12));
  REQUIRE(found.measures.size() == 1);
  CHECK(found.measures[0].unit == MeasureUnit::kProduct);
  CHECK(found.measures[0].value == Approx(1.5));
  CHECK(found.measures[0].reference == Approx(1.5));
  CHECK(found.measures[0].scale == Approx(2.5));  // triangles of 1/2 and 2
  CHECK(passed(found));
  CHECK_FALSE(passed(compare_area(scaled(result, 1.0, -1.0), reference, relative(0.5))));
}

TEST_CASE("against the direction of the abscissa the area changes its sign") {
  const Series result = sampled({3, 1, 0}, [](double x) { return x; });
  const CurveComparison found = compare_area(result, result, relative(0.0));
  CHECK(found.measures[0].value == Approx(-4.5));
  CHECK(found.measures[0].scale == Approx(4.5));
}

TEST_CASE("only the common range counts, cut between rows") {
  const Series result = sampled({0, 2, 4}, [](double x) { return x; });
  const Series reference = sampled({1, 3}, [](double x) { return x; });
  CHECK(compare_area(result, reference, {}).measures[0].value == Approx(4.0));
  CHECK(compare_area(reference, result, {}).measures[0].reference == Approx(4.0));
}

TEST_CASE("the area converges with the square of the rows' distance") {
  const auto area = [](int rows) {
    const Series curve = sampled(zigzag({0, 1}, rows), [](double x) { return std::exp(x); });
    return compare_area(curve, curve, {}).measures[0].value;
  };
  const double exact = std::exp(1.0) - 1.0;
  const double coarse = area(10) - exact;
  CHECK(coarse / (area(20) - exact) == Approx(4.0).epsilon(0.01));
  // Trapezoids: h^2/12 (f'(1) - f'(0)).
  CHECK(coarse == Approx(0.01 / 12.0 * exact).epsilon(0.01));
}

TEST_CASE("ten ragged rows have nearly the area of a thousand") {
  const auto wave = [](double x) { return std::sin(3.0 * x); };
  const Series coarse = sampled(zigzag({0, 1}, 10, true), wave);
  const Series fine = sampled(zigzag({0, 1}, 1000), wave);
  // Trapezoids: below h^2/12 max |f''| = 0.15^2/12 * 9 of an area of 0.66.
  CHECK(passed(compare_area(coarse, fine, absolute(0.017))));
}

TEST_CASE("a jump has no area") {
  const Series jump{{0, 1, 1, 2}, {0, 0, 20, 20}, {}};
  CHECK(compare_area(jump, jump, {}).measures[0].value == Approx(20.0));
}

TEST_CASE("back and forth, the area is the work, and branches must match") {
  const Series loop = slider(zigzag({0.1, -0.1, 0.1}, 20), 20.0);
  CHECK(compare_area(loop, loop, {}).measures[0].value == Approx(4.0 * kLimit * (0.1 - 0.02)));
  const Series half = slider(zigzag({0.1, -0.1}, 20), 20.0);
  CHECK_THAT(compare_area(half, loop, {}).fault, Catch::Contains("branch"));
}

}  // namespace
}  // namespace slipbench::driver::check
