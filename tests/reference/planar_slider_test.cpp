// SPDX-License-Identifier: Apache-2.0
#include "reference/planar_slider.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::planar_slider;
using std::numbers::pi;

namespace {

constexpr Slider kBase{1000.0, 20.0};
constexpr double kRadius = 0.05;
const std::vector<std::vector<double>> kBaseParameters{{0.2}, {100.0}, {1000.0}};
using Path = std::vector<std::vector<double>>;

// Exact formulas over some increments: their roundings add up.
Approx exact(double value) { return Approx(value).epsilon(1e-12).margin(1e-13); }

Path wandering_path() {
  Path path;
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.05 * i;
    path.push_back({0.06 * std::sin(t) + 0.02 * std::sin(4.3 * t), 0.05 * std::cos(1.7 * t)});
  }
  return path;
}

Path turned(const Path& path, double angle) {
  Path result;
  for (const auto& p : path) {
    result.push_back({std::cos(angle) * p[0] - std::sin(angle) * p[1],
                      std::sin(angle) * p[0] + std::cos(angle) * p[1]});
  }
  return result;
}

Path circle(int increments_per_turn, double turns) {
  Path path;
  const int n = static_cast<int>(std::lround(turns * increments_per_turn));
  for (int i = 0; i <= n; ++i) {
    const double p = 2.0 * pi * i / increments_per_turn;
    path.push_back({kRadius * (std::cos(p) - 1.0), kRadius * std::sin(p)});
  }
  return path;
}

}  // namespace

TEST_CASE("a planar slider on an L-shaped path has the printed forces") {
  const double legs[] = {0.005, 0.01, 0.02, 0.03, 0.05};
  const char* along[] = {"19.3908725828043", "17.7363776794015", "12.9610854732777",
                         "8.50192069884561", "3.26142463859956"};
  const char* across[] = {"4.89837324807418", "9.2423431452002", "15.2318831191153",
                          "18.1029650728973", "19.7322859630286"};
  Path path{{0.0, 0.0}, {0.05, 0.0}};
  for (const double w : legs) path.push_back({0.05, w});
  const auto rows = evaluate("planar_slider", kBaseParameters, path);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto corner = l_path(kBase, legs[i]);
    CHECK_THAT(corner.force.x, printed(along[i]));
    CHECK_THAT(corner.force.y, printed(across[i]));
    CHECK(rows[i + 2][0] == exact(corner.force.x));
    CHECK(rows[i + 2][1] == exact(corner.force.y));
    CHECK(rows[i + 2][2] == exact(20.0));
  }
  CHECK_THAT(0.03 + l_path(kBase, 0.05).slip, printed("0.0662713633585835"));
  CHECK(rows.back()[3] == exact(0.0662713633585835));
  CHECK(rows.back()[4] == exact(20.0 * 0.0662713633585835));
}

TEST_CASE("collinear rows change nothing for a planar slider") {
  Path fine{{0.0, 0.0}};
  for (int i = 1; i <= 40; ++i) fine.push_back({0.05 * i / 40, 0.0});
  for (int i = 1; i <= 40; ++i) fine.push_back({0.05, 0.05 * i / 40});
  const auto row = evaluate("planar_slider", kBaseParameters, fine).back();
  CHECK(row[0] == exact(3.26142463859956));
  CHECK(row[1] == exact(19.7322859630286));
  CHECK(row[3] == exact(0.0662713633585835));
}

TEST_CASE("a planar slider's steady circle has the printed lag, forces and energy") {
  const auto steady = steady_circle(kBase, kRadius);
  CHECK_THAT(steady.lag, printed("0.411516846067488"));
  CHECK_THAT(steady.tangential_force, printed("18.3303027798234"));
  CHECK(steady.radial_force == exact(8.0));
  CHECK_THAT(steady.slip_per_turn, printed("0.287931722755848"));
  CHECK_THAT(steady.energy_per_turn, printed("5.75863445511696"));
  CHECK(steady_circle(kBase, 0.02).energy_per_turn == 0.0);
  CHECK(steady_circle(kBase, 0.015).radial_force == exact(15.0));
}

