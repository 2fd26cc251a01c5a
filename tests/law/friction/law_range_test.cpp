// SPDX-License-Identifier: Apache-2.0
#include "law/friction/law_range.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "law/friction/law_list.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

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

TEST_CASE("Renard is drawn until its last piece is near C2, within limits") {
  Renard law = Renard::example();
  law.c6 = 20.0;
  // 3/sqrt(C2 - C4) beyond C6, where nine tenths of the last piece are done.
  CHECK(range(law).slip_rate == Approx(20.0 + 3.0 / std::sqrt(0.05)).epsilon(1e-15));
  law.c5 = 0.5, law.c6 = 1.0;
  CHECK(range(law).slip_rate == 3.0);
  law.c4 = law.c2;
  CHECK(range(law).slip_rate == 1.5);  // no last piece to be seen
}

TEST_CASE("a polynomial is drawn until it has turned, or changed by its own size") {
  CHECK(polynomial_scale(0.3, -0.1, 0.02) == Approx(5.0).epsilon(1e-15));
  CHECK(polynomial_scale(0.3, 0.1, 0.02) == Approx(3.0).epsilon(1e-15));
  CHECK(polynomial_scale(0.3, 0.0, 0.03) == Approx(std::sqrt(10.0)).epsilon(1e-15));
  CHECK(polynomial_scale(0.0, 0.0, 0.001) == Approx(10.0).epsilon(1e-15));
  CHECK(polynomial_scale(0.3, 0.0, 0.0) == 0.0);
}

TEST_CASE("an exponential is drawn until it has died away, or grown e times") {
  const LawRange decay = range(ExponentialDecay{0.3, 0.2, 0.05});
  CHECK(decay.slip_rate == 4.0 / 0.05);
  CHECK(decay.contact_force == 0.0);
  CHECK(decay.landmarks[0].name == "static");
  CHECK(decay.landmarks[0].slip_rate == 0.0);
  CHECK(range(ExponentialDecay{0.3, 0.3, 0.05}).landmarks[0].name.empty());
  CHECK(exponential_scale(0.25) == 4.0);
  // The fastest of three, twice as far; the pressure as long as it changes Fric + C5.
  const LawRange three = range(ModifiedDarmstad{0.08, 0.0, -1e-3, -2e-4, -2e-3, 0.1, -5e-4, 3.0});
  CHECK(three.slip_rate == Approx(2.0 * 4.0 / 2e-3).epsilon(1e-15));
  CHECK(three.contact_force == Approx(3.0 * 0.18 / 2e-4).epsilon(1e-14));
  CHECK(range(ModifiedDarmstad{0.08, 0.0, 0.0, -2e-4, -1e-3, 0.1, -4e-3, 1.0}).slip_rate ==
        Approx(2.0 * 4.0 / 4e-3).epsilon(1e-15));
}

TEST_CASE("a decay through measured points is drawn beyond them") {
  const ExponentialTestData slow{0.3, 0.23, 20.0, 0.2};
  CHECK(range(slow).slip_rate == 4.0 / slow.fit().decay);
  // 4/decay = 4 rate2/ln(20) < 1.5 rate2.
  const LawRange fast = range(ExponentialTestData{0.3, 0.23, 20.0, {}});
  CHECK(fast.slip_rate == 30.0);
  CHECK(fast.contact_force == 0.0);
  CHECK(fast.landmarks[0].name == "mu1");
  CHECK(fast.landmarks[0].slip_rate == 0.0);
  CHECK(fast.landmarks[1].name == "mu2");
  CHECK(fast.landmarks[1].slip_rate == 20.0);
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
  CHECK(area_of(GeneralizedViscous{}) == 0.0);
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

TEST_CASE("a table is drawn a tenth beyond its last knots and not over what it does not see") {
  const LawRange both = range(TabularCoefficient::example());
  CHECK(both.slip_rate == Approx(22.0).epsilon(1e-15));
  CHECK(both.contact_force == Approx(110.0).epsilon(1e-15));
  const LawRange warm =
      range(TabularCoefficient{make_function({{0.3, 20.0}, {0.2, 90.0}}, {kOverTemperature})});
  CHECK(warm.slip_rate == 0.0);
  CHECK(warm.contact_force == 0.0);
}

}  // namespace
