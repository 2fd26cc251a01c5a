// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/breakaway.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/driver/check/criteria/sampled_curves.hpp"

namespace slipbench::driver::check {
namespace {

void check_breakaway(const Series& curve, double position, double value, double margin = 1e-9) {
  const Breakaway found = breakaway(curve);
  CHECK(found.fault == "");
  CHECK(found.abscissa == Approx(position).margin(margin * 0.02));
  CHECK(found.value == Approx(value).margin(margin * kLimit));
}

TEST_CASE("the knee of a slider is found exactly at any step size") {
  for (const int rows : {6, 10, 13, 37, 100, 1000, 12345}) {
    for (const bool ragged : {false, true}) {
      CAPTURE(rows, ragged);
      check_breakaway(slider(zigzag({0, 0.1}, rows, ragged)), 0.02, 20.0);
    }
  }
}

TEST_CASE("a row just behind the knee does not blur it") {
  // 0.3 N, 1.5 % of 20 N, below the initial slope at 0.0203 mm.
  check_breakaway(slider({0, 0.01, 0.0203, 0.03, 0.04}), 0.02, 20.0);
  check_breakaway(slider({0, 0.01, 0.02001, 0.03, 0.04}), 0.02, 20.0);
}

TEST_CASE("a course that falls away at once and then slowly leaves where it fell") {
  const auto slow = [](double x) { return x < 0.02 + 1e-12 ? 1000 * x : 985 * x - 0.9; };
  check_breakaway(sampled(zigzag({0, 0.1}, 1000), slow), 0.02, 20.0);
}

TEST_CASE("the knee does not depend on how far the branch goes on") {
  for (const double end : {0.022, 0.05, 0.1, 1.0}) {
    CAPTURE(end);
    check_breakaway(slider(zigzag({0, end}, 1000)), 0.02, 20.0);
  }
}

TEST_CASE("in a first row beyond the knee nobody sees it: the row's end counts") {
  check_breakaway(slider(zigzag({0, 0.1}, 4)), 0.025, 20.0);
}

TEST_CASE("breakaway after a reversal is counted from the reversal") {
  check_breakaway(slider(zigzag({0.1, -0.1, 0.1}, 30), 20.0), 0.06, -20.0);
  check_breakaway(scaled(slider(zigzag({0.1, -0.1, 0.1}, 30), 20.0), -1.0, -1.0), -0.06, 20.0);
}

TEST_CASE("breakaway is found in every quadrant") {
  const Series curve = slider(zigzag({0, 0.1}, 31));
  check_breakaway(scaled(curve, -1.0, -1.0), -0.02, -20.0);
  check_breakaway(scaled(curve, 1.0, -1.0), 0.02, -20.0);
  check_breakaway(scaled(curve, -1.0, 1.0), -0.02, 20.0);
}

TEST_CASE("the time of breakaway lies between its rows") {
  // Rows 0.01 apart: the knee at 0.02 is row 2; 13 rows: at 2.6.
  CHECK(breakaway(slider(zigzag({0, 0.1}, 10))).time == Approx(2.0));
  CHECK(breakaway(slider(zigzag({0, 0.1}, 13))).time == Approx(2.6));
}

TEST_CASE("hardening after the knee does not move it") {
  const auto hardening = [](double x) {
    return std::min(kStiffness * x, kLimit + 100.0 * (x - 0.02));
  };
  for (const int rows : {10, 37, 1000}) {
    check_breakaway(sampled(zigzag({0, 0.1}, rows, true), hardening), 0.02, 20.0);
  }
}

TEST_CASE("of several knees the first one counts") {
  // Reference cases, M1: three sliders side by side yield at 0.01, 0.03 and 0.08 mm.
  const auto iwan = [](double x) {
    return std::min(1000 * x, 10.0) + std::min(500 * x, 15.0) + std::min(250 * x, 20.0);
  };
  for (const int rows : {20, 100, 1000}) {
    check_breakaway(sampled(zigzag({0, 0.1}, rows), iwan), 0.01, 17.5);
  }
}

TEST_CASE("a stop that is hit after the slip is not the initial slope") {
  const auto stop = [](double x) {
    return std::min(kStiffness * x, kLimit) + 5000.0 * std::max(0.0, x - 0.096);
  };
  check_breakaway(sampled(zigzag({0, 0.1}, 200), stop), 0.02, 20.0);
}

TEST_CASE("a small slip before the curve goes on as before is breakaway") {
  // 0.001 mm at 20 N, and on: 2.5 % of the largest change below the line ever after.
  const auto slip = [](double x) { return kStiffness * (x - std::clamp(x - 0.02, 0.0, 0.001)); };
  for (const int rows : {40, 200, 1000}) {
    CAPTURE(rows);
    check_breakaway(sampled(zigzag({0, 0.04}, rows), slip), 0.02, 20.0);
  }
}

TEST_CASE("of a drop from static to kinetic friction the peak is breakaway") {
  const auto drop = [](double x) { return x < 0.02 + 1e-12 ? 1200.0 * x : 20.0; };
  for (const int rows : {10, 50, 1000}) {  // with a row at 0.02
    CAPTURE(rows);
    check_breakaway(sampled(zigzag({0, 0.1}, rows), drop), 0.02, 24.0);
  }
  // Between rows, the peak is known to one row: 0.1/37.
  const Breakaway between = breakaway(sampled(zigzag({0, 0.1}, 37), drop));
  CHECK(between.abscissa <= 0.02);
  CHECK(between.abscissa > 0.02 - 0.1 / 37);
}

TEST_CASE("weakening after the peak does not move it") {
  const auto decay = [](double x) {
    return x <= 0.02 ? 1200.0 * x : 20.0 + 4.0 * std::exp(-(x - 0.02) / 0.02);
  };
  for (const int rows : {50, 1000}) {
    // The curvature of the decay within 2 % of the peak, traced back: second order in it.
    check_breakaway(sampled(zigzag({0, 0.1}, rows), decay), 0.02, 24.0, 2e-3);
  }
}

TEST_CASE("a clearance or a soft start before the stick is not the initial slope") {
  const auto clearance = [](double x) {
    return x < 0.01 ? 0.0 : std::min(1000 * (x - 0.01), 20.0);
  };
  check_breakaway(sampled(zigzag({0, 0.1}, 50), clearance), 0.03, 20.0);
  const auto soft = [](double x) {
    return x < 0.01 ? 3e4 * x * x : std::min(3.0 + 1000 * (x - 0.01), 20.0);
  };
  check_breakaway(sampled(zigzag({0, 0.1}, 500), soft), 0.027, 20.0);
}

TEST_CASE("a dwell at the start is part of the stick") {
  Series curve = slider({0, 0, 0, 0.01, 0.02, 0.03, 0.04});
  check_breakaway(curve, 0.02, 20.0);
}

TEST_CASE("a rigid start breaks away where it ends") {
  // The force rises before anything moves; or within one row, which is then the way to it.
  const Series vertical{{0, 0, 0, 0.01, 0.02}, {0, 10, 20, 20, 20}, {0, 1, 2, 3, 4}};
  check_breakaway(vertical, 0.0, 20.0);
  const Series peak{{0, 0, 0, 0.01, 0.02}, {0, 10, 24, 20, 20}, {}};
  check_breakaway(peak, 0.0, 24.0);
  const auto rigid = [](double x) { return x > 0.0 ? 20.0 : 0.0; };
  check_breakaway(sampled(zigzag({0, 0.1}, 1000), rigid), 1e-4, 20.0);
}

TEST_CASE("a smooth curve breaks away at the same place at any fine step") {
  // Dahl: 20 (1 - exp(-x/0.02)).
  const auto dahl = [](double x) { return 20.0 * (1.0 - std::exp(-x / 0.02)); };
  const Breakaway exact = breakaway(sampled(zigzag({0, 0.1}, 100000), dahl));
  REQUIRE(exact.fault.empty());
  CHECK(exact.abscissa > 0.0);
  CHECK(exact.value < 10.0);
  for (const int rows : {300, 1000}) {
    const Breakaway found = breakaway(sampled(zigzag({0, 0.1}, rows, true), dahl));
    // Chords instead of the curve: second order in the rows, some 1e-3 of the range at 300.
    CHECK(found.abscissa == Approx(exact.abscissa).margin(2e-3 * 0.1));
    CHECK(found.value == Approx(exact.value).margin(2e-3 * 20.0));
  }
}

TEST_CASE("without a breakaway there is a fault that says why") {
  CHECK(breakaway(slider(zigzag({0, 0.019}, 20))).fault == "never leaves its initial slope");
  CHECK_THAT(breakaway(slider(zigzag({0.0, 0.1}, 20), 20.0)).fault,
             Catch::Contains("same value all along"));
  CHECK(breakaway(Series{{0, 0}, {0, 20}, {}}).fault == "does not move");
  CHECK(breakaway(Series{{0}, {20}, {}}).fault == "is but a point");
  const Series broken = slider(zigzag({0, 0.1}, 20));
  const Series stuck = slider(zigzag({0, 0.019}, 20));
  CHECK(compare_breakaway(stuck, broken, relative(1.0)).fault ==
        "no breakaway: the result never leaves its initial slope");
  CHECK(compare_breakaway(broken, stuck, relative(1.0)).fault ==
        "no breakaway: the reference never leaves its initial slope");
}

TEST_CASE("value and position of breakaway have bounds of their own") {
  const Series reference = slider(zigzag({0, 0.1}, 20));
  const Series result = scaled(slider(zigzag({0, 0.1}, 33)), 1.0, 1.05);
  cases::Tolerance tolerance = absolute(1.1);
  tolerance.abscissa = 1e-6;
  const CurveComparison found = compare_breakaway(result, reference, tolerance);
  REQUIRE(found.measures.size() == 2);
  CHECK(measure(found, "value at breakaway").deviation == Approx(1.0));
  CHECK(measure(found, "value at breakaway").scale == Approx(20.0));
  CHECK(measure(found, "position of breakaway").unit == MeasureUnit::kAbscissa);
  CHECK(measure(found, "position of breakaway").scale == Approx(0.1));
  CHECK(passed(found));
  CHECK_FALSE(passed(compare_breakaway(result, reference, relative(0.04))));
  const Series softer = scaled(reference, 1.2, 1.0);
  CHECK_FALSE(passed(compare_breakaway(softer, reference, tolerance)));
  CHECK(passed(compare_breakaway(softer, reference, absolute(1e-6))));
}

}  // namespace
}  // namespace slipbench::driver::check
