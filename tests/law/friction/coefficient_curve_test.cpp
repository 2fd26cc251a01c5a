// SPDX-License-Identifier: Apache-2.0
#include "law/friction/coefficient_curve.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "law/friction/law_list.hpp"
#include "law/friction/radioss_coefficient.hpp"

namespace {

using namespace slipbench::law;

TEST_CASE("the curve of a law is its coefficient before the floor, as far as the formula holds") {
  const auto check = [](const auto& law) {
    SlipLine line{.slip = 2.0,
                  .end = 6.0,
                  .rate_at_zero = -40.0,
                  .rate_per_slip = 30.0,
                  .force = 20.0,
                  .force_per_slip = 5.0};
    while (line.slip < line.end) {
      const CoefficientCurve curve = law.along(line);
      const double until = std::min(curve.until, 1.0);
      REQUIRE(until > 0.0);
      for (int i = 0; i <= 16; ++i) {
        const double t = until * i / 16.0;
        const double x = line.slip + t * (line.end - line.slip);
        const double below = curve.denominator.count == 0 ? 1.0 : curve.denominator(t);
        CAPTURE(line.slip, t);
        CHECK(below > 0.0);
        // Sums of up to six terms of the size of 1; the last piece of Renard's law loses digits.
        CHECK(curve.numerator(t) / below ==
              Approx(raw_coefficient(
                         law, Ambient{},
                         {.slip_rate = line.rate_at(x), .contact_force = line.force_at(x)}))
                  .epsilon(1e-12));
      }
      const double next = line.slip + until * (line.end - line.slip);
      line.force = line.force_at(next);
      line.slip = until < 1.0 ? next : line.end;
    }
  };
  check(GeneralizedViscous{0.12, -2e-4, -1e-4, 1e-6, 4e-7, 5e-8, 0.0, 2.0});
  check(ModifiedDarmstad{0.08, 1e-6, -2e-3, -2e-4, -1e-3, 0.1, -5e-3, 2.0});
  check(Renard::example());  // V from 20 to 140: both of its later pieces
  Renard late = Renard::example();
  late.c5 = 50.0, late.speed_factor = 0.9;
  check(late);
}

TEST_CASE("a quotient meets the floor where it is the floor") {
  // 3 floor t/(1 + t) = floor at t = 1/2; 3 floor (1 - 1/(1 + t)) has no inflection.
  const double floor = kCoefficientFloor;
  const CoefficientCurve curve{.numerator = polynomial({0.0, 3.0 * floor}),
                               .denominator = polynomial({1.0, 1.0}),
                               .recovery = 3.0 * floor};
  CHECK(next_bend(curve, {.end = 1.0, .force = 1.0}) == Approx(0.5).epsilon(1e-13));
}

TEST_CASE("a search that stands on a bend does not find it again, however short the way ahead") {
  for (int i = 1; i < 200; ++i) {
    // mu = 0.02 (V_0 - V) meets its floor at V_0; V = 1000 (x - 1000).
    const double fric = 0.0001 * i;
    const GeneralizedViscous law{fric, 0.0, -0.02, 0.0, 0.0, 0.0, 0.0, {}};
    SlipLine line{.slip = 1000.0,
                  .end = 1000.001,
                  .rate_at_zero = -1e6,
                  .rate_per_slip = 1000.0,
                  .force = 1.0,
                  .force_per_slip = 1.0};
    const double bend = next_bend(law, line);
    REQUIRE(bend == Approx(1000.0 + fric / 20.0).epsilon(1e-12));
    line.force = line.force_at(bend);
    line.slip = bend;
    CHECK(next_bend(law, line) == kNoBend);
  }
}

}  // namespace
