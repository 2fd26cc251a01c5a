// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/renard.hpp"
#include "reference/stiffness_penalty.hpp"
#include "reference/viscous_penalty.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using std::numbers::pi;

namespace {

constexpr double kDt = 1e-4;

double pulsating_normal_force(double time) {
  return 100.0 * (1.0 + 0.5 * std::sin(40.0 * pi * time));
}

/// Forces of the printed viscous history, filtered with `smoothing`; entry n is the n-th step.
std::vector<double> viscous_history(double smoothing, int steps) {
  std::vector<std::vector<double>> rows{{0.0, 1.0}};
  for (int n = 1; n <= steps; ++n) {
    const double time = n * kDt;
    const double normal_force = pulsating_normal_force(time);
    const double damping = evaluate("viscous_penalty_damping", {{1e-3}, {1.0}, {1.0}},
                                    {{5000.0 + normal_force}})[0][0];
    const double velocity = 100.0 * std::sin(100.0 * pi * time);
    const double force =
        evaluate("viscous_penalty", {{0.3}, {damping}}, {{velocity, normal_force}})[0][0];
    rows.push_back({force, normal_force});
  }
  std::vector<double> forces;
  for (const auto& row : evaluate("filtered_force", {{smoothing}}, rows)) forces.push_back(row[0]);
  return forces;
}

/// Forces of the printed incremental history with the given stiffness; entry n is the n-th step.
std::vector<double> stiffness_history(double stiffness, int steps) {
  std::vector<std::vector<double>> rows{{0.0, 0.0, 100.0, 0.3}};
  double motion = 0.0;
  for (int n = 1; n <= steps; ++n) {
    motion += kDt * 10.0 * std::sin(100.0 * pi * n * kDt);
    rows.push_back({motion, 0.0, pulsating_normal_force(n * kDt), 0.3});
  }
  std::vector<double> forces;
  for (const auto& row : evaluate("stiffness_penalty_increments", {{stiffness}}, rows)) {
    forces.push_back(row[0]);
  }
  return forces;
}

/// Rows of the printed path in the plane: velocity, motion and coefficient at each step.
struct PlaneRow {
  double velocity1, velocity2, motion1, motion2, mu;
};

std::vector<PlaneRow> plane_history(int steps) {
  const renard::Constants constants{.15, .10, .25, .05, 10.0, 100.0};
  std::vector<PlaneRow> rows{{0.0, 0.0, 0.0, 0.0, 0.15}};
  for (int n = 1; n <= steps; ++n) {
    const double time = n * kDt;
    PlaneRow row{};
    row.velocity1 = 200.0 * (time / 0.05) * std::cos(80.0 * pi * time);
    row.velocity2 = 120.0 * (time / 0.05) * std::sin(120.0 * pi * time);
    row.motion1 = rows.back().motion1 + row.velocity1 * kDt;
    row.motion2 = rows.back().motion2 + row.velocity2 * kDt;
    row.mu = renard::coefficient(constants, std::hypot(row.velocity1, row.velocity2)).value;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("viscous penalty friction is a damper up to the limit, odd and without memory") {
  const auto rows = evaluate("viscous_penalty", {{0.2}, {4.0}},
                             {{0.0, 100.0}, {2.0, 100.0}, {-2.0, 100.0}, {6.0, 100.0}, {3.0, 0.0}});
  CHECK(rows[0] == std::vector<double>{0.0, 5.0, 1.0});
  CHECK(rows[1] == std::vector<double>{8.0, 5.0, 1.0});
  CHECK(rows[2] == std::vector<double>{-8.0, 5.0, 1.0});
  CHECK(rows[3] == std::vector<double>{20.0, 5.0, 0.0});
  CHECK(rows[4] == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("viscous penalty friction in the plane has the direction of the velocity") {
  const auto rows =
      evaluate("viscous_penalty_plane", {{4.0}},
               {{3.0, -4.0, 100.0, 0.1}, {0.3, -0.4, 100.0, 0.1}, {0.0, 0.0, 100.0, 0.1}});
  CHECK(rows[0][0] == Approx(6.0).epsilon(1e-15));
  CHECK(rows[0][1] == Approx(-8.0).epsilon(1e-15));
  CHECK(rows[0][2] == Approx(10.0).epsilon(1e-15));
  CHECK(rows[1][0] == Approx(1.2).epsilon(1e-15));
  CHECK(rows[2] == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("the damping has the printed values, documented and as computed") {
  CHECK_THAT(evaluate("viscous_penalty_damping", {{1e-3}, {4.0}, {1.0}}, {{5100.0}})[0][0],
             printed("12.774975538137051"));
  CHECK_THAT(evaluate("viscous_penalty_damping", {{1e-3}, {4.0}, {0.5}}, {{5100.0}})[0][0],
             printed("6.3874877690685254"));
}

TEST_CASE("viscous penalty friction creeps at the load over the damping") {
  const auto rows =
      evaluate("viscous_penalty_creep", {{0.2}, {100.0}, {4.0}, {10.0}, {3.0}}, {{2.0}, {7.0}});
  CHECK(rows[0] == std::vector<double>{0.0, 0.0, 0.0});
  CHECK(rows[1] == std::vector<double>{10.0, 2.5, 100.0});
  CHECK(viscous_penalty::force(4.0, 20.0, rows[1][1]) == 10.0);
  const std::vector<std::vector<double>> slides{{0.2}, {100.0}, {4.0}, {-20.0}, {0.0}};
  CHECK(viscous_penalty::creep_violation(slides).value() ==
        "load must be below mu normal_force in magnitude, else there is no steady creep");
}

TEST_CASE("the filtered viscous history has the printed forces") {
  const auto tenth = viscous_history(0.1, 500);
  CHECK_THAT(tenth[1], printed("1.0032409893080816"));
  CHECK_THAT(tenth[10], printed("19.069107441169447"));
  CHECK_THAT(tenth[500], printed("22.771027271840186"));
  const auto period = viscous_history(2.0 * pi / 60.0, 500);
  CHECK_THAT(period[1], printed("1.0505915072634751"));
  CHECK_THAT(period[10], printed("19.630311234520690"));
  CHECK_THAT(period[500], printed("22.609100480237650"));
}

TEST_CASE("the incremental history has the printed forces") {
  const auto documented = stiffness_history(1e4, 500);
  CHECK_THAT(documented[1], printed(".31410759078128292"));
  CHECK_THAT(documented[10], printed("17.122998340917899"));
  CHECK_THAT(documented[100], printed("44.206474574921224"));
  CHECK_THAT(documented[500], printed("29.811509401749692"));
  // A filter of 0.1 as computed: a tenth of the stiffness.
  const auto computed = stiffness_history(1e3, 500);
  CHECK_THAT(computed[1], printed(".031410759078128292"));
  CHECK_THAT(computed[10], printed("1.7122998340917901"));
  CHECK_THAT(computed[100], printed("44.175209143415493"));
  CHECK_THAT(computed[500], printed("29.339690656855090"));
}

TEST_CASE("the path in the plane has the printed forces, viscous and incremental") {
  const auto path = plane_history(500);
  std::vector<std::vector<double>> rows;
  for (const auto& row : path) rows.push_back({row.motion1, row.motion2, 100.0, row.mu});
  const auto incremental = evaluate("stiffness_penalty_increments", {{1e4}}, rows);
  CHECK_THAT(incremental[50][0], printed("12.913254185916179"));
  CHECK_THAT(incremental[50][1], printed("21.331629210429373"));
  CHECK_THAT(incremental[500][0], printed("9.9900135851177918"));
  // The second component is a small difference: 1e-16 of the magnitude 10 remains of its digits.
  CHECK(incremental[500][1] == Approx(-.011285918482703687).margin(1e-13));

  const double damping = viscous_penalty::damping(1.0, 1.0, 5100.0, 1e-3);
  const auto viscous = evaluate("viscous_penalty_plane", {{damping}},
                                {{path[50].velocity1, path[50].velocity2, 100.0, path[50].mu}});
  CHECK_THAT(viscous[0][0], printed("11.874198073023681"));
  CHECK_THAT(viscous[0][1], printed("21.927014355901857"));
}

TEST_CASE("the incremental form follows the ramp exactly at any increment") {
  for (const int increments : {1, 3, 10, 1000}) {
    CAPTURE(increments);
    std::vector<std::vector<double>> times, motions;
    for (int n = 0; n <= increments; ++n) {
      const double time = 0.05 * n / increments;
      times.push_back({time});
      motions.push_back({-2.0 * time, 0.0, 100.0, 0.2});
    }
    const auto ramp =
        evaluate("stiffness_penalty_ramp", {{1000.0}, {0.2}, {100.0}, {-2.0}, {0.0}}, times);
    const auto rows = evaluate("stiffness_penalty_increments", {{1000.0}}, motions);
    for (std::size_t n = 0; n < times.size(); ++n) {
      // Rounding of up to 1000 sums.
      CHECK(rows[n][0] == Approx(ramp[n][0]).margin(1e-12));
      CHECK(rows[n][3] == Approx(ramp[n][2]).margin(1e-14));
      CHECK(rows[n][4] == Approx(ramp[n][3]).margin(1e-12));
    }
  }
}

TEST_CASE("the ramp turns all work into stored energy and dissipation") {
  const auto rows = evaluate("stiffness_penalty_ramp", {{1000.0}, {0.2}, {100.0}, {2.0}, {0.1}},
                             {{0.05}, {0.105}, {0.11}, {0.15}});
  CHECK(rows[0] == std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  CHECK(rows[1][0] == Approx(10.0).epsilon(1e-13));
  CHECK(rows[2][0] == Approx(20.0).epsilon(1e-13));
  CHECK(rows[3][0] == 20.0);
  CHECK(rows[3][1] == 0.02);
  // 0.1 of travel less 0.02 of stick.
  CHECK(rows[3][2] == Approx(0.08).epsilon(1e-13));
  CHECK(rows[3][5] == Approx(0.5 * 20.0 * 0.02 + 20.0 * 0.08).epsilon(1e-13));
}

TEST_CASE("incremental friction without normal force has forgotten its force") {
  const auto rows = evaluate("stiffness_penalty_increments", {{1000.0}},
                             {{0.0, 0.0, 100.0, 0.2},
                              {0.01, 0.0, 100.0, 0.2},
                              {0.01, 0.0, 0.0, 0.2},
                              {0.01, 0.0, 100.0, 0.2}});
  CHECK(rows[1][0] == Approx(10.0).epsilon(1e-15));
  CHECK(rows[2][2] == 0.0);
  CHECK(rows[3][2] == 0.0);
}
