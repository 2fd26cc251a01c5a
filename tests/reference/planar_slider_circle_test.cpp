// SPDX-License-Identifier: Apache-2.0
#include "reference/planar_slider_circle.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::planar_slider_circle;
using std::numbers::pi;

namespace {

const std::vector<std::vector<double>> kBase{{0.2}, {100.0}, {1000.0}, {0.05}};

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-13); }

std::vector<double> at_phase(double phase) { return evaluate(kForm, kBase, {{phase}}).back(); }

}  // namespace

TEST_CASE("a circle from rest gives the printed forces at any phase") {
  const double phases[] = {0.5, 1.0, 1.5, 3.0, 2.0 * pi};
  const char* x[] = {"-5.0515933352531", "-11.9498216301407", "-17.8680312093375",
                     "-10.4977775142714", "7.99999479814735"};
  const char* y[] = {"19.3515220273555", "16.0375111226094", "8.98518005952813",
                     "-17.0234152643016", "18.3303050500971"};
  for (std::size_t i = 0; i < 5; ++i) {
    const auto row = at_phase(phases[i]);
    CHECK_THAT(row[0], printed(x[i]));
    CHECK_THAT(row[1], printed(y[i]));
    CHECK(row[2] == exact(20.0));
    CHECK(row[4] == exact(20.0 * row[3]));
  }
  const auto onset = at_phase(0.402715841580662);
  CHECK(onset[0] == Approx(-4.0).epsilon(1e-12));
  CHECK(onset[1] == Approx(19.5959179422654).epsilon(1e-12));
  CHECK(at_phase(0.0) == std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, at_phase(0.0)[6],
                                             at_phase(0.0)[7], at_phase(0.0)[8], at_phase(0.0)[9]});
}

TEST_CASE("a circle from rest slips as its equation says") {
  // d psi/dp = 1 - a0 sin(psi), ds/dp = R cos(psi), by Runge and Kutta from the onset.
  const double onset = 0.402715841580662;
  const auto turn = [](double psi) { return 1.0 - 2.5 * std::sin(psi); };
  double psi = 0.5 * onset;
  double slip = 0.0;
  const int n = 400;
  const double end = 2.0;
  const double h = (end - onset) / n;
  for (int i = 0; i < n; ++i) {
    const double k1 = turn(psi);
    const double k2 = turn(psi + 0.5 * h * k1);
    const double k3 = turn(psi + 0.5 * h * k2);
    const double k4 = turn(psi + h * k3);
    slip += h / 6.0 * 0.05 *
            (std::cos(psi) + 2.0 * std::cos(psi + 0.5 * h * k1) +
             2.0 * std::cos(psi + 0.5 * h * k2) + std::cos(psi + h * k3));
    psi += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  const auto row = at_phase(end);
  // The method's fourth-order error dominates.
  CHECK(row[5] == Approx(psi).epsilon(1e-10));
  CHECK(row[3] == Approx(slip).epsilon(1e-10));
}

TEST_CASE("a circle's work from rest is its dissipation and stored energy") {
  const int n = 20000;
  double work = 0.0;
  std::vector<double> last = at_phase(0.0);
  for (int i = 1; i <= n; ++i) {
    const double p = 8.0 * i / n;
    const double before = 8.0 * (i - 1) / n;
    const auto row = at_phase(p);
    work += 0.5 * (row[0] + last[0]) * 0.05 * (std::cos(p) - std::cos(before)) +
            0.5 * (row[1] + last[1]) * 0.05 * (std::sin(p) - std::sin(before));
    last = row;
  }
  // The trapezoid rule's error dominates.
  CHECK(work == Approx(last[4] + last[2] * last[2] / 2000.0).epsilon(1e-6));
}

TEST_CASE("a circle from rest becomes the steady circle") {
  const auto late = at_phase(12.0 * pi);
  const auto next = at_phase(14.0 * pi);
  CHECK(late[0] == Approx(8.0).epsilon(1e-12));
  CHECK(late[1] == Approx(18.3303027798234).epsilon(1e-12));
  CHECK(late[0] == Approx(late[6]).epsilon(1e-12));
  CHECK(late[1] == Approx(late[7]).epsilon(1e-12));
  CHECK(late[5] == Approx(0.411516846067488).epsilon(1e-12));
  CHECK(next[3] - late[3] == Approx(0.287931722755848).epsilon(1e-12));
  CHECK(next[4] - late[4] == Approx(5.75863445511696).epsilon(1e-12));
  CHECK_THAT(late[8], printed("0.287931722755848"));
  CHECK_THAT(late[9], printed("5.75863445511696"));
}

TEST_CASE("backward Euler misses the force on a circle by the printed amount") {
  const int n = 120;
  double worst = 0.0;
  Vector force;
  for (int i = 1; i <= 2 * n; ++i) {
    const double p = 2.0 * pi * i / n;
    const double before = 2.0 * pi * (i - 1) / n;
    force.x += 50.0 * (std::cos(p) - std::cos(before));
    force.y += 50.0 * (std::sin(p) - std::sin(before));
    const double magnitude = std::max(std::hypot(force.x, force.y), 20.0);
    force.x *= 20.0 / magnitude;
    force.y *= 20.0 / magnitude;
    const auto row = at_phase(p);
    worst = std::max(worst, std::hypot(force.x - row[0], force.y - row[1]));
  }
  CHECK_THAT(worst, printed("0.52"));
}

TEST_CASE("a circle too small to slip steadily is refused") {
  auto small = kBase;
  small[3] = {0.02};
  CHECK(kForm.violation(small).has_value());
  small.push_back({36.0});
  CHECK(kIncrementsForm.violation(small).has_value());
}

TEST_CASE("backward Euler on a circle has the printed lags and slips in the catalogue's entry") {
  const double counts[] = {12, 36, 100, 200, 360};
  const char* lags[] = {"0.658492453662131", "0.497123139440017", "0.442717428009306",
                        "0.42717096796885", "0.420226874250516"};
  const char* slips[] = {"0.25431024697805", "0.276835951751279", "0.283964868953003",
                         "0.285952888857469", "0.28683356157622"};
  for (std::size_t i = 0; i < 5; ++i) {
    auto parameters = kBase;
    parameters.push_back({counts[i]});
    const auto rows = evaluate(kIncrementsForm, parameters, {{0.0}, {0.5 * pi}});
    CHECK_THAT(rows[0][2], printed(lags[i]));
    CHECK_THAT(rows[0][4], printed(slips[i]));
    CHECK(rows[0][3] == exact(rows[0][4] / counts[i]));
    CHECK(rows[0][5] == exact(20.0 * rows[0][4]));
    CHECK(rows[0][0] == exact(20.0 * std::sin(rows[0][2])));
    CHECK(rows[0][1] == exact(20.0 * std::cos(rows[0][2])));
    CHECK(rows[1][0] == exact(-rows[0][1]));
    CHECK(rows[1][1] == exact(rows[0][0]));
  }
  auto fraction = kBase;
  fraction.push_back({36.5});
  CHECK(kIncrementsForm.violation(fraction).has_value());
}
