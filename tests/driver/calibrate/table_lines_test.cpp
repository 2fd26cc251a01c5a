// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/table_lines.hpp"

#include <catch2/catch.hpp>
#include <vector>

namespace slipbench::driver::calibrate {
namespace {

law::Table table_of(const std::vector<std::vector<double>>& rows, int independents) {
  law::Table table;
  law::TableError error;
  REQUIRE(law::Table::build(rows, 1, independents, law::Extrapolation::kConstant, &table, &error));
  return table;
}

}  // namespace

TEST_CASE("lines of a grid run along each independent") {
  const law::Table table =
      table_of({{1, 0, 20}, {2, 5, 20}, {3, 9, 20}, {4, 0, 60}, {5, 5, 60}, {6, 9, 60}}, 2);
  const auto along = table_lines(table, 0);
  REQUIRE(along.size() == 2);
  CHECK(along[1].rows == std::vector<std::size_t>{3, 4, 5});
  CHECK(along[1].abscissa == std::vector<double>{0, 5, 9});
  const auto across = table_lines(table, 1);
  REQUIRE(across.size() == 3);
  CHECK(across[2].rows == std::vector<std::size_t>{2, 5});
  CHECK(across[2].abscissa == std::vector<double>{20, 60});
}

TEST_CASE("ragged blocks have lines across only where they have the same points") {
  const law::Table table = table_of({{1, 0, 20}, {2, 5, 20}, {3, 0, 60}, {4, 7, 60}}, 2);
  CHECK(table_lines(table, 0).size() == 2);
  const auto across = table_lines(table, 1);
  REQUIRE(across.size() == 1);
  CHECK(across[0].rows == std::vector<std::size_t>{0, 2});
}

TEST_CASE("blocks of unknowns keep the shape along the first independent") {
  const law::Table table = table_of({{1, 0, 20}, {2, 5, 20}, {3, 0, 60}, {4, 7, 60}}, 2);
  const auto blocks =
      shaped_blocks(table, {.monotone = fit::Shape::Monotone::kDecreasing, .curvature = {}}, 10);
  REQUIRE(blocks.size() == 2);
  CHECK(blocks[1].first == 12);
  CHECK(blocks[1].count == 2);
  CHECK(blocks[1].abscissa == std::vector<double>{0, 7});
  CHECK(blocks[1].shape.monotone == fit::Shape::Monotone::kDecreasing);
}

TEST_CASE("smoothness is the second difference, without a dimension") {
  const auto d2 = [](const law::Table& table, const std::vector<double>& x) {
    std::vector<double> values;
    for (const SmoothnessRow& row : smoothness_rows(table, 0, 0)) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 3; ++j) sum += row.weight[j] * x.at(row.unknown[j]);
      values.push_back(sum);
    }
    return values;
  };
  // Even intervals: (f0 - 2 f1 + f2)/2, over the largest start ordinate 4.
  const law::Table even = table_of({{4, 0}, {2, 1}, {1, 2}}, 1);
  REQUIRE(d2(even, {4, 2, 1}).size() == 1);
  CHECK(d2(even, {4, 2, 1})[0] == Approx(0.5 * (4 - 4 + 1) / 4));
  // A straight line has none, whatever the intervals.
  const law::Table uneven = table_of({{4, 0}, {2, 1}, {1, 5}, {1, 6}}, 1);
  for (const double value : d2(uneven, {3, 2.5, 0.5, 0})) CHECK(value == Approx(0).margin(1e-15));
  // Other units of both axes change nothing.
  const law::Table scaled = table_of({{4000, 0}, {2000, 60}, {1000, 300}, {1000, 360}}, 1);
  const auto one = d2(uneven, {4, 2, 1, 1});
  const auto other = d2(scaled, {4000, 2000, 1000, 1000});
  REQUIRE(one.size() == 2);
  CHECK(other[0] == Approx(one[0]).epsilon(1e-14));
  CHECK(other[1] == Approx(one[1]).epsilon(1e-14));
}

}  // namespace slipbench::driver::calibrate
