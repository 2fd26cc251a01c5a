// SPDX-License-Identifier: Apache-2.0
#include "driver/report/row_choice.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

namespace slipbench::driver {
namespace {

constexpr std::array<std::size_t, 1> kMotion{1};
constexpr double kPi = 3.14159265358979324;

/// Rows of time and motion, one for each.
RowChoice choice_of(const std::vector<double>& motion, std::size_t limit,
                    const std::set<std::size_t>& wanted = {}) {
  RowChoice choice(2, limit, kMotion, kMotion);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    choice.add(std::array{static_cast<double>(i), motion[i]}, wanted.contains(i));
  }
  return choice;
}

std::vector<double> wave(std::size_t rows, std::size_t rows_of_cycle, double ripple = 0.0) {
  std::vector<double> motion;
  for (std::size_t i = 0; i < rows; ++i) {
    const double phase = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(rows_of_cycle);
    motion.push_back(std::sin(phase) + ripple * std::sin(7.3 * static_cast<double>(i)));
  }
  return motion;
}

bool has(const DrawnRows& drawn, std::int64_t index) {
  return std::binary_search(drawn.rows.index.begin(), drawn.rows.index.end(), index);
}

TEST_CASE("a run that fits keeps every row and needs no stretches") {
  const DrawnRows drawn = choice_of(wave(400, 50), 400).finish();
  CHECK_FALSE(drawn.thinned);
  CHECK(drawn.rows.size() == 400);
  CHECK_FALSE(drawn.cycle);
  CHECK_FALSE(drawn.beginning);
}

TEST_CASE("the last whole cycle of a long run keeps every row") {
  for (const double ripple : {0.0, 0.05}) {
    CAPTURE(ripple);
    const DrawnRows drawn = choice_of(wave(100000, 150, ripple), 400).finish();
    REQUIRE(drawn.thinned);
    REQUIRE(drawn.cycle);
    CHECK(drawn.rows.size() <= 800);
    // A cycle ends with the row that begins the next; ripples shift that by some rows.
    CHECK(std::abs(static_cast<double>(drawn.cycle->rows) - 151.0) <= (ripple > 0.0 ? 6.0 : 1.0));
    CHECK(static_cast<std::int64_t>(drawn.cycle->last - drawn.cycle->first) + 1 ==
          drawn.cycle->rows);
    const std::int64_t begin = drawn.rows.index[drawn.cycle->first];
    const std::int64_t end = drawn.rows.index[drawn.cycle->last];
    CHECK(end - begin + 1 == drawn.cycle->rows);
    CHECK(end > 100000 - 300);
    REQUIRE(drawn.beginning);
    CHECK(drawn.beginning->first == 0);
    // Up to the first turn, and half of the way back.
    CHECK(drawn.rows.index[drawn.beginning->last] >= 37);
    CHECK(drawn.rows.index[drawn.beginning->last] <= 76);
    for (std::size_t i = 0; i < drawn.rows.size(); ++i) {
      REQUIRE(drawn.rows.numbers[2 * i] == static_cast<double>(drawn.rows.index[i]));
    }
  }
}

TEST_CASE("a cycle of too many rows is drawn with half of the limit") {
  const DrawnRows drawn = choice_of(wave(40000, 8000), 400).finish();
  REQUIRE(drawn.cycle);
  CHECK(drawn.cycle->rows == Approx(8001).margin(1));
  const std::size_t shown = drawn.cycle->last - drawn.cycle->first + 1;
  CHECK(shown >= 100);
  CHECK(shown <= 400);
}

TEST_CASE("a motion that never turns has no cycle") {
  std::vector<double> motion;
  for (int i = 0; i < 5000; ++i) motion.push_back(1e-3 * i + 0.01 * std::sin(i));
  const DrawnRows drawn = choice_of(motion, 400).finish();
  CHECK(drawn.thinned);
  CHECK_FALSE(drawn.cycle);
  CHECK_FALSE(drawn.beginning);
}

TEST_CASE("of too many wanted rows the first and the last ones stay") {
  std::set<std::size_t> wanted;
  for (std::size_t i = 5; i < 20000; i += 10) wanted.insert(i);
  const DrawnRows drawn = choice_of(wave(20000, 20000), 400, wanted).finish();
  CHECK(drawn.rows.size() <= 800);
  for (std::int64_t k = 0; k < 50; ++k) {
    CAPTURE(k);
    CHECK(has(drawn, 5 + 10 * k));
    CHECK(has(drawn, 19995 - 10 * k));
  }
}

TEST_CASE("rows about given times: the nearest, its neighbours, and those of others") {
  RowsAtTimes rows({500.0, 20.4, 20.6, 5000.0});
  RowChoice choice(2, 100, kMotion, kMotion);
  for (int i = 0; i < 1000; ++i) {
    const std::array row{static_cast<double>(i), std::sin(0.1 * i)};
    rows.add(row);
    choice.add(row, false);
  }
  CHECK(rows.rows().index == std::vector<std::int64_t>{19, 20, 21, 22, 498, 499, 500, 501});
  CHECK_FALSE(rows.done());  // nothing is as late as the last one
  const DrawnRows drawn = choice.finish(rows.rows());
  for (const std::int64_t index : rows.rows().index) CHECK(has(drawn, index));
  CHECK(std::is_sorted(drawn.rows.index.begin(), drawn.rows.index.end()));
}

}  // namespace
}  // namespace slipbench::driver
