// SPDX-License-Identifier: Apache-2.0
#include "reference/segalman_iwan.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "reference/masing.hpp"
#include "reference/parallel_sliders.hpp"
#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {
constexpr segalman_iwan::Joint kJoint{5e6, -0.4, 1e-4, 2e6};
}

TEST_CASE("Segalman's Iwan model has its printed stiffness, forces and loop energy") {
  CHECK_THAT(segalman_iwan::initial_stiffness(kJoint), printed("2033175.59754612"));
  CHECK_THAT(segalman_iwan::slip_force(kJoint), printed("201.244084907980"));
  CHECK_THAT(segalman_iwan::backbone(kJoint, 0.5e-4), printed("100.974788261576"));
  CHECK_THAT(segalman_iwan::backbone(kJoint, -0.5e-4), printed("-100.974788261576"));
  CHECK_THAT(segalman_iwan::loop_energy(kJoint, 0.5e-4), printed("3.15688438029299e-5"));
  CHECK(segalman_iwan::backbone(kJoint, 1.0) == segalman_iwan::slip_force(kJoint));
}

TEST_CASE("the area of Segalman's Masing loop is its loop energy") {
  const double a = 0.5e-4;
  const auto backbone = [](double u) { return segalman_iwan::backbone(kJoint, u); };
  const int n = 20000;
  double area = 0.0;
  for (int i = 0; i < n; ++i) {
    const double u = -a + 2.0 * a * (i + 0.5) / n;
    const double up = masing::branch(backbone, -a, -backbone(a), u);
    const double down = masing::branch(backbone, a, backbone(a), u);
    area += (up - down) * 2.0 * a / n;
  }
  // The midpoint rule's error dominates.
  CHECK(area == Approx(segalman_iwan::loop_energy(kJoint, a)).epsilon(1e-6));
}

TEST_CASE(
    "Segalman's loop costs the whole slip force more for each motion beyond its largest yield") {
  const double whole = segalman_iwan::loop_energy(kJoint, 1e-4);
  const double beyond = segalman_iwan::loop_energy(kJoint, 1.5e-4);
  CHECK(beyond - whole == Approx(4.0 * 201.244084907980 * 0.5e-4).epsilon(1e-12));
  // Masing: E = 8 (area below the backbone) - 4 A F_b, at every amplitude.
  for (const double a : {0.2e-4, 0.5e-4, 1e-4, 1.5e-4}) {
    const double area = 8.0 * segalman_iwan::backbone_work(kJoint, a) -
                        4.0 * a * segalman_iwan::backbone(kJoint, a);
    // The two terms cancel to a few per cent.
    CHECK(segalman_iwan::loop_energy(kJoint, a) == Approx(area).epsilon(1e-10));
  }
}

TEST_CASE("Segalman's joint follows the sliders of its density on any path") {
  const int n = 3000;
  std::vector<double> stiffnesses{kJoint.end_stiffness};
  std::vector<double> limits{kJoint.end_stiffness * kJoint.maximum_motion};
  for (int i = 0; i < n; ++i) {
    // The share of the density between two yield motions, put where it yields on average.
    const auto moment = [&](double order, int j) {
      return kJoint.density * std::pow(kJoint.maximum_motion * j / n, order) / order;
    };
    stiffnesses.push_back(moment(0.6, i + 1) - moment(0.6, i));
    limits.push_back(moment(1.6, i + 1) - moment(1.6, i));
  }
  const std::vector<std::vector<double>> path{{0.0},     {0.8e-4},  {0.1e-4}, {0.5e-4},  {0.3e-4},
                                              {0.45e-4}, {-1.2e-4}, {0.0},    {-0.4e-4}, {1.4e-4}};
  const auto exact = evaluate("segalman_iwan", {{5e6}, {-0.4}, {1e-4}, {2e6}}, path);
  const auto sliders = evaluate("parallel_sliders", {stiffnesses, limits}, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    // The classes are finite; the first, where the density is infinite, dominates.
    CHECK(exact[i][0] == Approx(sliders[i][0]).epsilon(1e-5).margin(1e-3));
    CHECK(exact[i][1] == Approx(sliders[i][2]).epsilon(1e-4).margin(1e-9));
    CHECK(exact[i][2] == Approx(sliders[i][3]).epsilon(1e-4).margin(1e-9));
    CHECK(exact[i][3] == Approx(sliders[i][4]).epsilon(1e-4).margin(1e-9));
  }
}
