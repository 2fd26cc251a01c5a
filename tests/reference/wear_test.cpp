// SPDX-License-Identifier: Apache-2.0
#include "reference/wear.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
