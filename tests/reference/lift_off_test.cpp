// SPDX-License-Identifier: Apache-2.0
#include "reference/lift_off.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

namespace {

constexpr lift_off::Slider kSlider{0.2, 1000.0};
constexpr lift_off::Contact kContact{30.0, 500.0};
const std::vector<std::vector<double>> kParameters{{0.2}, {1000.0}, {30.0}, {500.0}};

// Exact formulas over a few increments: only rounding separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-12).margin(1e-13); }

}  // namespace

TEST_CASE("a contact that parts makes a triangle") {
  // d = 0.16, mu g = 100, q = 900/1100.
  const auto loop = lift_off::loop(kSlider, kContact, 0.1).value();
  CHECK(loop.contact_motion == exact(-0.06));
  CHECK(loop.top_force == exact(16.0));
  CHECK(loop.backward_onset == exact(-0.06 + 0.16 * 9.0 / 11.0));
  CHECK(loop.backward_force == exact(-16.0 * 9.0 / 11.0));
  CHECK(loop.energy == exact(100.0 * 9.0 / 11.0 * 0.16 * 0.16));
}

TEST_CASE("the path of a contact that parts runs through the triangle whatever the rows") {
  const auto loop = lift_off::loop(kSlider, kContact, 0.1).value();
  const auto rows = evaluate(
      "lift_off", kParameters,
      {{0.0}, {0.1}, {-0.1}, {0.1}, {loop.backward_onset}, {-0.1}, {-0.06}, {0.02}, {0.1}});
  CHECK(rows[1][0] == exact(16.0));
  CHECK(rows[2][0] == 0.0);
  CHECK(rows[2][1] == 0.0);
  CHECK(rows[3][0] == exact(16.0));
  CHECK(rows[4][0] == exact(loop.backward_force));
  CHECK(rows[4][2] == exact(rows[3][2]));
  CHECK(rows[6][0] == 0.0);
  CHECK(rows[7][0] == exact(8.0));
  CHECK(rows[8][3] - rows[3][3] == exact(loop.energy));
  for (const auto& row : rows) CHECK(row[5] == exact(row[3] + row[4]));
}

TEST_CASE("after lift-off friction restarts from zero where the bodies meet") {
  // N falls to nothing at u = 0.2 and comes back: the spring is counted from there.
  const std::vector<std::vector<double>> steep{{10.0}, {1000.0}, {100.0}, {-500.0}};
  const auto rows =
      evaluate("lift_off", steep, {{0.0}, {0.15}, {0.5}, {0.4}, {0.2}, {0.19}, {0.1}});
  CHECK(rows[1][0] == exact(150.0));
  CHECK(rows[2][0] == 0.0);
  CHECK(rows[3][0] == 0.0);
  CHECK(rows[4][0] == 0.0);
  // mu |g| > k: the growing normal force holds it, so f = k (u - 0.2).
  CHECK(rows[5][0] == exact(-10.0));
  CHECK(rows[6][0] == exact(-100.0));
}

TEST_CASE("a contact that never parts is the normal force in phase") {
  const auto loop = varying_normal_force::in_phase_loop(kSlider, 100.0, 500.0, 0.1).value();
  const auto rows = evaluate("lift_off", {{0.2}, {1000.0}, {100.0}, {500.0}},
                             {{0.0}, {0.1}, {-0.1}, {0.1}, {-0.1}});
  CHECK(rows[3][3] - rows[1][3] == exact(loop.energy));
  CHECK(rows[4][0] == exact(-10.0));
  CHECK_FALSE(lift_off::loop(kSlider, {100.0, 500.0}, 0.1).has_value());
  CHECK_FALSE(lift_off::loop({0.2, 100.0}, kContact, 0.1).has_value());
  CHECK_FALSE(lift_off::loop(kSlider, {-60.0, 500.0}, 0.1).has_value());
}

TEST_CASE("a gap closes before there is friction") {
  const auto rows =
      evaluate("lift_off", {{0.2}, {1000.0}, {-10.0}, {500.0}}, {{0.0}, {0.02}, {0.03}});
  CHECK(rows[1][0] == 0.0);
  CHECK(rows[2][1] == exact(5.0));
  CHECK(rows[2][0] == exact(1.0));
}