TEST_CASE("backward Euler on a circle settles to the printed discrete lag and slip") {
  const int counts[] = {12, 36, 100, 200, 360};
  const char* lags[] = {"0.658492453662131", "0.497123139440017", "0.442717428009306",
                        "0.42717096796885", "0.420226874250516"};
  const char* slips[] = {"0.25431024697805", "0.276835951751279", "0.283964868953003",
                         "0.285952888857469", "0.28683356157622"};
  for (std::size_t i = 0; i < 5; ++i) {
    const auto discrete = discrete_circle(kBase, kRadius, counts[i]);
    CHECK_THAT(discrete.lag, printed(lags[i]));
    CHECK_THAT(discrete.slip_per_turn, printed(slips[i]));

    // The radial return itself, over eight turns; its transient has died out to below 1e-10 then.
    const auto path = circle(counts[i], 8.0);
    Vector force;
    double slip = 0.0;
    for (std::size_t j = 1; j < path.size(); ++j) {
      force.x += 1000.0 * (path[j][0] - path[j - 1][0]);
      force.y += 1000.0 * (path[j][1] - path[j - 1][1]);
      const double magnitude = std::hypot(force.x, force.y);
      if (magnitude <= 20.0) continue;
      force.x *= 20.0 / magnitude;
      force.y *= 20.0 / magnitude;
      if (j + static_cast<std::size_t>(counts[i]) >= path.size()) slip += (magnitude - 20.0) / 1000;
    }
    CHECK(0.5 * pi - std::atan2(force.y, force.x) == Approx(discrete.lag).epsilon(1e-10));
    CHECK(slip == Approx(discrete.slip_per_turn).epsilon(1e-10));
  }
  CHECK(std::isnan(discrete_circle(kBase, 0.01, 36).lag));
}

TEST_CASE("a circle from rest first slips at the printed angle and force") {
  const double onset = circle_onset(kBase, kRadius);
  CHECK_THAT(onset, printed("0.402715841580662"));
  const auto force = circle_transient(kBase, kRadius, onset);
  CHECK(force.x == exact(-4.0));
  CHECK_THAT(force.y, printed("19.5959179422654"));
}

TEST_CASE("a circle from rest has the printed transient forces") {
  const double angles[] = {0.5, 1.0, 1.5, 3.0, 2.0 * pi};
  const char* x[] = {"-5.0515933352531", "-11.9498216301407", "-17.8680312093375",
                     "-10.4977775142714", "7.99999479814735"};
  const char* y[] = {"19.3515220273555", "16.0375111226094", "8.98518005952813",
                     "-17.0234152643016", "18.3303050500971"};
  for (int i = 0; i < 5; ++i) {
    const auto force = circle_transient(kBase, kRadius, angles[i]);
    CHECK_THAT(force.x, printed(x[i]));
    CHECK_THAT(force.y, printed(y[i]));
  }
  const auto sticking = circle_transient(kBase, kRadius, 0.2);
  CHECK(sticking.x == exact(50.0 * (std::cos(0.2) - 1.0)));
  CHECK(sticking.y == exact(50.0 * std::sin(0.2)));
  CHECK(std::isnan(circle_transient(kBase, 0.02, 1.0).x));
}

TEST_CASE("a planar slider on chords approaches the circle with second order") {
  const auto worst = [](int n) {
    const auto path = circle(n, 2.0);
    const auto rows = evaluate("planar_slider", kBaseParameters, path);
    double error = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto exact_force =
          circle_transient(kBase, kRadius, 2.0 * pi * static_cast<double>(i) / n);
      error = std::max(error, std::hypot(rows[i][0] - exact_force.x, rows[i][1] - exact_force.y));
    }
    return error;
  };
  const double coarse = worst(120);
  CHECK_THAT(coarse, printed("0.0125"));
  // The next order of the step makes the ratio differ from 4.
  CHECK(coarse / worst(240) == Approx(4.0).epsilon(0.05));
}

