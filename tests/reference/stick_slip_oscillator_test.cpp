// SPDX-License-Identifier: Apache-2.0
#include "reference/stick_slip_oscillator.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

using stick_slip_oscillator::Oscillator;

namespace {

constexpr Oscillator kBelt{1.0, 100.0, 10.0, 0.4, 0.3, 0.05};
const std::vector<std::vector<double>> kParameters{{1.0},  {100.0}, {10.0}, {0.4}, {0.3},
                                                   {0.05}, {0.0},   {0.05}, {5.0}};

}  // namespace

TEST_CASE("a mass on a belt has the printed limit cycle") {
  const auto cycle = stick_slip_oscillator::limit_cycle(kBelt);
  CHECK_THAT(cycle.amplitude, printed("0.0111803398874989"));
  CHECK_THAT(cycle.slip_time, printed("0.406888787159141"));
  CHECK(cycle.stick_time == Approx(0.4).epsilon(1e-14));
  CHECK_THAT(cycle.period, printed("0.806888787159141"));
  CHECK_THAT(cycle.maximum_motion, printed("0.0411803398874989"));
  CHECK(cycle.stick_motion == Approx(0.02).epsilon(1e-14));
  CHECK_THAT(cycle.heat, printed("0.121033318073871"));
}

TEST_CASE("a mass taken along by a belt runs into its limit cycle") {
  // Stick from the relaxed spring lasts 0.04/0.05 = 0.8 s; then slip and stick alternate.
  const auto cycle = stick_slip_oscillator::limit_cycle(kBelt);
  const double first = 0.8;
  const double end = first + cycle.slip_time;
  const auto rows = evaluate("stick_slip_oscillator", kParameters,
                             {{5.0},
                              {5.4},
                              {5.0 + first + 1e-9},
                              {5.0 + end + 1e-9},
                              {5.0 + end + 0.2},
                              {5.0 + first + 100.0 * cycle.period},
                              {5.0 + first + 100.25 * cycle.period}});
  // Events are met within 1e-9 s, where the velocity is 0.05.
  CHECK(rows[0] == std::vector<double>{0.0, 0.05, 0.0, 0.0, 0.0});
  CHECK(rows[1][0] == Approx(0.02).epsilon(1e-12));
  CHECK(rows[1][2] == Approx(2.0).epsilon(1e-12));
  CHECK(rows[1][3] == 0.0);
  CHECK(rows[2][0] == Approx(0.04).epsilon(1e-8));
  CHECK(rows[2][2] == Approx(3.0).epsilon(1e-12));
  CHECK(rows[3][0] == Approx(0.02).epsilon(1e-8));
  CHECK(rows[3][1] == Approx(0.05).epsilon(1e-12));
  CHECK(rows[3][4] == Approx(cycle.heat).epsilon(1e-12));
  CHECK(rows[4][0] == Approx(0.03).epsilon(1e-10));
  // A hundred cycles' roundings.
  CHECK(rows[5][0] == Approx(0.04).epsilon(1e-10));
  CHECK(rows[5][4] == Approx(100.0 * cycle.heat).epsilon(1e-11));
  CHECK(rows[6][3] > rows[5][3]);
}

