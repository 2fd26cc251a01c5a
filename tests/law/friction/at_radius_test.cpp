// SPDX-License-Identifier: Apache-2.0
#include "law/friction/at_radius.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

TEMPLATE_LIST_TEST_CASE("at a radius R a law sees w as w R and M as M/R", "", LawList) {
  const FrictionLaw law = TestType::example();
  for (const double radius : {0.3, 1.0, 8.0}) {
    const FrictionLaw spinning = at_radius(law, radius);
    for (const double temperature : {20.0, 60.0}) {
      Ambient ambient;
      ambient.temperature = temperature;
      for (const double speed : {0.0, 0.7, 3.0, 9.0, 40.0, 300.0}) {
        for (const double force : {0.0, 1.0, 30.0, 99.0, 400.0}) {
          CAPTURE(radius, speed, force);
          const CoefficientPoint sliding =
              evaluate(law, ambient, {.slip_rate = speed, .contact_force = force});
          const CoefficientPoint there = evaluate(
              spinning, ambient, {.slip_rate = speed / radius, .contact_force = force * radius});
          CHECK(there.mu == Approx(sliding.mu).epsilon(1e-12));
          CHECK(there.to_slip_rate ==
                Approx(sliding.to_slip_rate * radius).epsilon(1e-9).margin(1e-14));
          CHECK(there.to_contact_force ==
                Approx(sliding.to_contact_force / radius).epsilon(1e-9).margin(1e-14));
        }
      }
    }
    // What the increments are judged by is converted with it.
    CHECK(largest(spinning) == largest(law));
    if (std::isfinite(largest_growth(law))) {
      CHECK(largest_growth(spinning) == Approx(largest_growth(law)));
    }
    if (std::isfinite(steepest_weakening(law))) {
      CHECK(steepest_weakening(spinning) == Approx(steepest_weakening(law) * radius));
    }
    CHECK(depends_on_slip_rate(spinning) == depends_on_slip_rate(law));
    CHECK(depends_on_contact_force(spinning) == depends_on_contact_force(law));
  }
}

TEST_CASE("at a radius a law without an area has that radius as its area") {
  GeneralizedViscous law;
  law.fric = 0.1;
  law.c1 = 2e-4;
  REQUIRE_FALSE(law.area.has_value());
  for (const double force : {0.0, 30.0, 400.0}) {
    CHECK(evaluate(at_radius(law, 8.0), {}, {.contact_force = 8.0 * force}).mu ==
          Approx(evaluate(law, {}, {.contact_force = force}).mu).epsilon(1e-14));
  }
}

}  // namespace
