// SPDX-License-Identifier: Apache-2.0
#include "law/base/dual.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using namespace slipbench::law;

using First = Dual<double, 1>;
using Second = Dual<First, 1>;

/// Checks a function of one number, first and second derivative against central differences.
template <class F>
void check(const F& f, double x) {
  const Second at = f(Second::variable(First::variable(x, 0), 0));
  const auto value = [&](double y) { return f(First(y)).value; };
  CAPTURE(x);
  CHECK(at.value.value == value(x));
  constexpr double kStep = 1e-4;
  // Third and fourth derivative times the square of the step, and rounding over it.
  CHECK(at.slope[0].value ==
        Approx((value(x + kStep) - value(x - kStep)) / (2 * kStep)).epsilon(1e-6).margin(1e-7));
  CHECK(at.slope[0].slope[0] ==
        Approx((value(x + kStep) - 2 * value(x) + value(x - kStep)) / (kStep * kStep))
            .epsilon(1e-5)
            .margin(1e-6));
  CHECK(at.value.slope[0] == at.slope[0].value);
}

TEST_CASE("a dual number carries the derivatives of every function it knows") {
  for (const double x : {0.3, 1.0, 2.7}) {
    check([](auto y) { return exp(y) - 2.0 * y; }, x);
    check([](auto y) { return log(y) * y; }, x);
    check([](auto y) { return log1p(y) / (1.0 + y); }, x);
    check([](auto y) { return sqrt(y) + -y; }, x);
    check([](auto y) { return tanh(y); }, x);
    check([](auto y) { return atan(y); }, x);
    check([](auto y) { return asinh(2.0 * y); }, x);
    check([](auto y) { return pow(y, 2.5) + pow(2.0 * y, y); }, x);
    check([](auto y) { return abs(1.5 - y) * y; }, x);
    check([](auto y) { return y < 2.0 ? 3.0 * y : y * y * y; }, x);
    check(
        [](auto y) {
          auto z = y;
          z *= y;
          z += 1.0;
          z /= y;
          z -= 3.0;
          return z;
        },
        x);
  }
}

TEST_CASE("at zero a power, and what does not change, have finite slopes") {
  const First zero = First::variable(0.0, 0);
  CHECK(pow(zero, 1.0).slope[0] == 1.0);
  CHECK(pow(zero, 2.0).slope[0] == 0.0);
  CHECK(pow(zero, 0.0).slope[0] == 0.0);
  CHECK(pow(First(0.0), First::variable(1.5, 0)).slope[0] == 0.0);
  CHECK(sqrt(First(0.0)).slope[0] == 0.0);
}

}  // namespace
