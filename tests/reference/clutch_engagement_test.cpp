// SPDX-License-Identifier: Apache-2.0
#include "reference/clutch_engagement.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/reference/evaluate.hpp"

using namespace slipbench::reference;

namespace {

constexpr clutch_engagement::Clutch kFree{0.4, 0.6, 100.0, 20.0, 12.0, 0.0, 0.0};
constexpr clutch_engagement::Clutch kLoaded{0.5, 1.5, 60.0, 0.0, 15.0, 8.0, -3.0};

}  // namespace

TEST_CASE("an unloaded clutch engages at the common momentum with the textbook's heat") {
  const double end = clutch_engagement::engagement_time(kFree);
  CHECK(end == Approx(0.4 * 0.6 * 80.0 / 12.0).epsilon(1e-14));
  const auto state = clutch_engagement::at(kFree, 3.0);
  CHECK(state.driver_speed == Approx(52.0).epsilon(1e-14));
  CHECK(state.driven_speed == Approx(52.0).epsilon(1e-14));
  CHECK(state.heat == Approx(0.5 * 0.24 * 6400.0).epsilon(1e-14));
  CHECK(state.moment == 0.0);
}

TEST_CASE("energy and momentum of a loaded clutch are those of its loads") {
  double work = 0.0;
  const double dt = 1e-4;
  for (int i = 0; i < 40000; ++i) {
    const auto middle = clutch_engagement::at(kLoaded, (i + 0.5) * dt);
    work += dt * (8.0 * middle.driver_speed - 3.0 * middle.driven_speed);
  }
  const auto end = clutch_engagement::at(kLoaded, 4.0);
  const double kinetic =
      0.5 * (0.5 * end.driver_speed * end.driver_speed + 1.5 * end.driven_speed * end.driven_speed);
  CHECK(kinetic + end.heat - work == Approx(0.5 * 0.5 * 3600.0).epsilon(1e-7));
  CHECK(0.5 * end.driver_speed + 1.5 * end.driven_speed == Approx(30.0 + 5.0 * 4.0).epsilon(1e-13));
  CHECK(end.driver_speed == Approx(end.driven_speed).epsilon(1e-13));
  CHECK(end.moment == Approx(6.75));
}

TEST_CASE("a clutch that never engages or cannot hold its loads is refused") {
  const auto violation = [](double load) {
    return clutch_engagement::violation(std::vector<std::vector<double>>{
        {0.5}, {1.5}, {60.0}, {0.0}, {15.0}, {load}, {-3.0}, {0.0}});
  };
  CHECK_FALSE(violation(8.0));
  CHECK(violation(-21.1)->find("cannot hold") != std::string::npos);  // 15.075 N m of 15
  CHECK(violation(40.0)->find("never engages") != std::string::npos);
  CHECK(evaluate("clutch_engagement", {{0.4}, {0.6}, {100.0}, {20.0}, {12.0}, {0.0}, {0.0}, {1.0}},
                 {{0.0}})[0][0] == 100.0);
}
