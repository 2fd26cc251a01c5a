// SPDX-License-Identifier: Apache-2.0
#include "driver/results/law_range.hpp"

#include <catch2/catch.hpp>

namespace slipbench::driver::results {
namespace {

TEST_CASE("Renard is drawn beyond its joints, in the case's unit of speed") {
  law::Renard law = law::Renard::example();
  const LawRange range = law_range(law);
  CHECK(range.slip_rate >= 1.5 * law.c6);
  CHECK(range.slip_rate <= 3.0 * law.c6);
  REQUIRE(range.landmarks.size() == 3);
  CHECK(range.landmarks[1].name == "C3");
  CHECK(range.landmarks[1].slip_rate == law.c5);
  law.speed_factor = 1.0e-3;
  // A quotient in place of a product: one rounding.
  CHECK(law_range(law).slip_rate == Approx(1.0e3 * range.slip_rate).epsilon(1e-15));
  CHECK(law_range(law).landmarks[2].slip_rate == Approx(1.0e3 * law.c6).epsilon(1e-15));
}

TEST_CASE("A pressure becomes a normal force by the area") {
  law::GeneralizedViscous law;
  law.fric = 0.1;
  law.c1 = -0.02;
  law.c4 = 0.001;
  law.area = 3.0;
  CHECK(area_of(law) == 3.0);
  // Twice the pressure of the vertex, 10, times the area.
  CHECK(law_range(law).contact_force == Approx(60.0).epsilon(1e-14));
  CHECK(law_range(law).slip_rate == 0.0);
  CHECK(area_of(law::ExponentialDecay{0.3, 0.2, 1.0}) == 0.0);
}

TEST_CASE("A law without a scale of its own has none") {
  CHECK(law_range(law::ConstantCoefficient{0.3}).slip_rate == 0.0);
  CHECK(law_range(law::ExponentialDecay{0.3, 0.2, 0.0}).slip_rate == 0.0);
  CHECK(law_range(law::ModifiedDarmstad{}).slip_rate == 0.0);
}

TEST_CASE("a law that says nothing of its range is drawn to a few times its speed") {
  CHECK(law_range(law::Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-4}).slip_rate == 40.0);
  CHECK(law_range(law::Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-4}).contact_force == 0.0);
}

}  // namespace
}  // namespace slipbench::driver::results
