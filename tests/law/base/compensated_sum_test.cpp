// SPDX-License-Identifier: Apache-2.0
#include "law/base/compensated_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/dice.hpp"

namespace {

using namespace slipbench;
using law::CompensatedSum;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

TEST_CASE("a million equal parts are summed within a rounding") {
  CompensatedSum sum;
  double plain = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    sum += 0.1;
    plain += 0.1;
  }
  CHECK(std::abs(plain - 1e5) > 1e-7);
  CHECK(std::abs(sum - 1e5) <= 1e5 * kEpsilon);
}

TEST_CASE("parts of any size and sign are summed within two roundings of their sizes") {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    test::Dice dice(seed);
    CompensatedSum sum;
    long double exact = 0.0L;
    long double sizes = 0.0L;
    for (int i = 0; i < 1000; ++i) {
      const double part = dice.between(-1.0, 1.0) * std::pow(10.0, dice.between(-8.0, 8.0));
      sum += part;
      exact += part;
      sizes += std::abs(part);
    }
    INFO("seed " << seed);
    CHECK(std::abs(static_cast<double>(sum - exact)) <=
          2.0 * kEpsilon * static_cast<double>(sizes));
  }
}

TEST_CASE("parts that are not negative never bring a sum down") {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    test::Dice dice(seed);
    CompensatedSum sum;
    bool falls = false;
    for (int i = 0; i < 50; ++i) {
      const double before = sum;
      sum += dice.chance(0.5) ? 0.0 : std::pow(10.0, dice.between(-20.0, 3.0));
      falls = falls || sum < before;
    }
    INFO("seed " << seed);
    CHECK_FALSE(falls);
  }
}

TEST_CASE("a sum goes on where it was, with what rounding left out, and shows what is no number") {
  CompensatedSum sum = 1.0;
  for (int i = 0; i < 1000; ++i) {
    sum = {sum, sum.left_out()};
    sum += 1e-17;
  }
  CHECK(sum == 1.0 + 1e-14);
  sum += std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(sum));
}

}  // namespace
