// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/plateau.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

double mean_of(const Series& curve) {
  return compare_plateau(curve, curve, {}).measures.at(0).value;
}

TEST_CASE("rows that lie close do not weigh more in the mean") {
  const Series crowded{{0, 0.01, 0.02, 0.03, 1}, {0, 0.01, 0.02, 0.03, 1}, {}};
  CHECK(mean_of(crowded) == Approx(0.5));
}

TEST_CASE("the mean is over the common range") {
  const Series result = sampled({0, 4}, [](double x) { return x; });
  const Series reference = sampled({1, 2}, [](double) { return 1.5; });
  const CurveComparison found = compare_plateau(result, reference, relative(1e-12));
  CHECK(found.measures[0].value == Approx(1.5));
  CHECK(found.measures[0].scale == 1.5);
  CHECK(passed(found));
  CHECK_FALSE(passed(compare_plateau(scaled(result, 1.0, 1.1), reference, relative(0.09))));
}

TEST_CASE("back and forth, every way counts with its length") {
  // 1 N forth over 1 mm, 3 N back over 2 mm.
  const Series curve{{0, 1, 1, -1}, {1, 1, 3, 3}, {}};
  CHECK(mean_of(curve) == Approx(7.0 / 3.0));
  CHECK(mean_of(scaled(curve, -1.0, 1.0)) == Approx(7.0 / 3.0));
  CHECK(mean_of(scaled(curve, 1.0, -1.0)) == Approx(-7.0 / 3.0));
}

TEST_CASE("the mean of a rippled plateau hardly depends on the rows") {
  const auto ripple = [](double x) { return 20.0 + std::cos(10.0 * x); };
  const double exact = 20.0 + std::sin(10.0) / 10.0;
  CHECK(mean_of(sampled(zigzag({0, 1}, 1000, true), ripple)) == Approx(exact).epsilon(1e-6));
  // Trapezoids: h^2/12 f'' = 0.07 of the ripple of 1, here mostly cancelled.
  CHECK(std::abs(mean_of(sampled(zigzag({0, 1}, 10), ripple)) - exact) < 0.07);
}

TEST_CASE("a single place has no plateau") {
  const Series still{{1, 1}, {2, 3}, {}};
  CHECK_THAT(compare_plateau(still, still, {}).fault, Catch::Contains("only one point in common"));
  const Series row{{1}, {2}, {}};
  CHECK(compare_plateau(row, row, {}).fault == "a single point of the abscissa has no plateau");
}

}  // namespace
}  // namespace slipbench::driver::check
