// SPDX-License-Identifier: Apache-2.0
#include "driver/report/series_digits.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace slipbench::driver::report {
namespace {

TEST_CASE("digits tell a number to within what is asked for") {
  CHECK(digits_within(1000.0, 1e-4) == 7);
  CHECK(digits_within(999.0, 1e-4) == 7);
  CHECK(digits_within(1001.0, 1e-4) == 8);
  CHECK(digits_within(-1001.0, 1e-4) == 8);
  CHECK(digits_within(1e-9, 1.0) == kFewestDigits);
  CHECK(digits_within(1.0, 1e-300) == kMostDigits);
  CHECK(digits_within(1.0, 0.0) == kFewestDigits);
  CHECK(digits_within(0.0, 1.0) == kFewestDigits);
  CHECK(digits_within(std::numeric_limits<double>::infinity(), 1.0) == kFewestDigits);
}

TEST_CASE("a series has six digits of its range, wherever it lies") {
  std::vector<double> series;
  for (int i = 0; i <= 10; ++i) series.push_back(1e4 + 0.01 * i);
  const SeriesDigits digits(series);
  // 10000 in steps of 1e-8, a millionth of the range of 0.1: ... and a thousandth of a step is
  // more.
  CHECK(digits[0] >= 11);
  CHECK(digits[0] <= 13);
  std::vector<double> usual;
  for (int i = 0; i <= 10; ++i) usual.push_back(i);
  const SeriesDigits few(usual);
  for (std::size_t i = 0; i < usual.size(); ++i) CHECK(few[i] <= 7);
}

TEST_CASE("a small motion behind a long way has digits of its own, the way has few") {
  std::vector<double> series{0.0, 500.0, 1000.0};
  for (int i = 1; i <= 100; ++i) series.push_back(1000.0 + 0.1 * std::sin(0.05 * i));
  const SeriesDigits digits(series);
  CHECK(digits[1] == 6);
  for (std::size_t i = 3; i < 20; ++i) CHECK(digits[i] >= 9);  // steps of 0.005, to a thousandth
}

TEST_CASE("rounding is no range and no step") {
  const double noise = 1e-14;
  const std::array constant{3.0, 3.0 + noise, 3.0 - noise};
  CHECK(SeriesDigits(constant)[1] == kFewestDigits);
  const std::array limit{0.0, 100.0, 100.0 + 1e-12, 100.0, 0.0};
  CHECK(SeriesDigits(limit)[2] == kFewestDigits);
  const std::array unknown{std::numeric_limits<double>::quiet_NaN(), 1.0};
  CHECK(SeriesDigits(unknown)[0] == kFewestDigits);
}

TEST_CASE("times are told to a thousandth of the shortest step") {
  CHECK(time_resolution(std::array{0.0, 100.0, 100.5, 100.5, 102.0}) ==
        Approx(5e-4).epsilon(1e-12));
  CHECK(time_resolution(std::array{1.0}) == 0.0);
  CHECK(time_resolution(std::array{1.0, 1.0 + 1e-15}) == 0.0);
}

}  // namespace
}  // namespace slipbench::driver::report
