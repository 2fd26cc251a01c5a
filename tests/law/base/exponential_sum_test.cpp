// SPDX-License-Identifier: Apache-2.0
#include "law/base/exponential_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace slipbench::law;

TEST_CASE("a sum that touches zero changes its sign nowhere, whatever its rounding") {
  for (int i = 0; i < 60; ++i) {
    const double touched = 0.1 + 0.04 * i;
    for (const double rate : {-3.5, -0.5, 1.5}) {
      ExponentialSum root = exponential_term(rate, {1.0});
      root.add(polynomial({-std::exp(rate * touched)}));
      CAPTURE(touched, rate);
      CHECK(sign_changes(product(root, root), 0.0, 3.0).count == 0);
      REQUIRE(sign_changes(root, 0.0, 3.0).count == 1);
      // A sum within eight roundings of its terms has no sign.
      CHECK(first_sign_change(root, 0.0, 3.0) == Approx(touched).margin(2e-14));
    }
  }
}

TEST_CASE("the size of a sum does not matter to where its sign changes") {
  for (const double size : {1e-30, 1.0, 1e30}) {
    CAPTURE(size);
    CHECK(first_sign_change(polynomial({-size, 2.0 * size}), 0.0, 3.0) == Approx(0.5));
  }
}

}  // namespace
