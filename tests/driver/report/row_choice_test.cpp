// SPDX-License-Identifier: Apache-2.0
#include "driver/report/row_choice.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace slipbench::driver::report {
namespace {

constexpr std::array<std::size_t, 1> kMotion{1};
constexpr double kPi = 3.14159265358979324;

/// Rows of time and motion, one for each.
RowChoice choice_of(const std::vector<double>& motion, std::size_t limit,
                    const std::set<std::size_t>& wanted = {}) {
  RowChoice choice(2, limit, kMotion);
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

TEST_CASE("a run that fits keeps every row and needs no pieces") {
  const DrawnRows drawn = choice_of(wave(400, 50), 400).finish();
  CHECK_FALSE(drawn.thinned);
  CHECK(drawn.rows.size() == 400);
  CHECK(drawn.low.empty());
  CHECK(drawn.cycles.empty());
}

TEST_CASE("of a long run each piece keeps its first and last row and its extremes") {
  std::vector<double> motion = wave(100000, 100000);
  motion[77777] = 5.0;
  motion[33333] = std::numeric_limits<double>::quiet_NaN();
  const DrawnRows drawn = choice_of(motion, 400).finish();
  REQUIRE(drawn.thinned);
  const std::size_t pieces = drawn.low.size() / 2;
  CHECK(pieces >= 50);
  CHECK(pieces <= 100);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    CAPTURE(piece);
    const auto begin = static_cast<std::int64_t>(piece) * drawn.piece;
    const std::int64_t end = std::min<std::int64_t>(begin + drawn.piece, 100000);
    CHECK(has(drawn, begin));
    CHECK(has(drawn, end - 1));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::int64_t i = begin; i < end; ++i) {
      const double value = motion[static_cast<std::size_t>(i)];
      if (value < low) low = value;
      if (value > high) high = value;
    }
    CHECK(drawn.low[2 * piece + 1] == low);
    CHECK(drawn.high[2 * piece + 1] == high);
  }
  for (std::size_t i = 0; i < drawn.rows.size(); ++i) {
    REQUIRE(drawn.rows.numbers[2 * i] == static_cast<double>(drawn.rows.index[i]));
  }
}

TEST_CASE("of many cycles the first, the last and some between are whole") {
  for (const double ripple : {0.0, 0.05}) {
    CAPTURE(ripple);
    const DrawnRows drawn = choice_of(wave(100001, 1000, ripple), 16000).finish();
    REQUIRE(drawn.thinned);
    CHECK(std::abs(static_cast<double>(drawn.cycles_total) - 100.0) <= (ripple > 0.0 ? 1.0 : 0.0));
    REQUIRE(drawn.cycles.size() >= 6);
    CHECK(drawn.cycles.front().number == 1);
    if (ripple == 0.0) CHECK(drawn.cycles.front().first == 0);
    std::vector<std::int64_t> numbers;
    for (const DrawnCycle& cycle : drawn.cycles) {
      CAPTURE(cycle.number);
      if (cycle.number > 0) numbers.push_back(cycle.number);
      // All rows are there.
      const std::int64_t rows = drawn.rows.index[cycle.last] - drawn.rows.index[cycle.first];
      CHECK(static_cast<std::int64_t>(cycle.last - cycle.first) == rows);
      // Ripples shift the end of a cycle by some rows.
      if (cycle.number > 0) {
        CHECK(std::abs(static_cast<double>(rows) - 1000.0) <= (ripple > 0.0 ? 40.0 : 1.0));
      }
    }
    if (ripple == 0.0) CHECK(numbers == std::vector<std::int64_t>{1, 2, 5, 10, 20, 50, 100});
    CHECK(drawn.motion == 1);
  }
}

TEST_CASE("of a cycle of too many rows none is drawn in part") {
  const DrawnRows drawn = choice_of(wave(40000, 8000), 400).finish();
  CHECK(drawn.thinned);
  CHECK(drawn.cycles.empty());
}

TEST_CASE("a motion that never turns has no cycle") {
  std::vector<double> motion(5000);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const auto t = static_cast<double>(i);
    motion[i] = 1e-3 * t + 0.01 * std::sin(t);
  }
  const DrawnRows drawn = choice_of(motion, 400).finish();
  CHECK(drawn.thinned);
  CHECK(drawn.cycles.empty());
}

TEST_CASE("a page of many cases has fewer rows of each") {
  CHECK(most_rows(1) == 50000);
  CHECK(most_rows(10) == 50000);
  CHECK(most_rows(50) == 10000);
  CHECK(most_rows(100000) == 2500);
}

TEST_CASE("of many columns fewer rows stay") {
  for (const std::size_t columns : {64U, 65U, 640U}) {
    CAPTURE(columns);
    RowChoice choice(columns, 50000, {});
    const std::vector<double> row(columns, 1.0);
    for (int i = 0; i < 50000; ++i) choice.add(row, false);
    CHECK(choice.thinned() == (columns > 64));
    CHECK(choice.finish().rows.numbers.size() <= std::size_t{64} * 50000);
  }
}

TEST_CASE("of too many wanted rows the first and the last ones stay") {
  std::set<std::size_t> wanted;
  for (std::size_t i = 5; i < 20000; i += 10) wanted.insert(i);
  const DrawnRows drawn = choice_of(wave(20000, 20000), 400, wanted).finish();
  CHECK(drawn.rows.size() <= 800);
  for (std::int64_t k = 0; k < 25; ++k) {
    CAPTURE(k);
    CHECK(has(drawn, 5 + 10 * k));
    CHECK(has(drawn, 19995 - 10 * k));
  }
}

TEST_CASE("rows about given times: the nearest, its neighbours, and those of others") {
  RowsAtTimes rows({500.0, 20.4, 20.6, 5000.0});
  RowChoice choice(2, 100, kMotion);
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
}  // namespace slipbench::driver::report
