// SPDX-License-Identifier: Apache-2.0
#include "reference/coulomb_vibration.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {

// Ansys verification manual, VM73: weight 10 lb, g = 386 in/s^2.
constexpr coulomb_vibration::Vibration kVibration{10.0 / 386.0, 30.0, 1.875, -1.0};
const std::vector<std::vector<double>> kParameters{{10.0 / 386.0}, {30.0}, {0.1875},
                                                   {10.0},         {-1.0}, {0.0}};

}  // namespace

TEST_CASE("a vibration with Coulomb friction has the printed motions") {
  const auto rows =
      evaluate("coulomb_vibration", kParameters, {{0.0}, {0.09}, {0.102}, {0.183}, {3.0}});
  CHECK(rows[0][0] == -1.0);
  CHECK_THAT(rows[1][0], printed("0.872079991658775"));
  CHECK_THAT(rows[2][0], printed("0.831315646639621"));
  CHECK_THAT(rows[3][0], printed("-0.748735172644047"));
  // The published values, to their five digits.
  CHECK_THAT(rows[1][0], printed("0.87208"));
  CHECK_THAT(rows[2][0], printed("0.83132"));
  CHECK_THAT(rows[3][0], printed("-0.74874"));
  CHECK(std::abs(rows[4][0]) <= 0.0625);
  CHECK(rows[4][1] == 0.0);
  CHECK(rows[4][2] == Approx(-30.0 * rows[4][0]).margin(1e-14));
}

TEST_CASE("the amplitude falls by 2 F/k each half cycle until the spring cannot move the mass") {
  for (int n = 0; n <= 7; ++n) {
    CHECK(coulomb_vibration::amplitude(kVibration, n) == Approx(1.0 - 0.125 * n).epsilon(1e-14));
  }
  // 0.125 > F/k = 0.0625, 0 is not: rest after eight half cycles, at the relaxed spring.
  CHECK(coulomb_vibration::half_cycles_to_rest(kVibration) == 8.0);
  auto short_of_it = kVibration;
  short_of_it.initial_motion = 0.0625;
  CHECK(coulomb_vibration::half_cycles_to_rest(short_of_it) == 0.0);
  CHECK(coulomb_vibration::at(short_of_it, 5.0).motion == 0.0625);
}

TEST_CASE("what a vibration with Coulomb friction loses it dissipates") {
  std::vector<std::vector<double>> times;
  for (int i = 0; i <= 500; ++i) times.push_back({0.002 * i});
  double before = -1.0;
  for (const auto& row : evaluate("coulomb_vibration", kParameters, times)) {
    const double energy = 15.0 * row[0] * row[0] + 5.0 / 386.0 * row[1] * row[1];
    CHECK(energy + row[4] == Approx(15.0).epsilon(1e-13));
    CHECK(row[3] >= before);
    before = row[3];
  }
}

TEST_CASE("without friction the vibration goes on") {
  const auto rows = evaluate("coulomb_vibration", {{1.0}, {100.0}, {0.0}, {10.0}, {0.2}, {1.0}},
                             {{0.0}, {1.05}, {51.0}});
  CHECK(rows[1][0] == Approx(0.2 * std::cos(0.5)).epsilon(1e-13));
  // 500 rad carry a rounding of 1e-13.
  CHECK(rows[2][0] == Approx(0.2 * std::cos(500.0)).epsilon(1e-11));
}

TEST_CASE("a vibration with Coulomb friction is the oscillator on a belt at rest") {
  std::vector<std::vector<double>> times;
  for (int i = 0; i <= 300; ++i) times.push_back({0.0037 * i});
  const auto vibration =
      evaluate("coulomb_vibration", {{0.02}, {30.0}, {0.2}, {10.0}, {0.93}, {0.0}}, times);
  const auto oscillator =
      evaluate("stick_slip_oscillator",
               {{0.02}, {30.0}, {10.0}, {0.2}, {0.2}, {0.0}, {0.93}, {0.0}, {0.0}}, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    // A few events' roundings.
    CHECK(oscillator[i][0] == Approx(vibration[i][0]).margin(1e-12));
    CHECK(oscillator[i][1] == Approx(vibration[i][1]).margin(1e-10));
    CHECK(oscillator[i][4] == Approx(vibration[i][4]).margin(1e-11));
  }
}
