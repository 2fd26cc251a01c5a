// SPDX-License-Identifier: Apache-2.0
#include "reference/belt_segment.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

namespace {

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-14).margin(1e-15); }

}  // namespace

TEST_CASE("a belt segment's strain counts from the material that is in it") {
  const auto rows =
      evaluate(belt_segment::kForm, {{0.25}, {400.0}},
               {{10.0, 3.0, -1.0}, {10.0, 5.0, 1.0}, {10.0, 5.0, -1.0}, {12.0, 3.0, 3.0}});
  CHECK(rows[0][0] == exact(0.25));
  CHECK(rows[0][1] == exact(8.0));
  CHECK(rows[0][3] == exact(100.0));
  // As much in as out.
  CHECK(rows[1][0] == exact(0.25));
  CHECK(rows[2][1] == exact(10.0));
  CHECK(rows[2][3] == exact(0.0));
  CHECK(rows[3][1] == exact(4.0));
  CHECK(rows[3][2] == exact(3.0));
  CHECK(rows[3][3] == exact(800.0));
}

TEST_CASE("a belt segment's small strain keeps its digits") {
  const auto rows = evaluate(belt_segment::kForm, {{0.0}, {1.0}},
                             {{1.0, 0.0, 0.0}, {1.0 + 0x1p-40, 0.0, 0.0}, {1.0, 0.0, 0x1p-40}});
  CHECK(rows[0][0] == 0.0);
  CHECK(rows[1][0] == 0x1p-40);
  CHECK(rows[2][0] == Approx(0x1p-40).epsilon(1e-11));
}
