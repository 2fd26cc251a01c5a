// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/path_rows.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace slipbench::driver::plot {
namespace {

using Row = std::array<double, 3>;

TEST_CASE("what is drawn of a path is short, or joins neighbours") {
  // A circle of 100,000 rows with a jump, its rows numbered in the last column.
  PathRows path({{0, 2.0}, {1, 2.0}}, 50000);
  constexpr int kRows = 100000;
  for (int i = 0; i < kRows; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRows;
    path.add(Row{std::cos(angle), std::sin(angle) + (i > 50000 ? 0.5 : 0.0), double(i)});
  }
  CHECK(path.taken() == kRows);
  const std::vector<double> rows = path.finish();
  REQUIRE(rows.size() < 3 * 15000);
  CHECK(rows[2] == 0.0);
  CHECK(rows.back() == kRows - 1.0);
  bool jump = false;
  for (std::size_t at = 3; at < rows.size(); at += 3) {
    const bool neighbours = rows[at + 2] - rows[at - 1] == 1.0;
    const double step =
        std::max(std::abs(rows[at] - rows[at - 3]), std::abs(rows[at + 1] - rows[at - 2]));
    if (step > 2.0 * PathRows::kStep) CHECK(neighbours);
    jump = jump || (rows[at - 1] == 50000.0 && rows[at + 2] == 50001.0);
  }
  CHECK(jump);
}

TEST_CASE("a path of too many rows ends, and says where") {
  PathRows path({{0, 1.0}}, 10);
  for (int i = 0; i < 100; ++i) path.add(Row{i % 2 == 0 ? 0.0 : 1.0, 0.0, double(i)});
  CHECK(path.taken() == 10);
  CHECK(path.finish().size() == 30);
}

}  // namespace
}  // namespace slipbench::driver::plot
