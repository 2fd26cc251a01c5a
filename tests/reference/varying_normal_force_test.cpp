// SPDX-License-Identifier: Apache-2.0
#include "reference/varying_normal_force.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::varying_normal_force;
using std::numbers::pi;

namespace {

constexpr Slider kBase{0.2, 1000.0};
constexpr Quadrature kQuadrature{0.1, 100.0, 0.5};
const std::vector<std::vector<double>> kBaseParameters{{0.2}, {1000.0}};

// Exact formulas over a few increments: only rounding separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-12).margin(1e-13); }

}  // namespace

TEST_CASE("a normal force in phase makes the printed quadrilateral") {
  const auto loop = in_phase_loop(kBase, 100.0, 500.0, 0.1).value();
  CHECK(loop.top_force == exact(30.0));
  CHECK_THAT(loop.backward_onset, printed("0.0454545454545455"));
  CHECK_THAT(loop.backward_force, printed("-24.5454545454545"));
  CHECK(loop.bottom_force == exact(-10.0));
  CHECK_THAT(loop.forward_onset, printed("-0.0777777777777778"));
  CHECK_THAT(loop.forward_force, printed("12.2222222222222"));
  CHECK_THAT(loop.energy, printed("6.14141414141414"));
  CHECK(loop.energy == exact(608.0 / 99.0));
}

TEST_CASE("the path of a normal force in phase runs through the quadrilateral's corners") {
  const auto loop = in_phase_loop(kBase, 100.0, 500.0, 0.1).value();
  std::vector<std::vector<double>> path;
  for (const double u : {0.0, 0.1, -0.1, 0.1, loop.backward_onset, -0.1, loop.forward_onset, 0.1}) {
    path.push_back({u, 100.0 + 500.0 * u});
  }
  const auto rows = evaluate("varying_normal_force", kBaseParameters, path);
  CHECK(rows[3][0] == exact(loop.top_force));
  CHECK(rows[4][0] == exact(loop.backward_force));
  CHECK(rows[5][0] == exact(loop.bottom_force));
  CHECK(rows[6][0] == exact(loop.forward_force));
  CHECK(rows[7][0] == exact(loop.top_force));
  CHECK(rows[4][1] == exact(rows[3][1]));
  CHECK(rows[7][2] - rows[3][2] == exact(608.0 / 99.0));
  for (const auto& row : rows) CHECK(row[4] == exact(row[2] + row[3]));
}

TEST_CASE("a normal force that grows faster than the stick force wedges") {
  CHECK_FALSE(in_phase_loop({0.2, 100.0}, 100.0, 500.0, 0.1).has_value());
  CHECK_FALSE(in_phase_loop(kBase, 100.0, 500.0, 0.01).has_value());
  CHECK_FALSE(in_phase_loop(kBase, 100.0, 1500.0, 0.1).has_value());
  const auto rows = evaluate("varying_normal_force", {{0.2}, {100.0}}, {{0, 100}, {1, 600}});
  CHECK(rows[1][0] == exact(100.0));
  CHECK(rows[1][1] == 0.0);
}

TEST_CASE("a normal force in quadrature has the printed events") {
  const auto events = quadrature_events(kBase, kQuadrature, 7);
  REQUIRE(events.size() == 7);
  const EventKind kinds[] = {
      EventKind::kForwardSlip, EventKind::kStick, EventKind::kBackwardSlip, EventKind::kStick,
      EventKind::kForwardSlip, EventKind::kStick, EventKind::kBackwardSlip};
  const char* phases[] = {"0.100676343536990", "1.471127674303735", "2.595276476514401",
                          "4.812057632875852", "5.537531825121870", "7.754312981483321",
                          "8.878461783693987"};
  const char* motions[] = {"0.0100506358398058", "0.0995037190209989", "0.0519543140082739",
                           "-0.0995037190209989", "-0.0678452032416447"};
  const char* forces[] = {"10.0506358398058", "19.0049628097900", "-28.5444422029350",
                          "-19.0049628097900", "12.6535529695642"};
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(events[i].kind == kinds[i]);
    CHECK_THAT(events[i].phase, printed(phases[i]));
    if (i >= 5) continue;
    CHECK_THAT(events[i].motion, printed(motions[i]));
    CHECK_THAT(events[i].force, printed(forces[i]));
  }
}

