// SPDX-License-Identifier: Apache-2.0
#include "driver/results/thinning.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace slipbench::driver::results {
namespace {

/// Rows of `columns` numbers, the first of which is the number of the row.
struct Table {
  std::size_t columns = 0;
  std::vector<double> numbers;

  std::size_t size() const { return numbers.size() / columns; }
  double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
};

/// A random walk, a wave of random length, noise with rare spikes and a constant, as they come.
Table random_table(std::mt19937& random, std::size_t rows, std::size_t columns) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Table table{columns, {}};
  std::vector<double> walk(columns, 0.0);
  const double wave = 0.001 + std::abs(unit(random));
  for (std::size_t i = 0; i < rows; ++i) {
    table.numbers.push_back(static_cast<double>(i));
    for (std::size_t c = 1; c < columns; ++c) {
      walk[c] += unit(random);
      const double spike = unit(random) > 0.999 ? 100.0 * unit(random) : 0.0;
      const std::array<double, 4> kinds{walk[c], std::sin(wave * static_cast<double>(i)),
                                        unit(random) + spike, 7.0};
      table.numbers.push_back(kinds[c % kinds.size()]);
    }
  }
  return table;
}

Table thin(const Table& table, std::size_t limit, std::span<const std::size_t> watched = {}) {
  Table thinned{table.columns, {}};
  for (const std::size_t row : thinned_rows(table.numbers, table.columns, limit, watched)) {
    const auto numbers = std::span(table.numbers).subspan(row * table.columns, table.columns);
    thinned.numbers.insert(thinned.numbers.end(), numbers.begin(), numbers.end());
  }
  return thinned;
}

std::vector<std::size_t> numbers_of(const Table& table) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < table.size(); ++i) {
    numbers.push_back(static_cast<std::size_t>(table.at(i, 0)));
  }
  return numbers;
}

TEST_CASE("a thinned table keeps ends, extremes, order and its limit") {
  std::mt19937 random(20240611);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t columns = 2 + random() % 9;
    const std::size_t rows = 1 + random() % 20000;
    const std::size_t limit = 60 + random() % 500;
    const Table table = random_table(random, rows, columns);
    const std::vector<std::size_t> watched{columns - 1};
    const Table thinned =
        thin(table, limit, trial % 2 == 0 ? std::span<const std::size_t>() : watched);
    CAPTURE(trial, columns, rows, limit);

    REQUIRE(thinned.size() <= limit);
    const std::vector<std::size_t> numbers = numbers_of(thinned);
    CHECK(std::is_sorted(numbers.begin(), numbers.end()));
    CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
    CHECK(numbers.front() == 0);
    CHECK(numbers.back() == rows - 1);
    for (std::size_t c = 0; c < columns; ++c) {
      double lowest = std::numeric_limits<double>::infinity();
      double highest = -lowest;
      for (std::size_t i = 0; i < rows; ++i) {
        lowest = std::min(lowest, table.at(i, c));
        highest = std::max(highest, table.at(i, c));
      }
      double thinned_lowest = highest;
      double thinned_highest = lowest;
      for (std::size_t i = 0; i < thinned.size(); ++i) {
        // What stays is what was there.
        REQUIRE(thinned.at(i, c) == table.at(numbers[i], c));
        thinned_lowest = std::min(thinned_lowest, thinned.at(i, c));
        thinned_highest = std::max(thinned_highest, thinned.at(i, c));
      }
      CHECK(thinned_lowest == lowest);
      CHECK(thinned_highest == highest);
    }
  }
}

TEST_CASE("as many rows as the limit stay untouched, one more do not") {
  std::mt19937 random(7);
  const Table fits = random_table(random, 300, 4);
  CHECK(thin(fits, 300).numbers == fits.numbers);
  const Table too_long = random_table(random, 301, 4);
  CHECK(thin(too_long, 300).size() < 301);
  CHECK(thin(Table{3, {}}, 300).size() == 0);
}

TEST_CASE("the band of a fast oscillation stays full wherever one looks") {
  constexpr std::size_t kRows = 100000;
  Table table{2, {}};
  for (std::size_t i = 0; i < kRows; ++i) {
    table.numbers.push_back(static_cast<double>(i));
    table.numbers.push_back(i % 2 == 0 ? 1.0 : -1.0);
  }
  const Table thinned = thin(table, 400);
  // Of each piece at least three rows stay, so that there are at least 400/4 - 3 of them; any
  // stretch of two pieces has both ends of the band.
  constexpr std::size_t kStretch = 2 * kRows / 97;
  for (std::size_t begin = 0; begin + kStretch <= kRows; begin += kStretch) {
    bool up = false;
    bool down = false;
    for (std::size_t i = 0; i < thinned.size(); ++i) {
      const auto number = static_cast<std::size_t>(thinned.at(i, 0));
      if (number < begin || number >= begin + kStretch) continue;
      (thinned.at(i, 1) > 0.0 ? up : down) = true;
    }
    CAPTURE(begin);
    CHECK(up);
    CHECK(down);
  }
}

TEST_CASE("what is no number is never an extreme, what is infinite is") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Table table{2, {}};
  for (std::size_t i = 0; i < 5000; ++i) {
    table.numbers.push_back(static_cast<double>(i));
    const double usual = i % 3 == 0 ? nan : 1.0;
    table.numbers.push_back(i == 1234 ? 5.0 : i == 3210 ? infinity : usual);
  }
  table.numbers[1] = nan;
  const std::vector<std::size_t> numbers = numbers_of(thin(table, 100));
  CHECK(std::binary_search(numbers.begin(), numbers.end(), std::size_t{3210}));
}

TEST_CASE("a limit that is too small for the extremes is raised") {
  std::mt19937 random(11);
  const Table table = random_table(random, 5000, 10);
  const std::size_t size = thin(table, 1).size();
  CHECK(size <= 2 + 2 * 10);
  CHECK(size >= 12);
}

}  // namespace
}  // namespace slipbench::driver::results
