// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/reversals.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

TEST_CASE("each reversal is compared in position and value") {
  const Series reference = slider(zigzag({0, 0.1, -0.1, 0.05}, 10));
  Series result = slider(zigzag({0, 0.11, -0.1, 0.05}, 1000, true));
  cases::Tolerance tolerance = absolute(0.5);
  tolerance.abscissa = 0.005;
  const CurveComparison found = compare_reversals(result, reference, tolerance);
  REQUIRE(found.measures.size() == 5);
  CHECK(found.compared == 2);
  CHECK(measure(found, "number of reversals").passed());
  const Measure& first = measure(found, "position of reversal 1");
  CHECK(first.unit == MeasureUnit::kAbscissa);
  CHECK(first.value == Approx(0.11));
  CHECK(first.deviation == Approx(0.01));
  CHECK(first.scale == Approx(0.2));
  CHECK_FALSE(first.passed());
  CHECK(first.where->time == 1000.0);
  CHECK(measure(found, "position of reversal 2").passed());
  CHECK(measure(found, "value at reversal 1").value == Approx(20.0));
  CHECK(measure(found, "value at reversal 2").reference == Approx(-20.0));
  CHECK(measure(found, "value at reversal 2").scale == Approx(40.0));
  CHECK(measure(found, "value at reversal 2").tolerance == 0.5);
}

TEST_CASE("another number of reversals fails and is not compared one by one") {
  const Series reference = slider(zigzag({0, 0.1, -0.1, 0.1}, 10));
  const Series result = slider(zigzag({0, 0.1, -0.1}, 10));
  const CurveComparison found = compare_reversals(result, reference, relative(1e9));
  REQUIRE(found.measures.size() == 1);
  CHECK(found.measures[0].value == 1.0);
  CHECK(found.measures[0].reference == 2.0);
  CHECK_FALSE(found.measures[0].passed());
}

TEST_CASE("a bound of values alone leaves positions to be told, and the other way round") {
  const Series reference = slider(zigzag({0, 0.1, -0.1}, 10));
  const Series result = slider(zigzag({0, 0.2, -0.1}, 10));
  CHECK(passed(compare_reversals(result, reference, absolute(1e-9))));
  cases::Tolerance positions;
  positions.abscissa = 0.15;
  const Series weaker = scaled(result, 1.0, 0.5);
  CHECK(passed(compare_reversals(weaker, reference, positions)));
  CHECK_FALSE(passed(compare_reversals(result, reference, relative(0.01))));
}

TEST_CASE("after a dwell the value is that of its end") {
  const Series curve{{0, 1, 1, 0}, {0, 20, 15, -20}, {0, 1, 2, 3}};
  const CurveComparison found = compare_reversals(curve, curve, relative(0.0));
  CHECK(measure(found, "value at reversal 1").value == 15.0);
  CHECK(measure(found, "value at reversal 1").where->time == 2.0);
}

TEST_CASE("a reference that never turns has nothing to compare") {
  const Series straight = slider(zigzag({0, 0.1}, 10));
  CHECK(compare_reversals(straight, straight, relative(1.0)).fault ==
        "the abscissa of the reference never turns");
}

}  // namespace
}  // namespace slipbench::driver::check
