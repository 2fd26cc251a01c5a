// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/peak.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

TEST_CASE("the largest and the smallest value are compared, wherever they are") {
  const Series result{{0, 1, 2, 3, 4}, {0, 9, -4, 7, 0}, {0, 10, 20, 30, 40}};
  const Series reference{{0, 2, 3, 4}, {0, 10, -5, 0}, {}};
  const CurveComparison found = compare_peak(result, reference, absolute(1.0));
  REQUIRE(found.measures.size() == 2);
  const Measure& largest = measure(found, "largest value");
  CHECK(largest.value == 9.0);
  CHECK(largest.reference == 10.0);
  CHECK(largest.scale == 15.0);
  CHECK(largest.where->abscissa == 1.0);
  CHECK(largest.where->time == 10.0);
  const Measure& smallest = measure(found, "smallest value");
  CHECK(smallest.value == -4.0);
  CHECK(smallest.deviation == 1.0);
  CHECK(smallest.where->time == 20.0);
  CHECK(passed(found));
  CHECK_FALSE(passed(compare_peak(result, reference, absolute(0.99))));
  CHECK(found.compared == 4);
}

TEST_CASE("a peak outside of the common range does not count") {
  const Series result = sampled({0, 1, 2, 3}, [](double x) { return 10 * x; });
  const Series reference = sampled({0.5, 1.5}, [](double x) { return 10 * x; });
  const CurveComparison found = compare_peak(result, reference, absolute(1e-12));
  CHECK(measure(found, "largest value").value == Approx(15.0));
  CHECK(measure(found, "smallest value").value == Approx(5.0));
  CHECK(passed(found));
}

TEST_CASE("peaks are the same at any sampling that meets the corners") {
  const Series reference = slider(zigzag({0, 0.1, -0.1}, 10));
  const Series result = slider(zigzag({0, 0.1, -0.1}, 1000, true));
  CHECK(passed(compare_peak(result, reference, relative(1e-12))));
}

TEST_CASE("loops with different numbers of branches have peaks all the same") {
  const Series reference = slider(zigzag({0, 0.1, -0.1, 0.1, -0.1, 0.1}, 10));
  const Series result = slider(zigzag({0, 0.1, -0.1}, 10));
  CHECK(passed(compare_peak(result, reference, relative(1e-12))));
}

TEST_CASE("of a constant reference the scale is its magnitude") {
  const Series reference = sampled({0, 1}, [](double) { return 20.0; });
  const Series result = sampled({0, 1}, [](double) { return 20.1; });
  CHECK(passed(compare_peak(result, reference, relative(0.006))));
  CHECK_FALSE(passed(compare_peak(result, reference, relative(0.004))));
}

}  // namespace
}  // namespace slipbench::driver::check
