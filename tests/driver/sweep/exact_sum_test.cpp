// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/exact_sum.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace slipbench::driver::sweep {
namespace {

double sum_of(const std::vector<double>& values) {
  ExactSum sum;
  for (const double value : values) sum.add(value);
  return sum.value();
}

TEST_CASE("An exact sum is the nearest double") {
  CHECK(sum_of({}) == 0.0);
  CHECK(sum_of({1e308, 1.0, -1e308}) == 1.0);
  CHECK(sum_of({1e308, 1e308, -1e308, -1e308, 5e-324}) == 5e-324);
  CHECK(sum_of({-1e-310, 3e-310, -2e-310}) == 0.0);
  CHECK(sum_of(std::vector<double>(10, 0.1)) == 1.0);
  // Half of the last bit goes to even, and up if anything follows, be it far below.
  CHECK(sum_of({1.0, 0x1p-53}) == 1.0);
  CHECK(sum_of({1.0, 0x1p-53, 0x1p-300}) == 1.0 + 0x1p-52);
  CHECK(sum_of({-1.0, -0x1p-53, -5e-324}) == -1.0 - 0x1p-52);
  CHECK(sum_of({1.0, 0x1p-53, -0x1p-300}) == 1.0);
  CHECK(std::isinf(sum_of({1.7e308, 1.7e308})));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(sum_of({1.0, -infinity}) == -infinity);
  CHECK(std::isnan(sum_of({infinity, -infinity})));
}

TEST_CASE("An exact sum of whole numbers is that of integers") {
  std::mt19937_64 dice(5);
  for (int turn = 0; turn < 200; ++turn) {
    const int power = std::uniform_int_distribution<int>(-1000, 900)(dice);
    std::int64_t whole = 0;
    ExactSum sum;
    for (int i = 0; i < 300; ++i) {
      const auto one = static_cast<std::int32_t>(dice());
      whole += one;
      sum.add(std::ldexp(one, power));
    }
    CHECK(sum.value() == std::ldexp(static_cast<double>(whole), power));
  }
}

TEST_CASE("An exact sum does not depend on order and division") {
  std::mt19937_64 dice(7);
  std::normal_distribution<double> normal(0.0, 100.0);
  std::vector<double> values(1000);
  for (double& value : values) value = std::copysign(std::exp(normal(dice)), normal(dice));
  const double all = sum_of(values);
  for (int turn = 0; turn < 20; ++turn) {
    std::shuffle(values.begin(), values.end(), dice);
    std::vector<ExactSum> parts(3);
    for (const double value : values) parts[dice() % 3].add(value);
    parts[0].add(parts[2]);
    parts[1].add(parts[0]);
    CHECK(parts[1].value() == all);
    parts[1].subtract(parts[0]);
    parts[0].add(parts[1]);
    CHECK(parts[0].value() == all);
  }
}

TEST_CASE("The spread about a mean that is far away is exact") {
  // Of 1e9 + 1 .. 1e9 + n: (n^3 - n)/12; the squares alone would lose all of it.
  constexpr int kCount = 7;
  ExactSum x;
  ExactSum y;
  ExactSum squares;
  ExactSum products;
  for (int i = 1; i <= kCount; ++i) {
    const double far = 1e9 + i;
    x.add(far);
    y.add(-3.0 * i);
    squares.add_product(far, far);
    products.add_product(far, -3.0 * i);
  }
  CHECK(sum_about_means(kCount, x, x, squares) == 28.0);
  CHECK(sum_about_means(kCount, x, y, products) == -84.0);
  ExactSum thrice = products;
  thrice.add_times(products, 2.0);
  CHECK(thrice.value() == 3.0 * products.value());
}

}  // namespace
}  // namespace slipbench::driver::sweep