TEST_CASE("a planar slider on a straight line is the Coulomb slider") {
  const double angle = 0.83;
  const std::vector<double> turns{0.0, 0.05, 0.015, -0.08, 0.1, 0.1, 0.08};
  Path line;
  Path plane;
  for (const double u : turns) {
    line.push_back({u});
    plane.push_back({u * std::cos(angle), u * std::sin(angle)});
  }
  const auto one = evaluate("coulomb_slider", {{0.2}, {100.0}, {1000.0}, {1e300}}, line);
  const auto two = evaluate("planar_slider", kBaseParameters, plane);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    CHECK(two[i][0] == exact(one[i][0] * std::cos(angle)));
    CHECK(two[i][1] == exact(one[i][0] * std::sin(angle)));
    CHECK(two[i][3] == exact(one[i][1]));
    CHECK(two[i][4] == exact(one[i][2]));
  }
}

TEST_CASE("a planar slider turns and mirrors with its path") {
  const auto path = wandering_path();
  const auto rows = evaluate("planar_slider", kBaseParameters, path);
  const double angle = 1.234;
  const auto turned_rows = evaluate("planar_slider", kBaseParameters, turned(path, angle));
  Path mirrored = path;
  for (auto& p : mirrored) p[0] = -p[0];
  const auto mirrored_rows = evaluate("planar_slider", kBaseParameters, mirrored);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const auto& turn = turned_rows[i];
    CHECK(turn[0] == exact(std::cos(angle) * row[0] - std::sin(angle) * row[1]));
    CHECK(turn[1] == exact(std::sin(angle) * row[0] + std::cos(angle) * row[1]));
    CHECK(turn[3] == exact(row[3]));
    CHECK(turn[4] == exact(row[4]));
    CHECK(mirrored_rows[i][0] == exact(-row[0]));
    CHECK(mirrored_rows[i][1] == exact(row[1]));
    CHECK(mirrored_rows[i][3] == exact(row[3]));
  }
  CHECK(rows.back()[3] > 0.5);
}

TEST_CASE("a planar slider's work is its dissipation and its stored energy") {
  const auto corners = wandering_path();
  Path fine{corners[0]};
  const int pieces = 100;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (int j = 1; j <= pieces; ++j) {
      const double c = static_cast<double>(j) / pieces;
      fine.push_back({corners[i - 1][0] + c * (corners[i][0] - corners[i - 1][0]),
                      corners[i - 1][1] + c * (corners[i][1] - corners[i - 1][1])});
    }
  }
  const auto rows = evaluate("planar_slider", kBaseParameters, fine);
  double work = 0.0;
  for (std::size_t i = 1; i < fine.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      work += 0.5 * (rows[i][c] + rows[i - 1][c]) * (fine[i][c] - fine[i - 1][c]);
    }
    CHECK(rows[i][2] <= 20.0 * (1.0 + 1e-12));
    CHECK(rows[i][3] >= rows[i - 1][3]);
  }
  const auto& last = rows.back();
  // The trapezoid rule's error in the work dominates.
  CHECK(work == Approx(last[4] + last[2] * last[2] / 2000.0).epsilon(1e-6));
}

TEST_CASE("a planar slider without a limit neither resists nor slips") {
  for (const auto& row : evaluate("planar_slider", {{0.2}, {0.0}, {1000.0}}, wandering_path())) {
    CHECK(row == std::vector<double>(5, 0.0));
  }
}

TEST_CASE("a shaft in helical slip has the printed force, moment and power") {
  const auto helix = planar_slider::helical_slip(105.0, 0.24, 0.3, 1.25);
  CHECK_THAT(helix.force, printed("74.2462120245875"));
  CHECK_THAT(helix.moment, printed("17.819090885901"));
  CHECK_THAT(helix.power, printed("44.5477272147525"));
  CHECK_THAT(helix.slip_rate, printed("0.424264068711929"));
  CHECK(shaft_force(helix.force, helix.moment, 0.24) == exact(105.0));
  CHECK_THAT(shaft_force(10.0, 3.0, 0.24), printed("16.0078"));

  // The planar slider in (u1, R ur1) settles to the same answer.
  const auto row = evaluate("planar_slider", {{0.15}, {700.0}, {1e6}}, {{0, 0}, {0.3, 0.3}}).back();
  CHECK(row[0] == exact(helix.force));
  CHECK(row[1] * 0.24 == exact(helix.moment));
}
