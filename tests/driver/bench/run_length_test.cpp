// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/run_length.hpp"

#include <catch2/catch.hpp>

#include "tests/driver/bench/example_cases.hpp"

namespace slipbench::driver::bench {
namespace {

TEST_CASE("the number of increments is known before the run, and the part of it that is done") {
  // Two passes of 10, then 100: 120, and 2 s and 1 s.
  const cases::Case problem = slider_case({step("cycle", 10, 0, history::LinearTo{0.1}, 1.0, 2),
                                           step("out", 100, 0, history::LinearTo{1.0})});
  const RunLength length(problem);
  CHECK(length.increments() == 120.0);
  CHECK(length.increments_between({}, 0.0, 3.0) == 120.0);
  CHECK(length.increments_between("out", 0.0, 3.0) == 100.0);
  CHECK(length.increments_between({}, 1.0, 2.5) == Approx(60.0));
  CHECK(length.increments_between({}, 4.0, 5.0) == 0.0);
  const std::vector<Row> rows = rows_of(problem);
  REQUIRE(rows.size() == 121);
  for (const Row& row : rows) {
    CHECK(length.done(row) == Approx(static_cast<double>(row.index) / 120.0).margin(1e-12));
  }
}

}  // namespace
}  // namespace slipbench::driver::bench
