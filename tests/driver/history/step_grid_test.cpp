// SPDX-License-Identifier: Apache-2.0
#include "driver/history/step_grid.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <utility>
#include <vector>

#include "driver/history/profile_cursor.hpp"

namespace slipbench::driver::history {
namespace {

std::vector<double> grid_of(double duration, std::int64_t increments,
                            const std::vector<Profile>& profiles = {}) {
  std::vector<ProfileCursor> cursors;
  for (const Profile& profile : profiles) {
    auto cursor = ProfileCursor::open(profile);
    REQUIRE(cursor);
    REQUIRE(cursor->begin({duration, 0.0, 0.0}));
    cursors.push_back(std::move(*cursor));
  }
  std::vector<double> times;
  StepGrid grid(duration, increments);
  while (!grid.at_end()) {
    const double t = grid.advance(next_breakpoint(cursors, grid.time()));
    for (ProfileCursor& cursor : cursors) cursor.value(t);
    times.push_back(t);
  }
  return times;
}

TEST_CASE("without breakpoints the grid is uniform and ends exactly") {
  const std::vector<double> times = grid_of(0.7, 7);
  REQUIRE(times.size() == 7);
  for (std::size_t i = 1; i < 7; ++i) {
    CHECK(times[i - 1] == 0.7 * static_cast<double>(i) / 7.0);
  }
  CHECK(times.back() == 0.7);
  CHECK(grid_of(3.0, 1) == std::vector{3.0});
  CHECK(grid_of(1e-9, 1000).size() == 1000);
  CHECK(grid_of(1.0 / 3.0, 999983).size() == 999983);
}

TEST_CASE("breakpoints are merged into the grid") {
  const Tabular table{{0.0, 0.3, 0.5, 2.0}, {0.0, 1.0, 0.0, 0.0}};
  CHECK(grid_of(1.0, 4, {table}) == std::vector{0.25, 0.3, 0.5, 0.75, 1.0});
  const Wave square{WaveShape::kSquare, 1.0, 0.4, 0.0, 0.0};
  const std::vector<double> times = grid_of(1.0, 2, {square, table});
  CHECK(times == std::vector{0.2, 0.3, 0.4, 0.5, 1.5 * 0.4, 0.8, 1.0});
}

TEST_CASE("a point that is a breakpoint but for rounding appears once, as the breakpoint") {
  const double period = 1.0 / 3.0;
  const Wave square{WaveShape::kSquare, 1.0, period, 0.0, 0.0};
  const std::vector<double> times = grid_of(100.0, 600, {square});
  REQUIRE(times.size() == 600);
  long wrong = 0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    wrong += times[i] == 0.5 * static_cast<double>(i + 1) * period ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(times.back() == 100.0);
}

TEST_CASE("breakpoints of two profiles at the same time make one point") {
  const Tabular table{{0.0, 1.0 / 3.0 + 1e-16, 1.0}, {0.0, 1.0, 0.0}};
  const Wave square{WaveShape::kSquare, 1.0, 2.0 / 3.0, 0.0, 0.0};
  CHECK(grid_of(1.0, 1, {table, square}).size() == 3);
}

TEST_CASE("a breakpoint beside the step's end does not make a splinter") {
  CHECK(grid_of(1.0, 2, {Tabular{{0.0, 1.0 - 1e-15, 2.0}, {0, 1, 2}}}) == std::vector{0.5, 1.0});
  CHECK(grid_of(1.0, 2, {Tabular{{0.0, 1e-15, 2.0}, {0, 1, 2}}}) == std::vector{0.5, 1.0});
}

TEST_CASE("many breakpoints in one uniform increment are all met") {
  const Wave triangle{WaveShape::kTriangle, 1.0, 0.01, 0.0, 0.0};
  const std::vector<double> times = grid_of(1.0, 1, {triangle});
  REQUIRE(times.size() == 201);
  for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] > times[i - 1]);
}

}  // namespace
}  // namespace slipbench::driver::history
