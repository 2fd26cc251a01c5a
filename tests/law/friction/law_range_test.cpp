// SPDX-License-Identifier: Apache-2.0
#include "law/friction/law_range.hpp"

#include <catch2/catch.hpp>

#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

TEST_CASE("Renard is drawn beyond its joints, in the case's unit of speed") {
  Renard law = Renard::example();
  const LawRange first = range(law);
  CHECK(first.slip_rate >= 1.5 * law.c6);
  CHECK(first.slip_rate <= 3.0 * law.c6);
  CHECK(first.landmarks[1].name == "C3");
  CHECK(first.landmarks[1].slip_rate == law.c5);
  law.speed_factor = 1.0e-3;
  // A quotient in place of a product: one rounding.
  CHECK(range(law).slip_rate == Approx(1.0e3 * first.slip_rate).epsilon(1e-15));
  CHECK(range(law).landmarks[2].slip_rate == Approx(1.0e3 * law.c6).epsilon(1e-15));
}

TEST_CASE("A pressure becomes a normal force by the area") {
  GeneralizedViscous law;
  law.fric = 0.1;
  law.c1 = -0.02;
  law.c4 = 0.001;
  law.area = 3.0;
  CHECK(area_of(law) == 3.0);
  // Twice the pressure of the vertex, 10, times the area.
  CHECK(range(law).contact_force == Approx(60.0).epsilon(1e-14));
  CHECK(range(law).slip_rate == 0.0);
  CHECK(area_of(ExponentialDecay{0.3, 0.2, 1.0}) == 0.0);
}

TEST_CASE("A law without a scale of its own has none") {
  CHECK(range(ConstantCoefficient{0.3}).slip_rate == 0.0);
  CHECK(range(ExponentialDecay{0.3, 0.2, 0.0}).slip_rate == 0.0);
  CHECK(range(ModifiedDarmstad{}).slip_rate == 0.0);
}

TEST_CASE("a law that says nothing of its range is drawn to a few times its speed") {
  CHECK(range(Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-4}).slip_rate == 40.0);
  CHECK(range(Stribeck<>{0.3, 0.2, 10.0, 2.0, 1e-4}).contact_force == 0.0);
}

}  // namespace
