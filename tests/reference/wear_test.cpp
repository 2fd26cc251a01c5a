// SPDX-License-Identifier: Apache-2.0
#include "reference/wear.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference::wear;

namespace {
constexpr LinearWear kLinear{0.2, 1000.0, 100.0, 50.0};
constexpr ExponentialWear kExponential{0.2, 1000.0, 40.0, 100.0, 0.5};
}  // namespace

TEST_CASE("linear wear has the printed forces on first loading") {
  CHECK(snap_back_number(kLinear) == Approx(0.01).epsilon(1e-15));
  const auto slip = monotone(kLinear, 0.1);
  CHECK_THAT(slip.force, printed("19.1919191919192"));
  CHECK_THAT(slip.accumulated_slip, printed("0.0808080808080808"));
  CHECK_THAT(monotone(kLinear, 0.5).force, printed("15.1515151515152"));
  CHECK_THAT(monotone(kLinear, 1.0).force, printed("10.1010101010101"));
  CHECK(monotone(kLinear, 0.01).force == Approx(10.0).epsilon(1e-15));
  CHECK(monotone(kLinear, 0.01).accumulated_slip == 0.0);
  CHECK(std::isnan(monotone(LinearWear{0.2, 10.0, 100.0, 50.0}, 3.0).force));
}

TEST_CASE("linear wear in full cycles has the printed forces and total slip") {
  const char* forces[] = {"17.5594327109479", "15.8939667051084", "14.1948549213732",
                          "12.4614176470575", "10.6929614379072", "8.8887788406932",
                          "7.04814811020215", "5.17033292050927", "3.25458207041855",
                          "1.30012918295226"};
  const double first = monotone(kLinear, 0.1).force;
  const double b = snap_back_number(kLinear);
  double recursive = first;
  for (int n = 1; n <= 10; ++n) {
    CHECK_THAT(cyclic_force(kLinear, 0.1, first, n), printed(forces[n - 1]));
    recursive = (recursive * (1.0 + b) - 2.0 * 0.1 * 1000.0 * b) / (1.0 - b);
    // Ten steps of the recursion amplify its roundings a little.
    CHECK(cyclic_force(kLinear, 0.1, first, n) == Approx(recursive).epsilon(1e-12));
  }
  CHECK_THAT(slip_at_force(kLinear, cyclic_force(kLinear, 0.1, first, 10)),
             printed("1.86998708170477"));
}

TEST_CASE("exponential wear has the printed forces, slips and dissipation") {
  const double motions[] = {0.1, 0.5, 1.0};
  const char* forces[] = {"18.1887497853451", "12.5265485832812", "9.65569031465667"};
  const char* slips[] = {"0.0818112502146549", "0.487473451416719", "0.990344309685343"};
  for (int i = 0; i < 3; ++i) {
    const auto slip = monotone(kExponential, motions[i]);
    CHECK_THAT(slip.force, printed(forces[i]));
    CHECK_THAT(slip.accumulated_slip, printed(slips[i]));
    // k (u - s) loses as many digits as u is larger than f/k, about two.
    CHECK(1000.0 * (motions[i] - slip.accumulated_slip) == Approx(slip.force).epsilon(1e-12));
  }
  CHECK_THAT(monotone(kExponential, 3.0).force, printed("8.03022660152833"));
  CHECK_THAT(dissipation(kExponential, 1.0), printed("13.1879883005803"));
}

TEST_CASE("exponential wear sticks first and refuses a snap-back") {
  CHECK(monotone(kExponential, 0.02).force == Approx(20.0).epsilon(1e-15));
  CHECK(monotone(kExponential, 0.02).accumulated_slip == 0.0);
  // Continuous at the onset: one part in 1e9 further, the force has moved as little.
  CHECK(monotone(kExponential, 0.02 * (1.0 + 1e-9)).force == Approx(20.0).epsilon(1e-8));
  CHECK(std::isnan(monotone(ExponentialWear{0.2, 1000.0, 40.0, 100.0, 0.01}, 0.1).force));
}

TEST_CASE("wear only ever adds slip") {
  double before = -1.0;
  for (int i = 2; i < 200; ++i) {
    const double slip = monotone(kExponential, 0.02 * i).accumulated_slip;
    CHECK(slip > before);
    before = slip;
  }
}

namespace {

const std::vector<std::vector<double>> kLinearValues{{0.2}, {1000.0}, {100.0}, {50.0}};
const std::vector<std::vector<double>> kExponentialValues{{0.2}, {1000.0}, {100.0}, {40.0}, {0.5}};

}  // namespace

