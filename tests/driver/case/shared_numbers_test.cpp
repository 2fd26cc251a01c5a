// SPDX-License-Identifier: Apache-2.0
#include "driver/case/shared_numbers.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::cases {
namespace {

TEST_CASE("copies of a column are one until one of them is changed") {
  const SharedNumbers column{1.0, 2.0, 3.0};
  SharedNumbers other = column;
  CHECK(other.data() == column.data());
  other.push_back(4.0);
  CHECK(other == SharedNumbers{1.0, 2.0, 3.0, 4.0});
  CHECK(column == SharedNumbers{1.0, 2.0, 3.0});
  const double* const own = other.data();
  other.change()[0] = 0.0;
  CHECK(other.data() == own);
}

TEST_CASE("a column of nothing can be asked and filled") {
  SharedNumbers column;
  CHECK(column.empty());
  CHECK(column == SharedNumbers{});
  const SharedNumbers before = std::move(column);
  column = before;
  column.push_back(1.0);
  CHECK(before.empty());
  CHECK(column.back() == 1.0);
}

}  // namespace
}  // namespace slipbench::driver::cases
