// SPDX-License-Identifier: Apache-2.0
#include "reference/static_kinetic_sawtooth.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

using static_kinetic_sawtooth::Slider;

namespace {

constexpr Slider kSlider{{0.3, 0.2, 0.05}, 100.0, 1000.0};
const std::vector<std::vector<double>> kParameters{{0.3}, {0.2}, {0.05}, {100.0}, {1000.0}};

struct Band {
  double lowest;
  double highest;
  double last;
};

/// Backward Euler at v = 1: the forces of the last increments of many.
Band pull(double increment, int increments, int watched) {
  double force = 0.0;
  Band band{1e300, -1e300, 0.0};
  for (int i = 0; i < increments; ++i) {
    force = static_kinetic_sawtooth::backward_euler(kSlider, force, increment, increment);
    if (i < increments - watched) continue;
    band.lowest = std::min(band.lowest, force);
    band.highest = std::max(band.highest, force);
  }
  band.last = force;
  return band;
}

}  // namespace

TEST_CASE("the threshold, the smooth force and the period have the printed numbers") {
  CHECK_THAT(static_kinetic_sawtooth::smallest_increment(kSlider, 1.0),
             printed("9.51229424500714e-4"));
  CHECK_THAT(static_kinetic_sawtooth::smooth_force(kSlider, 1.0), printed("29.5122942450071"));
  CHECK(static_kinetic_sawtooth::period(kSlider, 1.0) == Approx(0.01).epsilon(1e-14));
  CHECK(static_kinetic_sawtooth::coexistence_increment(kSlider) == Approx(5e-4).epsilon(1e-14));
}

TEST_CASE("backward Euler settles above the threshold and oscillates below") {
  const Band above = pull(9.6e-4, 6000, 100);
  // The slope at the fixed point is -0.98: 6000 increments leave rounding only.
  CHECK(above.last == Approx(29.5122942450071).epsilon(1e-13));
  CHECK(above.highest - above.lowest < 1e-12);
  const Band below = pull(9.5e-4, 6000, 1000);
  // Printed with two decimals: 29.05 .. 30.00.
  CHECK(below.lowest == Approx(29.05).margin(0.005));
  CHECK(below.highest == Approx(30.0).margin(0.005));
}

TEST_CASE("backward Euler with short increments makes the saw-tooth") {
  const Band band = pull(1e-5, 20000, 5000);
  // One increment of travel is k v dt = 0.01 N.
  CHECK(band.lowest == Approx(20.0).margin(0.02));
  CHECK(band.highest == Approx(30.0).margin(0.02));

  std::vector<std::vector<double>> path;
  for (int i = 0; i <= 10000; ++i) path.push_back({1e-5 * i, 1e-5 * i});
  const auto rows = evaluate("static_kinetic_sawtooth", kParameters, path);
  int drops = 0;
  int first = 0;
  int last = 0;
  for (int i = 1; i <= 10000; ++i) {
    const auto n = static_cast<std::size_t>(i);
    if (rows[n][2] < rows[n - 1][2] - 5.0) {
      if (drops == 0) first = i;
      last = i;
      ++drops;
    }
  }
  CHECK(drops == 7);
  // Each drop is up to an increment late.
  CHECK((last - first) * 1e-5 / (drops - 1) == Approx(0.01).margin(1.1e-5));
}

TEST_CASE("a backward Euler increment satisfies its own equations") {
  for (const double increment : {1e-6, 1e-4, 1e-3, 1.0}) {
    const double travel = -0.05;
    const double force = static_kinetic_sawtooth::backward_euler(kSlider, 3.0, travel, increment);
    const double slip = (3.0 + 1000.0 * travel - force) / 1000.0;
    CHECK(slip < 0.0);
    CHECK(-force ==
          Approx(static_kinetic_sawtooth::smooth_force(kSlider, slip / increment)).epsilon(1e-12));
  }
  CHECK(static_kinetic_sawtooth::backward_euler(kSlider, 3.0, 0.02, 1e-3) == 23.0);
}

TEST_CASE("the saw-tooth drops from the static to the kinetic force, each period") {
  // v = 1: from rest to 30 N in 0.03 s, then a drop each 0.01 s. Rows fall just beside the drops.
  const std::vector<double> times{0.0, 0.02, 0.03, 0.030001, 0.035, 0.039999, 0.0401, 0.0955};
  const std::vector<double> forces{0.0, 20.0, 30.0, 20.001, 25.0, 29.999, 20.1, 25.5};
  std::vector<std::vector<double>> path;
  for (const double t : times) path.push_back({t, t});
  const auto rows = evaluate("static_kinetic_sawtooth", kParameters, path);
  // k times the rounding of the motion.
  for (std::size_t i = 0; i < times.size(); ++i) {
    CHECK(rows[i][0] == Approx(forces[i]).margin(1e-11));
  }
  CHECK(rows.back()[1] == Approx(0.07).epsilon(1e-12));
  CHECK(rows.back()[3] == Approx(29.5122942450071).epsilon(1e-12));
  CHECK(rows.back()[4] == Approx(9.51229424500714e-4).epsilon(1e-12));
  CHECK(rows.back()[5] == Approx(0.01).epsilon(1e-14));
}

TEST_CASE("a reversed saw-tooth climbs from the force it left to the other static limit") {
  const auto rows = evaluate("static_kinetic_sawtooth", kParameters,
                             {{0.0, 0.0}, {0.035, 1.0}, {-0.0195, 2.0}, {-0.0255, 3.0}});
  CHECK(rows[1][0] == Approx(25.0).epsilon(1e-12));
  CHECK(rows[2][0] == Approx(-29.5).epsilon(1e-12));
  CHECK(rows[3][0] == Approx(-25.5).epsilon(1e-12));
  CHECK(rows[3][1] == Approx(0.02).epsilon(1e-12));
}

TEST_CASE("a saw-tooth needs a static coefficient above the kinetic one") {
  const std::vector<std::vector<double>> flat{{0.2}, {0.2}, {0.05}, {100.0}, {1000.0}};
  CHECK(static_kinetic_sawtooth::violation(flat).value() ==
        "static_coefficient must be above kinetic_coefficient");
}
