// SPDX-License-Identifier: Apache-2.0
#include "driver/history/profile_cursor.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/driver/support/temporary_folder.hpp"

namespace slipbench::driver::history {
namespace {

constexpr double kPi = std::numbers::pi;

ProfileCursor opened(Profile profile) {
  auto cursor = ProfileCursor::open(std::move(profile));
  REQUIRE(cursor);
  return std::move(*cursor);
}

ProfileCursor begun(Profile profile, const StepStart& start) {
  ProfileCursor cursor = opened(std::move(profile));
  REQUIRE(cursor.begin(start));
  return cursor;
}

/// All breakpoints of a step in (0, duration].
std::vector<double> breakpoints(ProfileCursor& cursor, double duration) {
  std::vector<double> times;
  for (double t = cursor.next_breakpoint(0.0); t <= duration; t = cursor.next_breakpoint(t)) {
    times.push_back(t);
    cursor.value(t);
  }
  return times;
}

CsvColumn csv(const std::filesystem::path& file, base::UnitConversion value = {}) {
  return {{file, "rig.csv"}, "t", {}, "x", value};
}

TEST_CASE("a constant has its value from the step's start on") {
  ProfileCursor cursor = begun(Constant{3.0}, {2.0, 1.0, 0.0});
  CHECK(cursor.start_value() == 3.0);
  CHECK(cursor.value(0.5) == 3.0);
  CHECK(cursor.next_breakpoint(0.0) == kNoBreakpoint);
}

TEST_CASE("a linear profile goes from the current value exactly to its target") {
  ProfileCursor cursor = begun(LinearTo{0.3}, {0.7, 0.1, 5.0});
  CHECK(cursor.start_value() == 0.1);
  CHECK(cursor.value(0.35) == Approx(0.2).epsilon(1e-15));
  CHECK(cursor.value(0.7) == 0.3);
}

TEST_CASE("a smooth profile follows the quintic with flat ends") {
  ProfileCursor cursor = begun(SmoothTo{3.0}, {2.0, 1.0, 0.0});
  CHECK(cursor.start_value() == 1.0);
  // xi = 1/4: (1/64) (10 - 15/4 + 6/16) = 53/512, exact in binary.
  CHECK(cursor.value(0.5) == 1.0 + 2.0 * 53.0 / 512.0);
  CHECK(cursor.value(1.0) == 2.0);
  CHECK(cursor.value(2.0) == 3.0);
  ProfileCursor again = begun(SmoothTo{3.0}, {2.0, 1.0, 0.0});
  // Near an end the way is 10 xi^3: neither rate nor acceleration.
  CHECK(again.value(2e-4) - 1.0 == Approx(2.0 * 1e-11).epsilon(1e-2));
}

TEST_CASE("a sine follows its formula") {
  const Wave wave{WaveShape::kSine, 0.2, 0.5, 0.45, kPi / 6.0};
  ProfileCursor cursor = begun(wave, {2.0, 0.0, 0.0});
  // sin(pi/6) = 1/2; a rounding of the argument dominates.
  CHECK(cursor.start_value() == Approx(0.55).epsilon(1e-15));
  CHECK(cursor.value(0.125) == Approx(0.45 + 0.2 * std::cos(kPi / 6.0)).epsilon(1e-15));
  CHECK(cursor.next_breakpoint(0.0) == kNoBreakpoint);
}

TEST_CASE("a triangle rises from its mean to its peak at a quarter of its period") {
  ProfileCursor cursor = begun(Wave{WaveShape::kTriangle, 2.0, 4.0, 1.0, 0.0}, {8.0, 0.0, 0.0});
  CHECK(cursor.start_value() == 1.0);
  const std::vector<std::pair<double, double>> points = {{0.5, 2.0}, {1.0, 3.0},  {1.5, 2.0},
                                                         {2.0, 1.0}, {3.0, -1.0}, {4.0, 1.0},
                                                         {5.0, 3.0}, {8.0, 1.0}};
  for (const auto& [t, value] : points) CHECK(cursor.value(t) == value);
  ProfileCursor corners = begun(Wave{WaveShape::kTriangle, 2.0, 4.0, 1.0, 0.0}, {8.0, 0.0, 0.0});
  CHECK(breakpoints(corners, 8.0) == std::vector{1.0, 3.0, 5.0, 7.0});
}

TEST_CASE("a triangle's peaks are met exactly, also after many periods") {
  const double period = 1.0 / 3.0;
  const double duration = 40000.0;
  ProfileCursor cursor =
      begun(Wave{WaveShape::kTriangle, 0.7, period, 0.0, 0.0}, {duration, 0.0, 0.0});
  double t = 0.0;
  long wrong = 0;
  for (long k = 0; k < 240000; ++k) {
    t = cursor.next_breakpoint(t);
    wrong += t == (0.25 + 0.5 * static_cast<double>(k)) * period ? 0 : 1;
    wrong += cursor.value(t) == (k % 2 == 0 ? 0.7 : -0.7) ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a square jumps at every half period, and its value there is the one before the jump") {
  ProfileCursor cursor = begun(Wave{WaveShape::kSquare, 2.0, 0.2, 1.0, 0.0}, {1.0, 0.0, 0.0});
  CHECK(cursor.start_value() == 3.0);
  CHECK(cursor.value(0.05) == 3.0);
  const std::vector<double> jumps = breakpoints(cursor, 1.0);
  REQUIRE(jumps.size() == 10);
  ProfileCursor again = begun(Wave{WaveShape::kSquare, 2.0, 0.2, 1.0, 0.0}, {1.0, 0.0, 0.0});
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const double before = i % 2 == 0 ? 3.0 : -1.0;
    CHECK(again.value(jumps[i]) == before);
    CHECK(again.value_after(jumps[i]) == 2.0 - before);
    // A time that rounding has put beside the jump is the jump.
    CHECK(again.value(jumps[i] * (1.0 + 1e-15)) == before);
    CHECK(again.value_after(jumps[i] * (1.0 - 1e-15)) == 2.0 - before);
  }
}

TEST_CASE("a sawtooth rises through its mean at phase 0 and jumps at half its period") {
  ProfileCursor cursor = begun(Wave{WaveShape::kSawtooth, 1.0, 2.0, 0.0, 0.0}, {4.0, 0.0, 0.0});
  CHECK(cursor.start_value() == 0.0);
  CHECK(cursor.value(0.5) == 0.5);
  CHECK(cursor.value(1.0) == 1.0);
  CHECK(cursor.value_after(1.0) == -1.0);
  CHECK(cursor.value(1.5) == -0.5);
  CHECK(cursor.value(3.0) == 1.0);
  ProfileCursor jumps = begun(Wave{WaveShape::kSawtooth, 1.0, 2.0, 0.0, 0.0}, {4.0, 0.0, 0.0});
  CHECK(breakpoints(jumps, 4.0) == std::vector{1.0, 3.0});
}

TEST_CASE("a phase moves every wave to the left") {
  for (const WaveShape shape :
       {WaveShape::kSine, WaveShape::kTriangle, WaveShape::kSawtooth, WaveShape::kSquare}) {
    ProfileCursor plain = begun(Wave{shape, 1.0, 2.0, 0.5, 0.0}, {40.0, 0.0, 0.0});
    ProfileCursor moved = begun(Wave{shape, 1.0, 2.0, 0.5, 0.3 * kPi}, {40.0, 0.0, 0.0});
    // 0.3 pi of 2 pi are 0.15 of the period, 0.3 in time. Times that fall on no jump of either.
    for (double t = 0.01; t < 38.0; t += 0.0937) {
      CHECK(moved.value(t) == Approx(plain.value(t + 0.3)).margin(1e-12));
    }
  }
  ProfileCursor quarter = begun(Wave{WaveShape::kTriangle, 1.0, 1.0, 0.0, kPi / 2.0}, {1.0, 0, 0});
  CHECK(quarter.start_value() == 1.0);
  CHECK(quarter.next_breakpoint(0.0) == 0.5);
  ProfileCursor negative = begun(Wave{WaveShape::kSquare, 1.0, 1.0, 0.0, -kPi}, {1.0, 0, 0});
  CHECK(negative.start_value() == -1.0);
}

TEST_CASE("a table is linear between its points and held outside") {
  const Tabular table{{0.5, 1.0, 2.0}, {1.0, 3.0, -1.0}};
  ProfileCursor cursor = begun(table, {3.0, 0.0, 0.0});
  CHECK(cursor.start_value() == 1.0);
  const std::vector<std::pair<double, double>> points = {
      {0.25, 1.0}, {0.5, 1.0}, {0.75, 2.0}, {1.0, 3.0}, {1.5, 1.0}, {2.0, -1.0}, {3.0, -1.0}};
  for (const auto& [t, value] : points) CHECK(cursor.value(t) == value);
  ProfileCursor again = begun(table, {3.0, 0.0, 0.0});
  CHECK(breakpoints(again, 3.0) == std::vector{0.5, 1.0, 2.0});
  CHECK_FALSE(covers(table, 2.0));
  CHECK_FALSE(covers(Tabular{{0.0, 1.0}, {0.0, 1.0}}, 1.1));
  CHECK(covers(Tabular{{-1.0, 0.99999999999}, {0.0, 1.0}}, 1.0));
}

TEST_CASE("an unsound table or wave is refused") {
  CHECK(ProfileCursor::open(Tabular{{0.0}, {1.0}}).error().message ==
        "1 point; two or more are wanted");
  CHECK(ProfileCursor::open(Tabular{{}, {}}).error().message == "0 points; two or more are wanted");
  CHECK(ProfileCursor::open(Tabular{{0.0, 1.0}, {1.0}}).error().message == "2 times but 1 values");
  CHECK(ProfileCursor::open(Tabular{{0.0, 1.0, 1.0}, {1, 2, 3}}).error().message ==
        "the times do not increase: point 3 at 1 after point 2 at 1");
  CHECK(ProfileCursor::open(Tabular{{0.0, 1.0}, {1.0, std::nan("")}}).error().message ==
        "point 2 is not finite");
  CHECK(ProfileCursor::open(Wave{WaveShape::kSine, 1.0, 0.0, 0.0, 0.0}).error().message ==
        "the period must be positive, not 0");
  CHECK(ProfileCursor::open(Wave{WaveShape::kSine, 1.0, 1.0, 0.0, -1e20}).error().message ==
        "the phase -1e+20 is more than a billion radians");
  CHECK_FALSE(ProfileCursor::open(Wave{WaveShape::kSine, std::nan(""), 1.0, 0.0, 0.0}));
  ProfileCursor dense = opened(Wave{WaveShape::kSquare, 1.0, 1e-12, 0.0, 0.0});
  CHECK_FALSE(dense.begin({1.0, 0.0, 0.0}));
}

TEST_CASE("a formula sees the time in the step and the total time") {
  auto profile = compile_profile("= a*t + T", {{"a", 10.0}});
  REQUIRE(profile);
  ProfileCursor cursor = begun(*profile, {2.0, 0.0, 100.0});
  CHECK(cursor.start_value() == 100.0);
  CHECK(cursor.value(0.5) == 105.5);
  REQUIRE(cursor.begin({2.0, 0.0, 102.0}));
  CHECK(cursor.value(0.5) == 107.5);
  CHECK(compile_profile("2*x", {}).error().unknown_name == "x");
}

TEST_CASE("a formula without a value gives NaN and an error, not a number") {
  ProfileCursor cursor = begun(*compile_profile("1/(t - 1)", {}), {2.0, 0.0, 0.0});
  CHECK(cursor.value(0.5) == -2.0);
  CHECK_FALSE(cursor.error());
  CHECK(std::isnan(cursor.value(1.0)));
  REQUIRE(cursor.error());
  CHECK(cursor.error()->message == "1/(t - 1) divides by zero at t = 1");
  ProfileCursor at_start = opened(*compile_profile("1/t", {}));
  CHECK(at_start.begin({1.0, 0.0, 0.0}).error().message == "1/t divides by zero at t = 0");
}

TEST_CASE("columns of a file are linear between the rows, which are breakpoints") {
  const TemporaryFolder folder;
  const auto file = folder.write("rig.csv", "t,x\n-3,7\n-2,8\n-1,9\n0,1\n0.5,2\n2,5\n3,6\n");
  ProfileCursor cursor = opened(csv(file, {2.0, 0.0}));
  for (int repeat = 0; repeat < 2; ++repeat) {
    REQUIRE(cursor.begin({2.5, 0.0, 0.0}));
    CHECK(cursor.start_value() == 2.0);
    CHECK(cursor.next_breakpoint(0.0) == 0.5);
    CHECK(cursor.value(0.25) == 3.0);
    CHECK(cursor.next_breakpoint(0.25) == 0.5);
    CHECK(cursor.value(0.5) == 4.0);
    CHECK(cursor.next_breakpoint(0.5) == 2.0);
    CHECK(cursor.value(0.5) == 4.0);
    CHECK(cursor.value(1.25) == 7.0);
    CHECK(cursor.value(2.0) == 10.0);
    CHECK(cursor.next_breakpoint(2.0) == 3.0);
    CHECK(cursor.value(2.5) == 11.0);
    CHECK_FALSE(cursor.error());
  }
}

TEST_CASE("a file that does not cover the step is refused, at either end") {
  const TemporaryFolder folder;
  const auto file = folder.write("rig.csv", "t,x\n0,1\n0.5,2\n");
  ProfileCursor cursor = begun(csv(file), {1.0, 0.0, 0.0});
  CHECK(cursor.value(0.5) == 2.0);
  CHECK(cursor.next_breakpoint(0.5) == kNoBreakpoint);
  CHECK(std::isnan(cursor.value(1.0)));
  REQUIRE(cursor.error());
  CHECK(cursor.error()->message == "the data end at t = 0.5; the step lasts to t = 1");
  CHECK(cursor.error()->line == 3);
  CHECK(cursor.error()->file == "rig.csv");
  const auto late = folder.write("late.csv", "t,x\n0.25,1\n1,2\n");
  ProfileCursor late_cursor = opened(csv(late));
  CHECK(late_cursor.begin({1.0, 0.0, 0.0}).error().message ==
        "the data start at t = 0.25; the step starts at t = 0");
  // The last digits of a text do not count.
  const auto rounded = folder.write("rounded.csv", "t,x\n0,1\n0.333333333333,2\n");
  ProfileCursor rounded_cursor = begun(csv(rounded), {1.0 / 3.0, 0.0, 0.0});
  CHECK(rounded_cursor.value(1.0 / 3.0) == 2.0);
}

TEST_CASE("a faulty row of a file shows when the step comes to it") {
  const TemporaryFolder folder;
  const auto file = folder.write("rig.csv", "t,x\n0,1\n1,2\n2,abc\n");
  ProfileCursor cursor = begun(csv(file), {2.0, 0.0, 0.0});
  CHECK(cursor.value(1.0) == 2.0);
  CHECK(std::isnan(cursor.value(1.5)));
  REQUIRE(cursor.error());
  CHECK(cursor.error()->line == 4);
  CHECK(std::isnan(cursor.value(2.0)));
  ProfileCursor one = opened(csv(folder.write("one.csv", "t,x\n0,1\n")));
  CHECK(one.begin({1.0, 0.0, 0.0}).error().message ==
        "there is one row; a history needs two or more");
  CHECK(ProfileCursor::open(csv(folder.path() / "none.csv")).error().kind ==
        base::HistoryError::Kind::kEnvironment);
}

TEST_CASE("the first breakpoint of several profiles comes first") {
  std::vector<ProfileCursor> cursors;
  cursors.push_back(begun(Wave{WaveShape::kSquare, 1.0, 1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}));
  cursors.push_back(begun(Tabular{{0.0, 0.75, 2.0}, {0, 1, 2}}, {2.0, 0.0, 0.0}));
  cursors.push_back(begun(Constant{1.0}, {2.0, 0.0, 0.0}));
  CHECK(next_breakpoint(cursors, 0.0) == 0.5);
  CHECK(next_breakpoint(cursors, 0.5) == 0.75);
  CHECK(next_breakpoint(cursors, 0.75) == 1.0);
  CHECK(next_breakpoint({}, 0.0) == kNoBreakpoint);
}

}  // namespace
}  // namespace slipbench::driver::history
