// SPDX-License-Identifier: Apache-2.0
#include "driver/report/packed_numbers.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/driver/report/case_for_test.hpp"

namespace slipbench::driver::report {
namespace {

double largest_error(const std::vector<double>& numbers, const std::vector<double>& told) {
  REQUIRE(numbers.size() == told.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    largest = std::max(largest, std::abs(numbers[i] - told[i]));
  }
  return largest;
}

TEST_CASE("a packed series is true to a millionth of its range, in about two characters a number") {
  std::vector<double> wave;
  for (int i = 0; i < 10001; ++i) wave.push_back(50.0 * std::sin(0.0628 * i));
  const std::string text = packed_series(wave);
  CHECK(largest_error(wave, unpacked(text)) <= 1e-4);
  CHECK(text.size() < 28000);
  CHECK(packed_series(std::vector<double>(10001, 12.5)).size() < 1000);
  CHECK(unpacked(packed_series(std::vector<double>(130, 12.5))) == std::vector<double>(130, 12.5));
}

TEST_CASE("decimal texts come back as they are, of any size and sign") {
  const std::vector<double> times{0.0, 0.1, 0.2, 0.30000000000000004, -0.4, 1000.0005};
  CHECK(unpacked(packed_numbers(times, 4)) ==
        std::vector<double>{0.0, 0.1, 0.2, 0.3, -0.4, 1000.0005});
  const std::vector<double> large{3e300, -7e300, 0.0, 5e300};
  CHECK(largest_error(large, unpacked(packed_series(large))) <= 1e-5 * 1e301);
  const std::vector<double> small{3e-300, -7e-300, 0.0, 5e-300};
  CHECK(largest_error(small, unpacked(packed_series(small))) <= 1e-5 * 1e-299);
  CHECK(unpacked(packed_series({})).empty());
  CHECK(to_decimals(0.30000000000000004, 4) == 0.3);
}

TEST_CASE("a small motion that follows a long way keeps its shape, also within a block") {
  for (const int far : {3, 20, 64, 300}) {
    CAPTURE(far);
    std::vector<double> way;
    for (int i = 0; i < far; ++i) way.push_back(1e3 * i / far);
    for (int i = 0; i < 300; ++i) way.push_back(1000.0 + 0.1 * std::sin(0.02 * i));
    const std::vector<double> told = unpacked(packed_series(way));
    REQUIRE(told.size() == way.size());
    // The block in which the long way ends may be coarser.
    for (std::size_t i = static_cast<std::size_t>(far) + 64; i < way.size(); ++i) {
      REQUIRE(std::abs(told[i] - way[i]) <= 1e-5);
    }
  }
}

TEST_CASE("what is no number is none on the page, and spoils none beside it") {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> numbers(200, 1.0);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 0.25 * static_cast<double>(i);
  for (const std::size_t i : {0U, 63U, 64U, 100U, 199U}) numbers[i] = kNone;
  numbers[120] = std::numeric_limits<double>::infinity();
  const std::vector<double> told = unpacked(packed_series(numbers));
  REQUIRE(told.size() == 200);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CAPTURE(i);
    if (std::isfinite(numbers[i])) {
      REQUIRE(told[i] == Approx(numbers[i]).margin(1e-5));
    } else {
      REQUIRE(std::isnan(told[i]));
    }
  }
}

}  // namespace
}  // namespace slipbench::driver::report
