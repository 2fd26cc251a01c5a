// SPDX-License-Identifier: Apache-2.0
#include "law/definition/filter.hpp"

#include <catch2/catch.hpp>
#include <numbers>

namespace {

using namespace slipbench::law;
using Kind = Filter::Kind;
constexpr double kPi = std::numbers::pi;

TEST_CASE("the coefficient of a filter comes from its value and the duration of the increment") {
  const auto alpha = [](Kind kind, double value, double dt, Convention convention) {
    return filter_coefficient({kind, value, false}, dt, convention);
  };
  for (const Convention convention : {Convention::kDocumented, Convention::kAsCoded}) {
    CHECK(alpha(Kind::kNone, 0.3, 1e-4, convention) == 1.0);
    CHECK(alpha(Kind::kSimple, 0.3, 1e-4, convention) == 0.3);
    CHECK(alpha(Kind::kPeriod, 0.01, 1e-4, convention) == Approx(2.0 * kPi / 100.0));
    // A period shorter than 2 pi increments: the reader refuses it, here it is reported.
    CHECK(alpha(Kind::kPeriod, 1e-4, 1e-4, convention) == Approx(2.0 * kPi));
  }
  // 2 pi f dt = 0.0628 and 6.28: the page cuts at 1 from above, the program from below.
  CHECK(alpha(Kind::kFrequency, 100.0, 1e-4, Convention::kDocumented) == Approx(0.02 * kPi));
  CHECK(alpha(Kind::kFrequency, 100.0, 1e-2, Convention::kDocumented) == 1.0);
  CHECK(alpha(Kind::kFrequency, 100.0, 1e-4, Convention::kAsCoded) == 1.0);
  CHECK(alpha(Kind::kFrequency, 100.0, 1e-2, Convention::kAsCoded) == Approx(2.0 * kPi));
}

TEST_CASE("no time is no step of a filter over time") {
  CHECK(filter_coefficient({Kind::kPeriod, 0.1, false}, 0.0, Convention::kDocumented) == 0.0);
  CHECK(filter_coefficient({Kind::kFrequency, 9.0, false}, 0.0, Convention::kDocumented) == 0.0);
  CHECK(filter_coefficient({Kind::kSimple, 0.4, false}, 0.0, Convention::kDocumented) == 0.4);
}

}  // namespace