TEST_CASE("a normal force in quadrature dissipates the printed energy a period") {
  const auto events = quadrature_events(kBase, kQuadrature, 8);
  const double forward =
      quadrature_slip_energy(kBase, kQuadrature, 1.0, events[4].phase, events[5].phase);
  const double backward =
      quadrature_slip_energy(kBase, kQuadrature, -1.0, events[6].phase, events[7].phase);
  CHECK_THAT(forward, printed("1.83933421631118"));
  CHECK_THAT(backward, printed("4.53680488952714"));
  CHECK_THAT(forward + backward, printed("6.37613910583832"));
}

TEST_CASE("fine pieces approach the loop of a normal force in quadrature") {
  const std::size_t n = 20000;
  std::vector<std::vector<double>> path;
  for (std::size_t i = 0; i <= 3 * n; ++i) {
    const double p = 2.0 * pi * static_cast<double>(i) / static_cast<double>(n);
    path.push_back({0.1 * std::sin(p), 100.0 * (1.0 - 0.5 * std::cos(p))});
  }
  const auto rows = evaluate("varying_normal_force", kBaseParameters, path);
  // Chords instead of arcs: second order in the piece, about (2 pi/20000)^2.
  CHECK(rows[3 * n][2] - rows[2 * n][2] == Approx(6.37613910583832).epsilon(1e-6));
  CHECK(rows[3 * n][4] == Approx(rows[3 * n][2] + rows[3 * n][3]).epsilon(1e-10));
}

TEST_CASE("motion too small for the modulated normal force never slips") {
  CHECK(quadrature_events(kBase, {0.01, 100.0, 0.5}, 5).empty());
}

TEST_CASE("a normal force that falls at rest lets the contact slip back") {
  const auto fall = unload_normal_force(kBase, 15.0, 25.0);
  CHECK(fall.force == exact(5.0));
  CHECK(fall.slip == exact(0.010));
  CHECK(fall.dissipation == exact(0.1));
  CHECK(unload_normal_force(kBase, -15.0, 25.0).force == exact(-5.0));
  CHECK(unload_normal_force(kBase, 15.0, 80.0).slip == 0.0);

  for (const int n : {1, 7}) {
    std::vector<std::vector<double>> path{{0.0, 100.0}, {0.015, 100.0}};
    for (int i = 1; i <= n; ++i) path.push_back({0.015, 100.0 - 75.0 * i / n});
    path.push_back({0.015, 150.0});
    const auto row = evaluate("varying_normal_force", kBaseParameters, path).back();
    CHECK(row[0] == exact(5.0));
    CHECK(row[1] == exact(0.010));
    CHECK(row[2] == exact(0.1));
  }
}

TEST_CASE("lift-off clears the force and contact starts again from the motion it meets") {
  const auto rows = evaluate("varying_normal_force", kBaseParameters,
                             {{0.0, 100.0},
                              {0.015, 100.0},
                              {0.015, 0.0},
                              {0.5, 0.0},
                              {0.5, 100.0},
                              {0.51, 100.0},
                              {0.6, 100.0}});
  CHECK(rows[2][0] == 0.0);
  CHECK(rows[3][0] == 0.0);
  CHECK(rows[3][1] == rows[2][1]);
  CHECK(rows[4][0] == 0.0);
  CHECK(rows[5][0] == exact(10.0));
  CHECK(rows[6][0] == exact(20.0));
}

TEST_CASE("a constant normal force gives the Coulomb slider") {
  std::vector<std::vector<double>> line;
  std::vector<std::vector<double>> pair;
  for (const double u : {0.0, 0.05, 0.015, -0.08, 0.1, 0.1, 0.08}) {
    line.push_back({u});
    pair.push_back({u, 100.0});
  }
  const auto one = evaluate("coulomb_slider", {{0.2}, {100.0}, {1000.0}, {1e300}}, line);
  const auto two = evaluate("varying_normal_force", kBaseParameters, pair);
  for (std::size_t i = 0; i < line.size(); ++i) {
    for (std::size_t j = 0; j < 5; ++j) CHECK(two[i][j] == exact(one[i][j]));
  }
}

