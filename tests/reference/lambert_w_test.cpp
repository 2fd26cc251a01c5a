// SPDX-License-Identifier: Apache-2.0
#include "reference/lambert_w.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/reference/printed.hpp"

using slipbench::reference::lambert_w0;

TEST_CASE("Lambert's W inverts w e^w") {
  // Away from the branch point the condition of the inverse is near 1: some units in the last
  // place.
  for (const double w : {-0.9, -0.5, -0.1, -1e-8, 1e-300, 0.3, 1.0, 2.5, 30.0, 600.0}) {
    CHECK(lambert_w0(w * std::exp(w)) == Approx(w).epsilon(1e-13));
  }
  CHECK_THAT(lambert_w0(1.0), printed("0.567143290409784"));
  CHECK(lambert_w0(0.0) == 0.0);
}

TEST_CASE("Lambert's W meets its branch point and has no value beyond") {
  CHECK(lambert_w0(-1.0 / std::numbers::e) == Approx(-1.0).epsilon(1e-7));
  // Just above the branch point, w = -1 + p - p^2/3 + ..., where x = (p^2/2 - 1)/e loses half the
  // digits.
  const double p = 1e-3;
  CHECK(lambert_w0((0.5 * p * p - 1.0) / std::numbers::e) ==
        Approx(-1.0 + p - p * p / 3.0 + 11.0 / 72.0 * p * p * p).epsilon(1e-12));
  CHECK(std::isnan(lambert_w0(-0.4)));
  CHECK(std::isnan(lambert_w0(std::numeric_limits<double>::quiet_NaN())));
  CHECK(std::isinf(lambert_w0(std::numeric_limits<double>::infinity())));
}
