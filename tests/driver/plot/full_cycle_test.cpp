// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/full_cycle.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/driver/history/temporary_folder.hpp"

namespace slipbench::driver {
namespace {

using Rows = std::array<std::int64_t, 2>;

std::optional<Rows> cycle_of(const std::vector<double>& motion, double range) {
  FullCycleFinder finder(range);
  for (const double position : motion) finder.add(position);
  return finder.last();
}

TEST_CASE("the last full cycle goes from a turning point to the next but one") {
  CHECK(cycle_of({0, 1, 0, -1, 0, 1, 0}, 2.0) == Rows{1, 5});
  // The last row may end it; rows that dwell at a turning point belong to the branch before.
  CHECK(cycle_of({0, 1, 1, -1, 1}, 2.0) == Rows{2, 4});
  CHECK_FALSE(cycle_of({0, 1, 0, -1}, 2.0));
  CHECK_FALSE(cycle_of({0, 0, 0}, 0.0));
  // It does not come back to the same place.
  CHECK_FALSE(cycle_of({0, 1, -1, 0.9}, 2.0));
}

TEST_CASE("what is left of a vibration is no cycle") {
  CHECK(cycle_of({0, 1, -1, 1, 0, 0.01, 0, 0.01, 0}, 2.0) == Rows{1, 3});
}

TEST_CASE("a thinned result keeps all rows of its last full cycle") {
  const TemporaryFolder folder;
  // 100 cycles of 200 rows, and a quarter of one.
  std::string text = "# slipbench 0\n# friction: friction1 = CSF1\nt,CP1,CSF1\n";
  for (int i = 0; i <= 20050; ++i) {
    const double u = std::sin(2.0 * std::numbers::pi * i / 200.0);
    text += std::to_string(i) + "," + std::to_string(u) + "," + std::to_string(10.0 * u) + "\n";
  }
  const auto file = folder.write("a.csv", text);
  auto data = read_plot_data(file, "a.csv");
  REQUIRE(data);
  CHECK(data->thinned());
  REQUIRE(add_full_cycles(*data, file, "a.csv"));
  const std::vector<double>& cycle = data->definitions[0].cycle;
  REQUIRE(cycle.size() == 201 * data->columns.size());
  for (std::size_t i = 0; i <= 200; ++i) {
    CHECK(cycle[i * data->columns.size()] == 19850.0 + static_cast<double>(i));
  }
}

}  // namespace
}  // namespace slipbench::driver
