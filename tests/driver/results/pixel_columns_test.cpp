// SPDX-License-Identifier: Apache-2.0
#include "driver/results/pixel_columns.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace slipbench::driver::results {
namespace {

using Row = std::array<double, 3>;

TEST_CASE("few rows in a column of pixels stay as they are") {
  PixelColumns columns(3, 0.0, 10.0, 10);
  std::vector<double> all;
  for (int i = 0; i <= 30; ++i) {
    const Row row{i / 3.0, std::sin(i), -1.0 * i};
    all.insert(all.end(), row.begin(), row.end());
    columns.add(row);
  }
  CHECK(columns.finish() == all);
}

TEST_CASE("of many rows in a column of pixels first, last and extremes stay, where they are") {
  // The first second has ten rows, the second one a hundred thousand, with a peak of one row.
  PixelColumns columns(3, 0.0, 2.0, 100);
  for (int i = 0; i <= 10; ++i) columns.add(Row{0.1 * i, 0.1 * i, 0.0});
  constexpr int kMany = 100000;
  for (int i = 1; i <= kMany; ++i) {
    columns.add(Row{1.0 + double(i) / kMany,
                    i == 77777   ? 9.0
                    : i == 77770 ? -9.0
                                 : 0.0,
                    i == 5 ? std::nan("") : 1.0});
  }
  const std::vector<double> rows = columns.finish();
  CHECK(rows.size() <= 3 * (10 + 4 * 52));
  for (int i = 0; i < 10; ++i) CHECK(rows[3 * static_cast<std::size_t>(i)] == 0.1 * i);
  std::vector<double> peaks;
  for (std::size_t at = 0; at < rows.size(); at += 3) {
    if (at > 0) CHECK(rows[at] >= rows[at - 3]);
    if (std::abs(rows[at + 1]) == 9.0) {
      peaks.push_back(rows[at + 1]);
      CHECK(rows[at] == Approx(1.77777).margin(0.02));
    }
    // A number that is none has not become an extreme.
    if (rows[at] > 1.02) CHECK(rows[at + 2] == 1.0);
  }
  CHECK(peaks == std::vector<double>{-9.0, 9.0});
}

}  // namespace
}  // namespace slipbench::driver::results