TEST_CASE("a mass on a belt obeys Newton's law and its energy balance from any start") {
  struct Start {
    double motion;
    double velocity;
    double belt;
  };
  for (const Start& start : {Start{0.0, 0.0, 0.05}, Start{0.3, -1.0, 0.05}, Start{-0.2, 2.0, -0.3},
                             Start{0.5, 0.0, 0.0}, Start{0.01, 0.02, 0.5}}) {
    const double dt = 1e-4;
    std::vector<std::vector<double>> times;
    for (int i = 0; i <= 30000; ++i) times.push_back({dt * i});
    const auto rows = evaluate("stick_slip_oscillator",
                               {{1.0},
                                {100.0},
                                {10.0},
                                {0.4},
                                {0.3},
                                {start.belt},
                                {start.motion},
                                {start.velocity},
                                {0.0}},
                               times);
    const auto energy = [&](std::size_t i) {
      return 50.0 * rows[i][0] * rows[i][0] + 0.5 * rows[i][1] * rows[i][1];
    };
    double belt_work = 0.0;
    int kicks = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      belt_work += 0.5 * (rows[i][2] + rows[i - 1][2]) * start.belt * dt;
      // x'' = (f - k x)/m by the trapezoidal rule; the force jumps in the row of an event.
      const double impulse =
          0.5 * dt * (rows[i][2] + rows[i - 1][2] - 100.0 * (rows[i][0] + rows[i - 1][0]));
      const double gap = std::abs(rows[i][1] - rows[i - 1][1] - impulse);
      if (gap > 1e-8) ++kicks;
      REQUIRE(gap < 1e-3);
      REQUIRE(rows[i][3] >= rows[i - 1][3]);
      REQUIRE(std::abs(rows[i][0] - rows[i - 1][0] - 0.5 * dt * (rows[i][1] + rows[i - 1][1])) <
              1e-7);
    }
    CHECK(kicks < 30);
    // A jump of the force inside a row is worth up to 7 N 0.5 m/s 1e-4 s each.
    CHECK(belt_work == Approx(energy(rows.size() - 1) - energy(0) + rows.back()[4]).margin(1e-3));
  }
}

TEST_CASE("a belt that is faster than the mass can swing never sticks") {
  // Released near the centre of slip, x = mu_k N/k: the swing stays slower than the belt.
  const auto rows = evaluate("stick_slip_oscillator",
                             {{1.0}, {100.0}, {10.0}, {0.4}, {0.3}, {0.5}, {0.04}, {0.0}, {0.0}},
                             {{0.0}, {0.1}, {1.0}, {10.0}});
  for (std::size_t i = 0; i < 4; ++i) {
    const double t = i == 0 ? 0.0 : std::pow(10.0, static_cast<double>(i) - 2.0);
    CHECK(rows[i][0] == Approx(0.03 + 0.01 * std::cos(10.0 * t)).epsilon(1e-12));
    CHECK(rows[i][2] == Approx(3.0).epsilon(1e-14));
  }
}

TEST_CASE("without a kinetic drop the mass creeps into a swing that only just reaches the belt") {
  const auto rows = evaluate("stick_slip_oscillator",
                             {{1.0}, {100.0}, {10.0}, {0.3}, {0.3}, {0.05}, {0.0}, {0.05}, {0.0}},
                             {{0.0}, {0.6}, {0.6 + 0.05 * std::numbers::pi}, {7.0}});
  CHECK(rows[1][0] == Approx(0.03).epsilon(1e-12));
  CHECK(rows[2][0] == Approx(0.03 + 0.005).epsilon(1e-10));
  CHECK(std::abs(rows[3][0] - 0.03) <= 0.005 * (1.0 + 1e-9));
}

TEST_CASE("more phases than can be followed give no numbers, in the end") {
  // Phases of some 1e-21 s: none of them moves the time on.
  const auto rows = evaluate("stick_slip_oscillator",
                             {{1e-300}, {1.0}, {1e-20}, {0.4}, {0.3}, {1.0}, {0.0}, {0.0}, {0.0}},
                             {{0.0}, {1.0}, {2.0}});
  CHECK(std::isfinite(rows[0][0]));
  for (const double number : rows[2]) CHECK(std::isnan(number));
}

TEST_CASE("a mass that sticks at less than it slips is refused") {
  const std::vector<std::vector<double>> odd{{1.0}, {1.0}, {1.0}, {0.2},
                                             {0.3}, {1.0}, {0.0}, {0.0}};
  CHECK(stick_slip_oscillator::violation(odd).value() ==
        "static_coefficient must not be below kinetic_coefficient");
}
