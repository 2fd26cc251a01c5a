// SPDX-License-Identifier: Apache-2.0
#include "law/base/quadrature.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace slipbench::law;

TEST_CASE("an integral costs as many pieces as its tolerance asks for") {
  int budget = 1000;
  // The rule is exact up to the ninth power.
  CHECK(integral([](double x) { return 10.0 * std::pow(x, 9.0); }, 0.0, 2.0, 1e-9, &budget) ==
        Approx(1024.0).epsilon(1e-14));
  CHECK(budget == 999);
  CHECK(integral([](double) { return 0.0; }, 0.0, 2.0, 0.0, &budget) == 0.0);
  CHECK(budget == 998);
  CHECK(integral([](double x) { return std::sqrt(x); }, 0.0, 1.0, 1e-12, &budget) ==
        Approx(2.0 / 3.0).epsilon(1e-11));
  CHECK(budget < 990);
  // Nothing is left for what rounding keeps above the tolerance.
  budget = 0;
  CHECK(integral([](double x) { return std::exp(x); }, 0.0, 1.0, 0.0, &budget) ==
        Approx(std::exp(1.0) - 1.0).epsilon(1e-13));
}

TEST_CASE("a jump is halved 32 times") {
  int budget = 1000;
  const auto step = [](double x) { return x < 1.0 / 3.0 ? 0.0 : 1.0; };
  CHECK(integral(step, 0.0, 1.0, 1e-14, &budget) == Approx(2.0 / 3.0).epsilon(1e-9));
  // One half of each piece has the jump; the last ones are not judged.
  CHECK(budget == 1000 - 1 - 2 * 31);
}

}  // namespace
