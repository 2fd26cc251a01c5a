// SPDX-License-Identifier: Apache-2.0
// The place where a function of one number turns from true to false.
#include "law/base/bisection.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace slipbench::law;

TEST_CASE("a turn stands between two neighbouring numbers") {
  const Turn third = turn(0.0, 1.0, [](double x) { return x < 1.0 / 3.0; });
  CHECK(third.high == 1.0 / 3.0);
  CHECK(third.low == std::nextafter(1.0 / 3.0, 0.0));
}

TEST_CASE("what turns nowhere stands at an end of its bracket") {
  const Turn never = turn(1.0, 2.0, [](double) { return true; });
  CHECK(never.low == std::nextafter(2.0, 1.0));
  CHECK(never.high == 2.0);
  const Turn always = turn(1.0, 2.0, [](double) { return false; });
  CHECK(always.low == 1.0);
  CHECK(always.high == std::nextafter(1.0, 2.0));
}

}  // namespace