TEST_CASE("a negative normal force has no answer") {
  const auto rows = evaluate("varying_normal_force", kBaseParameters, {{0, 100}, {0, -1}, {0, 5}});
  CHECK(std::isnan(rows[1][0]));
  CHECK(std::isnan(rows[2][1]));
}

TEST_CASE("the closed form of a normal force in quadrature runs through its events") {
  const std::vector<std::vector<double>> values{{0.2}, {1000.0},   {0.1}, {100.0},
                                                {0.5}, {2.0 * pi}, {0.0}};
  std::vector<std::vector<double>> path;
  for (const Event& event : quadrature_events(kBase, kQuadrature, 7)) path.push_back({event.phase});
  const auto rows = evaluate("quadrature_normal_force", values, path);
  const char* forces[] = {"10.0506358398058", "19.0049628097900", "-28.5444422029350",
                          "-19.0049628097900", "12.6535529695642"};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK_THAT(rows[i][0], printed(forces[i]));
    CHECK(std::abs(rows[i][0]) == exact(0.2 * rows[i][2]));
  }
  const auto periods = evaluate("quadrature_normal_force", values,
                                {{0.0}, {pi}, {2.0 * pi}, {4.0 * pi}, {60.0 * pi}, {2e9 * pi}});
  CHECK(periods[0] == std::vector<double>{0.0, 0.0, 50.0, 0.0, 0.0});
  CHECK_THAT(periods[3][4] - periods[2][4], printed("6.37613910583832"));
  // Thirty periods' roundings.
  CHECK(periods[4][4] - periods[2][4] == Approx(29.0 * 6.37613910583832).epsilon(1e-12));
  // A billion periods are not walked through.
  CHECK(periods[5][4] - periods[2][4] == Approx((1e9 - 1.0) * 6.37613910583832).epsilon(1e-12));
}

TEST_CASE("fine pieces approach the closed form of a normal force in quadrature everywhere") {
  const int n = 4000;
  std::vector<std::vector<double>> phases;
  std::vector<std::vector<double>> path;
  for (int i = 0; i <= 3 * n; ++i) {
    const double p = 2.0 * pi * i / n;
    phases.push_back({p});
    path.push_back({0.1 * std::sin(p), 100.0 * (1.0 - 0.5 * std::cos(p))});
  }
  const auto closed = evaluate("quadrature_normal_force",
                               {{0.2}, {1000.0}, {0.1}, {100.0}, {0.5}, {2.0 * pi}, {0.0}}, phases);
  const auto pieces = evaluate("varying_normal_force", kBaseParameters, path);
  for (std::size_t i = 0; i < path.size(); i += 37) {
    // Chords instead of arcs: (2 pi/4000)^2 of the forces k A = 100 N, slips 0.1 mm and energies.
    CHECK(closed[i][0] == Approx(pieces[i][0]).margin(2e-4));
    CHECK(closed[i][3] == Approx(pieces[i][1]).margin(2e-6));
    CHECK(closed[i][4] == Approx(pieces[i][2]).margin(5e-5));
  }
}

TEST_CASE("motion too small for a normal force in quadrature stays a spring") {
  const auto rows =
      evaluate("quadrature_normal_force", {{0.2}, {1000.0}, {0.01}, {100.0}, {0.5}, {0.25}, {3.0}},
               {{0.0}, {3.0}, {5.5 + 0.25 / 8.0}});
  CHECK(rows[0] == rows[1]);
  CHECK(rows[2][0] == exact(10.0 * std::sin(0.25 * pi)));
  CHECK(rows[2][3] == 0.0);
  const std::vector<std::vector<double>> lifted{{0.2}, {1000.0}, {0.1}, {100.0},
                                                {1.0}, {1.0},    {0.0}};
  CHECK(quadrature_violation(lifted).has_value());
}
