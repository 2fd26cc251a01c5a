// SPDX-License-Identifier: Apache-2.0
#include "driver/report/drawn_coverage.hpp"

#include <catch2/catch.hpp>
#include <numeric>

namespace slipbench::driver::report {
namespace {

/// A table with so many intervals along each axis; cell n was visited n times.
results::TableCoverage table_of(const std::vector<std::size_t>& intervals) {
  results::TableCoverage table;
  table.what = "coefficient";
  std::size_t cells = 1;
  for (const std::size_t count : intervals) {
    results::TableCoverage::Axis axis;
    axis.name = "axis" + std::to_string(table.axes.size());
    axis.knots.resize(count + 1);
    std::iota(axis.knots.begin(), axis.knots.end(), 0.0);
    axis.stride = cells;
    cells *= count;
    table.axes.push_back(axis);
  }
  table.visits.resize(cells);
  std::iota(table.visits.begin(), table.visits.end(), 0);
  return table;
}

std::int64_t sum(const std::vector<std::int64_t>& visits) {
  return std::accumulate(visits.begin(), visits.end(), std::int64_t{0});
}

TEST_CASE("a small table is drawn as it is, the first independent fastest") {
  const results::TableCoverage table = table_of({3, 2});
  const ReportTable drawn = drawn_coverage(table, "pad");
  CHECK(drawn.name == "friction 'pad': coefficient");
  CHECK(drawn.visits == table.visits);
  CHECK_FALSE(drawn.coarser);
  CHECK(drawn.axes[0].knots == table.axes[0].knots);
  CHECK(drawn.axes[0].visits == std::vector<std::int64_t>{0 + 3, 1 + 4, 2 + 5});
  CHECK(drawn.axes[1].visits == std::vector<std::int64_t>{0 + 1 + 2, 3 + 4 + 5});
}

TEST_CASE("a large table becomes coarser but loses no visit and no end") {
  for (const auto& intervals : {std::vector<std::size_t>{1000}, std::vector<std::size_t>{100, 7},
                                std::vector<std::size_t>{49, 48}}) {
    const results::TableCoverage table = table_of(intervals);
    const ReportTable drawn = drawn_coverage(table, "pad");
    CHECK(drawn.coarser);
    CHECK(sum(drawn.visits) == sum(table.visits));
    std::size_t cells = 1;
    for (std::size_t k = 0; k < drawn.axes.size(); ++k) {
      const ReportTable::Axis& axis = drawn.axes[k];
      CHECK(axis.visits.size() <= 240);
      CHECK(axis.knots.size() == axis.visits.size() + 1);
      CHECK(axis.knots.front() == table.axes[k].knots.front());
      CHECK(axis.knots.back() == table.axes[k].knots.back());
      CHECK(sum(axis.visits) == sum(table.visits));
      cells *= axis.visits.size();
    }
    CHECK(drawn.visits.size() == cells);
  }
}

TEST_CASE("of more than two independents there are the sums along each") {
  const results::TableCoverage table = table_of({2, 2, 2});
  const ReportTable drawn = drawn_coverage(table, "pad");
  CHECK(drawn.visits.empty());
  REQUIRE(drawn.axes.size() == 3);
  CHECK(drawn.axes[0].visits == std::vector<std::int64_t>{0 + 2 + 4 + 6, 1 + 3 + 5 + 7});
  CHECK(drawn.axes[2].visits == std::vector<std::int64_t>{0 + 1 + 2 + 3, 4 + 5 + 6 + 7});
}

TEST_CASE("a table that was too large to count, and one of a single row, can be drawn") {
  results::TableCoverage uncounted = table_of({1000, 2});
  uncounted.visits.clear();
  const ReportTable drawn = drawn_coverage(uncounted, "pad");
  CHECK(drawn.visits.empty());
  CHECK(drawn.axes[0].visits.empty());
  results::TableCoverage single;
  single.axes.push_back({"slip_rate", {1.0}});
  single.visits = {5};
  const ReportTable one = drawn_coverage(single, "pad");
  CHECK(one.visits == single.visits);
  CHECK(one.axes[0].knots == std::vector<double>{1.0});
}

}  // namespace
}  // namespace slipbench::driver::report
