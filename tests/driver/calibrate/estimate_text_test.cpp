// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/estimate_text.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

namespace {

using namespace slipbench::driver;

std::string digits(double value, double error) {
  const auto text = slipbench::driver::calibrate::value_and_error(value, error);
  return text.value + " +- " + text.error;
}

}  // namespace

TEST_CASE("a value has the digits that its standard error leaves") {
  CHECK(digits(0.23104, 0.002) == "0.2310 +- 0.0020");
  CHECK(digits(4212.8, 50.2) == "4213 +- 50");
  CHECK(digits(4212.8, 0.0502) == "4212.800 +- 0.050");
  CHECK(digits(421284.0, 1234.0) == "421300 +- 1200");
  CHECK(digits(-0.5, 0.25) == "-0.50 +- 0.25");
  CHECK(digits(0.0, 0.25) == "0.00 +- 0.25");
}

TEST_CASE("a value far below its error is not told as 0") {
  CHECK(digits(100.0, 5e4) == "100 +- 50000");
  CHECK(digits(5.0, 123.0) == "5.0 +- 120");
  CHECK(digits(1e-7, 0.3) == "1.0e-07 +- 0.30");
  CHECK(digits(120.0, 300.0) == "120 +- 300");
}

TEST_CASE("an error that is rounded up to the next power of ten has two digits") {
  CHECK(digits(1.0, 0.00996) == "1.000 +- 0.010");
  CHECK(digits(1234.0, 99.6) == "1230 +- 100");
}

TEST_CASE("large and small values are written with an exponent") {
  CHECK(digits(1.23456e9, 1.23e6) == "1.2346e+09 +- 1.2e+06");
  CHECK(digits(1.23456e-7, 1.23e-9) == "1.235e-07 +- 1.2e-09");
}

TEST_CASE("an estimate without noise is not written with more digits than help") {
  CHECK(digits(0.3, 3e-15) == "0.300000000 +- 3.0e-15");
}

TEST_CASE("a value without a standard error has six digits") {
  CHECK(digits(0.123456789, std::numeric_limits<double>::quiet_NaN()) == "0.123457 +- -");
  CHECK(digits(3.0, 0.0) == "3 +- -");
}

TEST_CASE("numbers for reading have four digits") {
  using slipbench::driver::calibrate::short_number;
  CHECK(short_number(0.0123456) == "0.01235");
  CHECK(short_number(6200.0) == "6200");
  CHECK(short_number(12684.0) == "12680");
  CHECK(short_number(-123456.0) == "-123500");
  CHECK(short_number(1.26841e7) == "1.268e+07");
}

TEST_CASE("a reason does not repeat the verdict") {
  slipbench::driver::fit::LeastSquaresFit fit;
  fit.stop_sentence = "not converged: no step helps";
  CHECK(slipbench::driver::calibrate::stop_reason_text(fit) == "no step helps");
  fit.converged = true;
  fit.stop_sentence = "converged: at a kink";
  CHECK(slipbench::driver::calibrate::stop_reason_text(fit) == "at a kink");
}

TEST_CASE("an interval has the digits of its standard error") {
  using slipbench::driver::calibrate::interval_text;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(interval_text(0.22704, 0.23501, 0.002) == "0.2270 .. 0.2350");
  CHECK(interval_text(-kInfinity, 0.23501, 0.002) == "-inf .. 0.2350");
  CHECK(interval_text(std::numeric_limits<double>::quiet_NaN(), 1.0, 0.1) == "-");
}

TEST_CASE("starts without a value found no minimum") {
  using namespace slipbench::driver;
  fit::LeastSquaresFit fit;
  fit.cost = 2.0;
  fit.start_cost = 100.0;
  CHECK(calibrate::starts_text(fit).empty());
  for (const double cost : {2.0, 2.0000001, 6.0, 0.0}) {
    fit::SearchTrace search;
    search.cost = cost;
    search.stop = cost > 0.0 ? fit::StopReason::kStep : fit::StopReason::kModelFailure;
    fit.searches.push_back(search);
  }
  CHECK(calibrate::starts_text(fit) ==
        "2 of 4 starts found this minimum, the next best has 3 times its cost, 1 had no value");
  CHECK_FALSE(calibrate::has_value(fit.searches[3]));
  CHECK_FALSE(calibrate::found_the_minimum(fit, fit.searches[3]));
}
