// SPDX-License-Identifier: Apache-2.0
// Springs, dampers and stops beside friction.
#include "law/component/elasticity.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "law/base/stop.hpp"
#include "law/component/damping.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// [force | displacement, temperature]: stiffer in pressure, softer when hot.
Elasticity spring() {
  return Elasticity(make_function({{-300, -1, 20},
                                   {0, 0, 20},
                                   {100, 1, 20},
                                   {120, 2, 20},
                                   {-150, -1, 120},
                                   {0, 0, 120},
                                   {60, 2, 120}},
                                  {over_motion(1), kOverTemperature}));
}

Ambient at_temperature(double temperature) {
  Ambient ambient;
  ambient.temperature = temperature;
  ambient.motion.values.fill(77.0);  // the connector's: a spring is asked at its own displacement
  return ambient;
}

TEST_CASE("a linear spring gives k u, k and k u^2/2") {
  const Elasticity linear(50.0);
  const ForcePoint point = linear.value(-0.2, {});
  CHECK(point.force == -10.0);
  CHECK(point.slope == 50.0);
  CHECK(linear.energy(-0.2, {}) == Approx(1.0).epsilon(1e-15));
  CHECK(linear.table() == nullptr);
}

TEST_CASE("a spring's table is asked at the displacement and the temperature") {
  const Elasticity table = spring();
  CHECK(table.value(0.5, at_temperature(20)).force == 50.0);
  CHECK(table.value(0.5, at_temperature(20)).slope == 100.0);
  CHECK(table.value(1.5, at_temperature(20)).force == 110.0);
  CHECK(table.value(1.5, at_temperature(20)).slope == Approx(20.0).epsilon(1e-13));
  // Between the temperatures: the mean of 50 and 15.
  CHECK(table.value(0.5, at_temperature(70)).force == Approx(32.5).epsilon(1e-15));
  CHECK(table.value(0.5, at_temperature(70)).slope == Approx(65.0).epsilon(1e-13));
  // Held outside.
  CHECK(table.value(9.0, at_temperature(20)).force == 120.0);
  CHECK(table.value(9.0, at_temperature(20)).slope == 0.0);
}

TEST_CASE("a table over the displacement alone holds the energy of one over the temperature, too") {
  for (const Rows& rows :
       {Rows{{-30, -2}, {-10, -0.5}, {5, 0}, {8, 0.25}, {40, 3}}, Rows{{-3, -2}, {7, -1}, {9, 1.5}},
        Rows{{2, 0.5}, {4, 1}, {1, 2}}, Rows{{-6, -4}, {-2, -3}, {-1, -0.25}}, Rows{{12, 1}}}) {
    Rows twice;
    for (const double temperature : {0.0, 100.0}) {
      for (const auto& row : rows) twice.push_back({row[0], row[1], temperature});
    }
    const Independent displacement{IndependentKind::kConstitutiveMotion, 0};
    for (const Extrapolation outside : {Extrapolation::kConstant, Extrapolation::kLinear}) {
      if (rows.size() == 1 && outside == Extrapolation::kLinear) continue;
      const Elasticity alone(make_function(rows, {displacement}, 1, outside));
      const Elasticity warm(make_function(twice, {displacement, kOverTemperature}, 1, outside));
      for (const double u :
           {-5.0, -2.0, -1.2, -0.5, -0.1, 0.0, 0.1, 0.25, 0.7, 1.0, 2.0, 3.0, 7.0}) {
        CHECK(alone.energy(u, {}) == Approx(warm.energy(u, at_temperature(0))).epsilon(1e-14));
      }
    }
  }
}
TEST_CASE("the energy of a spring is the integral of its force, exactly") {
  const Elasticity table = spring();
  CHECK(table.energy(0.0, at_temperature(20)) == 0.0);
  CHECK(table.energy(2.0, at_temperature(20)) == Approx(50.0 + 110.0).epsilon(1e-15));
  CHECK(table.energy(3.0, at_temperature(20)) == Approx(160.0 + 120.0).epsilon(1e-15));
  CHECK(table.energy(-1.0, at_temperature(20)) == Approx(150.0).epsilon(1e-15));
  // Against a fine sum; the trapezoid is exact but in the cells with a knot: 1e-4^2 times a kink.
  for (const double u : {1.7, -0.6}) {
    for (const double temperature : {20.0, 55.0, 120.0}) {
      const int n = 20000;
      double sum = 0.0;
      for (int i = 0; i < n; ++i) {
        sum += table.value(u * (i + 0.5) / n, at_temperature(temperature)).force * u / n;
      }
      CHECK(table.energy(u, at_temperature(temperature)) == Approx(sum).epsilon(1e-7));
    }
  }
}

TEST_CASE("a damper's force follows the velocity with its sign") {
  const Damping linear(4.0);
  CHECK(linear.value(-0.5, {}).force == -2.0);
  CHECK(linear.value(-0.5, {}).slope == 4.0);
  const Damping table(make_function({{-10, -2}, {0, 0}, {30, 1}}, {kOverSlipRate}));
  CHECK(table.value(-1.0, {}).force == -5.0);
  CHECK(table.value(-1.0, {}).slope == 5.0);
  CHECK(table.value(0.5, {}).force == 15.0);
  CHECK(table.value(7.0, {}).force == 30.0);
}

TEST_CASE("a stop is reached at its position, and a side without a number never") {
  const Stop both{-0.1, 0.2};
  CHECK(both.flag(0.0) == 0);
  CHECK(both.flag(0.2) == 1);
  CHECK(both.flag(std::nextafter(0.2, 0.0)) == 0);
  CHECK(both.flag(-0.1) == -1);
  CHECK(both.flag(-5.0) == -1);
  CHECK(Stop{}.flag(1e300) == 0);
  CHECK(Stop{}.flag(-1e300) == 0);
}

}  // namespace
