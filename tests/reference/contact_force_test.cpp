// SPDX-License-Identifier: Apache-2.0
#include "reference/contact_force.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;

namespace {

double evaluate_once(std::string_view name, const std::vector<std::vector<double>>& parameters,
                     const std::vector<double>& inputs) {
  return evaluate(name, parameters, {inputs})[0][0];
}

// Only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-14); }

}  // namespace

TEST_CASE("a signed contact force subtracts from the internal force") {
  CHECK(contact_force::effective(-80.0, 100.0) == 20.0);
  CHECK(contact_force::effective(-100.0, 100.0) == 0.0);
  CHECK(contact_force::effective(-130.0, 100.0) == 30.0);
}

TEST_CASE("SLOT presses with the resultant of its two reactions") {
  CHECK(evaluate_once("contact_force_slot", {{7.0}}, {-3.0, 4.0}) == exact(12.0));
  CHECK(evaluate_once("contact_force_slot", {{7.0}}, {-3.0, 0.0}) == exact(10.0));
}

TEST_CASE("SLIDE-PLANE presses with the magnitude of its reaction") {
  CHECK(evaluate_once("contact_force_slide_plane", {{2.0}}, {-80.0}) == exact(82.0));
}

TEST_CASE("CYLINDRICAL presses with its reactions and the levered bending moment") {
  const std::vector<std::vector<double>> shock{{0.24}, {0.55}, {0.0}};
  const double force = evaluate_once("contact_force_cylindrical", shock, {100, 50, 10, 5});
  CHECK_THAT(force, printed("152.459"));
  CHECK_THAT(0.15 * force, printed("22.8689"));
  CHECK(evaluate_once("contact_force_cylindrical", shock, {300, 400, 55, 0}) == exact(700.0));
  CHECK(evaluate_once("contact_force_cylindrical", shock, {-300, 400, -55, 0}) == exact(700.0));
  CHECK(evaluate_once("contact_force_cylindrical", {{0.24}, {0.0}, {9.0}}, {300, 400, 55, 0}) ==
        exact(509.0));
}

TEST_CASE("CYLINDRICAL with the lever of a position table has the table's printed limits") {
  const auto limit = [](double lever) {
    return 0.15 * contact_force::cylindrical({2.0 / lever, 0.0}, 100, 50, 10, 5);
  };
  // The middle of the table row (3.636364, 0) to (20, 0.45), and its end.
  CHECK_THAT(limit(0.5 * (3.636364 + 20.0)), printed("36.5902"));
  CHECK_THAT(limit(20.0), printed("50.3115"));
  CHECK(contact_force::cylindrical({2.0 / 11.8181818181818181, 0.0}, 300, 400, 55, 0) ==
        exact(1150.0));
}

TEST_CASE("TRANSLATOR adds the moment about its axis") {
  CHECK(evaluate_once("contact_force_translator", {{0.1}, {0.4}, {5.0}}, {3, 4, 2, 0.6, 0.8}) ==
        exact(35.0));
  const std::vector<double> load{300, 400, 12, 55, 0};
  CHECK(evaluate_once("contact_force_translator", {{0.24}, {0.55}, {0.0}}, load) == exact(750.0));
  CHECK(evaluate_once("contact_force_translator", {{0.0}, {0.55}, {0.0}}, load) == exact(700.0));
  CHECK(evaluate_once("contact_force_translator", {{0.24}, {0.0}, {0.0}}, load) == exact(550.0));
}

TEST_CASE("HINGE has the printed contact moment and limits") {
  const std::vector<double> load{200, 300, 400, 30, 40};
  const auto moment = [&](double internal) {
    return evaluate_once("contact_force_hinge", {{0.12}, {0.14}, {0.65}, {internal}}, load);
  };
  CHECK_THAT(moment(0.0), printed("106.462"));
  CHECK_THAT(0.15 * moment(100.0), printed("30.9692"));
  CHECK_THAT(0.15 * moment(95.0), printed("30.2192"));
  CHECK_THAT(0.15 * moment(90.0), printed("29.4692"));
  CHECK(evaluate_once("contact_force_hinge", {{0.12}, {0.0}, {0.0}, {0.0}}, load) == exact(60.0));
}

TEST_CASE("PLANAR presses differently against sliding and spinning") {
  const std::vector<std::vector<double>> puck{{0.5}, {20.0}, {3.0}, {0.0}};
  const std::vector<double> load{-100, 6, 8};
  CHECK(evaluate_once("contact_force_planar_sliding", puck, load) == exact(140.0));
  const double spin = evaluate_once("contact_force_planar_spinning", puck, load);
  CHECK_THAT(spin, printed("46.3333"));
  CHECK_THAT(0.2 * spin, printed("9.26667"));
  const std::vector<std::vector<double>> point{{0.0}, {0.0}, {0.0}, {0.0}};
  CHECK(evaluate_once("contact_force_planar_sliding", point, load) == exact(100.0));
  CHECK(evaluate_once("contact_force_planar_spinning", point, load) == exact(10.0));
}

TEST_CASE("a ring rubs at its mean arm, from the disc's 2/3 R to R of a thin one") {
  using slipbench::reference::contact_force::mean_arm;
  CHECK(mean_arm({3.0, 0.0}) == exact(2.0));
  CHECK(mean_arm({3.0, 1.0}) == exact(2.0 / 3.0 * 26.0 / 8.0));
  CHECK(mean_arm({3.0, 3.0}) == exact(3.0));
  CHECK(mean_arm({0.0, 0.0}) == 0.0);
  // The integral of r dA over that of dA, by the midpoint rule.
  double moment = 0.0, area = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double r = 1.0 + 2.0 * (i + 0.5) / 4000;
    moment += r * r;
    area += r;
  }
  CHECK(mean_arm({3.0, 1.0}) == Approx(moment / area).epsilon(1e-7));
  // A thin ring, whose difference of cubes would be rounding: R - R_i/2 and so on, to first order.
  CHECK(mean_arm({1.0, 1.0 - 1e-12}) == Approx(1.0 - 0.5e-12).epsilon(1e-15));
  const std::vector<std::vector<double>> ring{{3.0}, {20.0}, {3.0}, {1.0}};
  CHECK(evaluate_once("contact_force_planar_spinning", ring, {-24, 6, 8}) == exact(52.0 + 13.0));
}

TEST_CASE("a signed contact force counts with its sign before the absolute value is taken") {
  CHECK(evaluate_once("contact_force_component", {{100.0}}, {-80.0}) == 20.0);
  CHECK(evaluate_once("contact_force_component", {{100.0}}, {-100.0}) == 0.0);
  CHECK(evaluate_once("contact_force_component", {{100.0}}, {-130.0}) == 30.0);
}