TEST_CASE("the path of linear wear has the printed forces, slips and cycles") {
  const auto first = evaluate("linear_wear", kLinearValues, {{0.0}, {0.01}, {0.1}, {0.5}, {1.0}});
  CHECK(first[1][0] == Approx(10.0).epsilon(1e-13));
  CHECK(first[1][2] == 0.0);
  CHECK_THAT(first[2][0], printed("19.1919191919192"));
  CHECK_THAT(first[2][2], printed("0.0808080808080808"));
  CHECK_THAT(first[3][0], printed("15.1515151515152"));
  CHECK_THAT(first[4][0], printed("10.1010101010101"));

  std::vector<std::vector<double>> path{{0.0}, {0.1}};
  for (int n = 1; n <= 10; ++n) path.push_back({n % 2 == 1 ? -0.1 : 0.1});
  const auto rows = evaluate("linear_wear", kLinearValues, path);
  for (int n = 0; n <= 10; ++n) {
    const double expected = cyclic_force(kLinear, 0.1, monotone(kLinear, 0.1).force, n);
    // Ten half cycles of roundings.
    CHECK(std::abs(rows[static_cast<std::size_t>(n) + 1][0]) == Approx(expected).epsilon(1e-12));
  }
  CHECK(rows.back()[2] == Approx(1.86998708170477).epsilon(1e-13));
  CHECK(rows.back()[1] == Approx(100.0 - 50.0 * 1.86998708170477).epsilon(1e-12));
}

TEST_CASE("linear wear ends where nothing is left") {
  const auto rows =
      evaluate("linear_wear", kLinearValues, {{0.0}, {1.9}, {2.5}, {3.0}, {1.0}, {-4.0}});
  // Up to u = F_0/c = 2 the limit goes down to nothing, from (0.02, 20 N).
  CHECK(rows[1][0] == Approx(0.2 * 5.0 / 0.99).epsilon(1e-11));
  for (std::size_t i = 2; i < rows.size(); ++i) {
    CHECK(rows[i][0] == 0.0);
    CHECK(rows[i][1] == 0.0);
    CHECK(rows[i][2] == Approx(2.0).epsilon(1e-14));
    CHECK(rows[i][3] == Approx(0.5 * 20.0 * 2.0).epsilon(1e-13));
    CHECK(rows[i][5] == Approx(20.0).epsilon(1e-13));
  }
}

TEST_CASE("the path of exponential wear has the printed forces, slips and dissipation") {
  const auto rows =
      evaluate("exponential_wear", kExponentialValues, {{0.0}, {0.1}, {0.5}, {1.0}, {3.0}});
  const char* forces[] = {"18.1887497853451", "12.5265485832812", "9.65569031465667",
                          "8.03022660152833"};
  const char* slips[] = {"0.0818112502146549", "0.487473451416719", "0.990344309685343"};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_THAT(rows[i + 1][0], printed(forces[i]));
    if (i < 3) CHECK_THAT(rows[i + 1][2], printed(slips[i]));
    CHECK(rows[i + 1][3] == Approx(dissipation(kExponential, rows[i + 1][2])).epsilon(1e-13));
  }
}

TEST_CASE("wearing sliders' work is the area under their force, and increments change nothing") {
  struct Fit {
    const char* name;
    const std::vector<std::vector<double>>& values;
  };
  for (const Fit& fit :
       {Fit{"linear_wear", kLinearValues}, Fit{"exponential_wear", kExponentialValues}}) {
    CAPTURE(fit.name);
    const std::vector<double> turns{0.0, 0.1, -0.06, -0.05, -0.3, 0.2};
    const int n = 4000;
    std::vector<std::vector<double>> coarse{{0.0}};
    std::vector<std::vector<double>> fine{{0.0}};
    for (std::size_t i = 1; i < turns.size(); ++i) {
      coarse.push_back({turns[i]});
      for (int j = 1; j <= n; ++j) {
        fine.push_back({turns[i - 1] + (turns[i] - turns[i - 1]) * j / n});
      }
    }
    const auto a = evaluate(fit.name, fit.values, coarse);
    const auto b = evaluate(fit.name, fit.values, fine);
    double area = 0.0;
    for (std::size_t i = 1; i < fine.size(); ++i) {
      area += 0.5 * (b[i][0] + b[i - 1][0]) * (fine[i][0] - fine[i - 1][0]);
      REQUIRE(b[i][2] >= b[i - 1][2]);
    }
    // Trapezoids over the kinks and the curve: second order in 1/4000.
    CHECK(a.back()[5] == Approx(area).epsilon(1e-6));
    // The roundings of 20000 increments add up.
    for (std::size_t i = 0; i < 6; ++i) CHECK(b.back()[i] == Approx(a.back()[i]).epsilon(1e-10));
    CHECK(a.back()[5] == Approx(a.back()[3] + a.back()[4]).epsilon(1e-12));
  }
}

TEST_CASE("wear that would snap back is refused") {
  const std::vector<std::vector<double>> linear{{0.2}, {10.0}, {100.0}, {50.0}};
  const std::vector<std::vector<double>> exponential{{0.2}, {1000.0}, {100.0}, {40.0}, {0.012}};
  CHECK(linear_violation(linear).value() ==
        "mu wear_rate must be below stick_stiffness, else the force snaps back where slip begins");
  CHECK(exponential_violation(exponential).has_value());
  CHECK_FALSE(exponential_violation(kExponentialValues).has_value());
}
