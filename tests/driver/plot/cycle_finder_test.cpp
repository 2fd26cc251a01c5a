// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/cycle_finder.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

namespace slipbench::driver::plot {
namespace {

using Rows = std::array<std::int64_t, 2>;
using Numbers = std::vector<std::int64_t>;

MotionCycles cycles_of(const std::vector<double>& motion, double range) {
  CycleFinder finder(range);
  for (const double position : motion) finder.add(position);
  return finder.cycles();
}

TEST_CASE("the last full cycle goes from a turning point to the next but one") {
  CHECK(cycles_of({0, 1, 0, -1, 0, 1, 0}, 2.0).full == Rows{1, 5});
  // The last row may end it; rows that dwell at a turning point belong to the branch before.
  CHECK(cycles_of({0, 1, 1, -1, 1}, 2.0).full == Rows{2, 4});
  CHECK_FALSE(cycles_of({0, 1, 0, -1}, 2.0).full);
  CHECK_FALSE(cycles_of({0, 0, 0}, 0.0).full);
  // It does not come back to the same place.
  CHECK_FALSE(cycles_of({0, 1, -1, 0.9}, 2.0).full);
}

TEST_CASE("what is left of a vibration is no cycle") {
  CHECK(cycles_of({0, 1, -1, 1, 0, 0.01, 0, 0.01, 0}, 2.0).full == Rows{1, 3});
}

TEST_CASE("cycles end with every second turn, the last with the run") {
  // Three periods of a wave that begins in its middle, of one that begins at a turning point, and
  // after a rest.
  CHECK(cycles_of({0, 1, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1, 0}, 2.0).ends == Numbers{3, 7, 12});
  CHECK(cycles_of({1, 0, 1, 0, 1, 0, 1}, 1.0).ends == Numbers{2, 4, 6});
  CHECK(cycles_of({0, 0, 0, 1, 0, 1, 0, 0, 0}, 1.0).ends == Numbers{4, 8});
  CHECK(cycles_of({0, 1, 2}, 2.0).ends == Numbers{2});
  CHECK(cycles_of({}, 1.0).ends.empty());
}

TEST_CASE("of many cycles 1, 2, 5, 10 and so on are drawn, and the last") {
  CHECK(drawn_cycles(1) == Numbers{1});
  CHECK(drawn_cycles(5) == Numbers{1, 2, 3, 4, 5});
  CHECK(drawn_cycles(12) == Numbers{1, 2, 5, 10, 12});
  CHECK(drawn_cycles(100) == Numbers{1, 2, 5, 10, 20, 50, 100});
  CHECK(drawn_cycles(1000000) == Numbers{1, 10, 100, 1000, 10000, 100000, 1000000});
}

}  // namespace
}  // namespace slipbench::driver::plot
