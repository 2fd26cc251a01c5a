// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/interpolation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace slipbench::driver::check {
namespace {

TEST_CASE("a branch is read linearly between its rows and not outside") {
  const Series curve{{0, 1, 3}, {0, 10, 30}, {0, 2, 4}};
  BranchInterpolation read(curve, {0, 2, 1}, 1e-12);
  CHECK(read.at(0.25, 0)->value == Approx(2.5));
  CHECK(read.at(0.25, 0)->time == Approx(0.5));
  CHECK(read.at(2.0, 0)->value == Approx(20.0));
  CHECK(read.at(3.0, 0)->value == 30.0);
  CHECK(read.at(3.0 + 1e-13, 0)->value == 30.0);
  CHECK_FALSE(read.at(3.1, 0));
  CHECK_FALSE(read.at(-0.1, 0));
}

TEST_CASE("a decreasing branch is read within its own rows only") {
  const Series curve{{0, 2, 1, 0}, {0, 20, -10, -5}, {}};
  BranchInterpolation back(curve, {1, 3, -1}, 1e-12);
  CHECK(back.at(0.5, 0)->value == Approx(-7.5));
  CHECK(back.at(2.0, 0)->value == 20.0);
  CHECK(std::isnan(back.at(0.5, 0)->time));
}

TEST_CASE("of the values at a jump the nearest counts, and nothing in between") {
  const Series jump{{0, 1, 1, 2}, {0, 0, 20, 20}, {0, 1, 1, 2}};
  BranchInterpolation read(jump, {0, 3, 1}, 1e-12);
  CHECK(read.at(1.0, 1.0)->value == 0.0);
  CHECK(read.at(1.0, 19.0)->value == 20.0);
  CHECK(read.at(1.0, 25.0)->value == 20.0);
  CHECK(read.at(1.0 + 1e-14, -3.0)->value == 0.0);
  CHECK(read.at(1.0 - 1e-14, 19.0)->value == 20.0);
  CHECK(read.at(1.0 - 1e-6, 19.0)->value == Approx(0.0));
  CHECK(read.at(1.0 + 1e-6, 1.0)->value == Approx(20.0));
}

TEST_CASE("two jumps are told apart") {
  const Series jumps{{0, 1, 1, 2, 2, 3}, {0, 0, 20, 20, 40, 40}, {}};
  BranchInterpolation read(jumps, {0, 5, 1}, 1e-12);
  CHECK(read.at(1.0, 19.0)->value == 20.0);
  CHECK(read.at(2.0, 39.0)->value == 40.0);
  CHECK(read.at(1.0, 1.0)->value == 0.0);
}

TEST_CASE("a step back by rounding stays where the branch already was") {
  const Series curve{{0, 1, 1 - 1e-10, 2}, {0, 10, 15, 20}, {}};
  BranchInterpolation read(curve, {0, 3, 1}, 1e-12);
  CHECK(read.at(1.0, 9.0)->value == 10.0);
  CHECK(read.at(1.0, 16.0)->value == 15.0);
  CHECK(read.at(1.5, 0.0)->value == Approx(17.5));
}

TEST_CASE("a dwell in which time passes goes through the values in between") {
  const Series dwell{{0, 1, 1, 1, 2}, {0, 0, 20, 5, 5}, {0, 1, 2, 3, 4}};
  BranchInterpolation read(dwell, {0, 4, 1}, 1e-12);
  CHECK(read.at(1.0, 7.5)->value == 7.5);
  CHECK(read.at(1.0, 21.0)->value == 20.0);
  CHECK(read.at(1.0, -1.0)->value == 0.0);
  Series unknown = dwell;
  unknown.time.change().clear();
  BranchInterpolation rows_only(unknown, {0, 4, 1}, 1e-12);
  CHECK(rows_only.at(1.0, 7.5)->value == 5.0);
}

TEST_CASE("a dwell with jumps goes through what lies between these, however many there are") {
  constexpr int kRanges = 40000;
  constexpr int kQuestions = 200000;
  // From 0 to 1, from 10 to 11 and so on, by turns from both ends; then from 4 to 12 at once.
  Series dwell;
  const auto pass = [&](double time, double from, double to) {
    for (const double part : {0.0, 1.0}) {
      dwell.abscissa.push_back(1.0);
      dwell.value.push_back(from + part * (to - from));
      dwell.time.push_back(time + part);
    }
  };
  for (int i = 0; i < kRanges; ++i) {
    const double from = 10.0 * (i % 2 == 0 ? i : kRanges - i);
    pass(i, from, from + 1.0);
  }
  pass(kRanges, 4.0, 12.0);
  BranchInterpolation read(dwell, {0, dwell.value.size() - 1, 1}, 1e-12);
  CHECK(read.at(1.0, 0.25)->value == 0.25);
  CHECK(read.at(1.0, 2.0)->value == 1.0);
  CHECK(read.at(1.0, 3.0)->value == 4.0);
  CHECK(read.at(1.0, 9.0)->value == 9.0);
  CHECK(read.at(1.0, 11.5)->value == 11.5);
  CHECK(read.at(1.0, 13.0)->value == 12.0);
  CHECK(read.at(1.0, 19.0)->value == 20.0);
  CHECK(read.at(1.0, -1.0)->value == 0.0);
  // Each range anew for each question would be 8 10^9.
  int within = 0;
  for (int i = 0; i < kQuestions; ++i) {
    const double wanted = 10.0 * (i % kRanges) + (i < kRanges ? 0.5 : 2.5);
    within += read.at(1.0, wanted)->value == wanted ? 1 : 0;
  }
  CHECK(within == kRanges);
}

TEST_CASE("near a rest its values count, and those on the way to it") {
  const Series curve{
      {0, 0.8, 1, 1, 1, 1.1, 2}, {30, 20, 20, 0, -10, -12, -12}, {0, 1, 2, 3, 4, 5, 6}};
  BranchInterpolation read(curve, {0, 6, 1}, 1e-12);
  REQUIRE(read.has_rests());
  // Within the increment before it and the one behind it.
  CHECK(read.at(0.9, 5.0)->value == 5.0);
  CHECK(read.at(0.9, 25.0)->value == 20.0);
  CHECK(read.at(1.05, 15.0)->value == 15.0);
  CHECK(read.at(1.05, -11.7)->value == -11.7);
  CHECK(read.at(0.7, 5.0)->value == Approx(21.25));
  CHECK(read.at(1.2, 5.0)->value == -12.0);
  // A row of a curve that rests itself may be further away.
  CHECK(read.at(0.7, 5.0, 0.35)->value == 5.0);
  CHECK(read.at(1.2, 5.0, 0.1)->value == 5.0);
  CHECK(read.at(1.4, 5.0, 0.1)->value == -12.0);
  // Nothing of this where the other curve rests in the same place.
  BranchInterpolation shared(curve, {0, 6, 1}, 1e-12);
  shared.match_rests({{0, 0.9, 1, 1, 2}, {0, 0, 0, 0, 0}, {}}, {0, 4, 1});
  CHECK(shared.at(0.9, 5.0)->value == Approx(20.0));
  CHECK(shared.at(1.0, 5.0)->value == 5.0);
  // Time does not rest.
  Series over_time = curve;
  over_time.time = over_time.abscissa;
  BranchInterpolation jumps(over_time, {0, 6, 1}, 1e-12);
  CHECK_FALSE(jumps.has_rests());
  CHECK(jumps.at(0.9, 5.0)->value == Approx(20.0));
}

TEST_CASE("an abscissa that creeps by less than rounding costs no more than others") {
  constexpr std::size_t kRows = 100000;
  Series creeping;
  for (std::size_t i = 0; i < kRows; ++i) {
    const auto t = static_cast<double>(i);
    creeping.abscissa.push_back(1e-16 * t);
    creeping.value.push_back(std::sin(t));
    creeping.time.push_back(t);
  }
  creeping.abscissa.push_back(1.0);
  creeping.value.push_back(0.0);
  creeping.time.push_back(static_cast<double>(kRows));
  BranchInterpolation read(creeping, {0, kRows, 1}, 1e-12);
  // 10^5 questions to 10^4 rows each would take minutes.
  for (std::size_t i = 0; i < kRows; ++i) {
    if (std::abs(read.at(creeping.abscissa[i], 0.5)->value - 0.5) > 1e-12) FAIL(i);
  }
  SUCCEED();
}

}  // namespace
}  // namespace slipbench::driver::check
