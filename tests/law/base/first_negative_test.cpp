// SPDX-License-Identifier: Apache-2.0
#include "law/base/first_negative.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

namespace slipbench::law {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Falling {
  const char* name;
  std::function<double(double)> f;
  double zero;
  int most_calls;  ///< where bisection alone takes some 55
};

TEST_CASE("the zero of a falling function is found from its negative side, in few calls") {
  const Falling functions[] = {
      {"a line", [](double x) { return 0.3 - x; }, 0.3, 8},
      {"a parabola", [](double x) { return 0.49 - x * x; }, 0.7, 12},
      {"a decay", [](double x) { return std::exp(-5.0 * x) - std::exp(-1.0); }, 0.2, 12},
      {"a steep end", [](double x) { return std::sqrt(std::abs(0.6 - x)) * (x < 0.6 ? 1 : -1); },
       0.6, 60},
      {"a flat zero", [](double x) { return std::pow(0.7 - x, 3); }, 0.7, 60},
      {"a jump", [](double x) { return x < 0.123 ? 1.0 : -1.0; }, 0.123, 60},
      {"a zero at the begin", [](double x) { return -x; }, 0.0, 100},
  };
  for (const Falling& one : functions) {
    INFO(one.name);
    int calls = 0;
    const double found = first_negative(
        [&](double x) {
          ++calls;
          return one.f(x);
        },
        0.0, 1.0);
    CHECK(one.f(found) < 0.0);
    CHECK(found == Approx(one.zero).margin(4.0 * kEpsilon));
    CHECK(calls <= one.most_calls);
  }
}

TEST_CASE("the bracket of a small zero is as narrow, as a part of it") {
  const auto jump = [](double x) { return x < 1.23e-13 ? 1.0 : -1.0; };
  const double found = first_negative(jump, 0.0, 1e-12);
  CHECK(found >= 1.23e-13);
  CHECK(found <= 1.23e-13 * (1.0 + 20.0 * kEpsilon));
}

TEST_CASE("the bracket of a zero need not be narrower than asked for") {
  const auto jump = [](double x) { return x < 0.123 ? 1.0 : -1.0; };
  const double wide = first_negative(jump, 0.0, 1.0, 1e-3);
  CHECK(wide > 0.123 + 1e-5);
  CHECK(wide < 0.123 * (1.0 + 1e-3));
  // A part of 1 where the zero is smaller.
  const auto near_zero = [](double x) { return x < 1e-9 ? 1.0 : -1.0; };
  const double near = first_negative(near_zero, 0.0, 1.0, 1e-3, 1.0);
  CHECK(near > 1e-5);
  CHECK(near <= 1e-3);
}

}  // namespace
}  // namespace slipbench::law
