// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/spacing.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace slipbench::driver::check {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

TEST_CASE("a place has as many digits as tell it from its neighbours, at least four") {
  CHECK(place_text(1234.512, 0.002) == "1234.512");
  CHECK(place_text(1234.51234, 0.02) == "1234.51");
  CHECK(place_text(0.84, 0.02) == "0.84");
  CHECK(place_text(1.0 / 3.0, 0.1) == "0.3333");
  CHECK(place_text(1000.00005, 5e-5) == "1000.00005");
  CHECK(place_text(-0.0612907, 1e-6) == "-0.061291");
  CHECK(place_text(0.1, 1e-30) == "0.10000000000000001");
  CHECK(place_text(12345.678, kNone) == "1.235e+04");
  CHECK(place_text(0.0, 1e-3) == "0");
}

TEST_CASE("neighbours have different texts, whatever their distance") {
  for (const double step : {1e-9, 2.5e-7, 9.99e-5, 1.01e-4, 0.3}) {
    CAPTURE(step);
    CHECK(place_text(3600.0, step) != place_text(3600.0 + step, step));
    CHECK(place_text(0.1, step) != place_text(0.1 + step, step));
  }
}

TEST_CASE("a point is told apart from the rows around it, not from rows of the same place") {
  const Series curve{{0, 1, 1, 1.5, 5}, {0, 0, 0, 0, 0}, {0, 2, 3, 3.25, 9}};
  const ToldPoint dwelling = told_point({.abscissa = 1.0, .time = 3.0}, curve);
  CHECK(dwelling.spacing.abscissa == 0.5);
  CHECK(dwelling.spacing.time == 0.25);
  const ToldPoint last = told_point({.abscissa = 5.0, .time = 9.0}, curve);
  CHECK(last.spacing.abscissa == 3.5);
  const ToldPoint unknown = told_point({.abscissa = 5.0}, curve);
  CHECK(unknown.spacing.abscissa == kNone);
}

}  // namespace
}  // namespace slipbench::driver::check
