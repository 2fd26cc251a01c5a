// SPDX-License-Identifier: Apache-2.0
#include "reference/segalman_iwan.hpp"

#include <catch2/catch.hpp>

#include "reference/parallel_sliders.hpp"
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
    const double up = parallel_sliders::masing_branch(backbone, -a, -backbone(a), u);
    const double down = parallel_sliders::masing_branch(backbone, a, backbone(a), u);
    area += (up - down) * 2.0 * a / n;
  }
  // The midpoint rule's error dominates.
  CHECK(area == Approx(segalman_iwan::loop_energy(kJoint, a)).epsilon(1e-6));
}
