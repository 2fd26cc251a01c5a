// SPDX-License-Identifier: Apache-2.0
#include "driver/base/csv/printed_digits.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace slipbench::driver::base {
namespace {

std::optional<double> resolution(std::initializer_list<std::string_view> numbers) {
  PrintedDigits digits;
  for (const std::string_view number : numbers) digits.add(number);
  return digits.resolution();
}

TEST_CASE("a fixed number of decimals is uncertain by half a unit of the last one") {
  CHECK(resolution({"0.10", "-12.34", "3.00"}).value() == Approx(0.005));
  CHECK(resolution({"120", "75", "3"}).value() == Approx(0.5));
  CHECK(resolution({"0.0010", "0.0234"}).value() == Approx(0.00005));
}

TEST_CASE("zeros that a program drops at the end are digits all the same") {
  // Seven digits: the largest number is printed as 20 and means 20.00000.
  CHECK(resolution({"0", "3.925982", "20"}).value() == Approx(0.5e-5));
}

TEST_CASE("exponents count") {
  CHECK(resolution({"1.50e+03", "-2.5e2"}).value() == Approx(5.0));
  CHECK(resolution({"1.234E-05"}).value() == Approx(0.5e-8));
  CHECK(resolution({"+1.2e1"}).value() == Approx(0.5));
}

TEST_CASE("all the digits of a double, and zeros alone, leave no rounding to tell") {
  CHECK_FALSE(resolution({"0.30000000000000004", "20"}));
  CHECK_FALSE(resolution({"0", "0.000", "-0"}));
  CHECK_FALSE(resolution({}));
}

TEST_CASE("the unit does not matter: the resolution scales with the numbers") {
  CHECK(resolution({"12.34"}).value() * 1e3 == Approx(resolution({"12.34e3"}).value()));
}

}  // namespace
}  // namespace slipbench::driver::base
