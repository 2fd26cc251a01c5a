// SPDX-License-Identifier: Apache-2.0
#include "reference/cattaneo_mindlin.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/reference/evaluate.hpp"
#include "tests/reference/printed.hpp"

using namespace slipbench::reference;
using namespace slipbench::reference::cattaneo_mindlin;

namespace {

constexpr Body kSteelSphere{10.0, 210000.0, 0.3};
const std::vector<std::vector<double>> kSteel{{10.0}, {10.0}, {210000.0}, {210000.0},
                                              {0.3},  {0.3},  {100.0},    {0.2}};

Contact steel_contact() { return contact(pair(kSteelSphere, kSteelSphere), 0.2, 100.0); }

// Exact formulas: only the rounding of a few operations separates two doubles.
Approx exact(double value) { return Approx(value).epsilon(1e-13).margin(1e-16); }

}  // namespace

TEST_CASE("two steel spheres have the printed contact radius and tangential stiffness") {
  const auto steel = steel_contact();
  CHECK_THAT(steel.contact_radius, printed("0.148124803420369"));
  CHECK_THAT(initial_stiffness(steel), printed("28150.4151296628"));
  const auto row =
      evaluate(kHertzForm, {kSteel.begin(), kSteel.begin() + 6}, {{100.0}, {800.0}, {0.0}, {-3.0}});
  CHECK_THAT(row[0][0], printed("0.148124803420369"));
  CHECK(row[0][1] == exact(0.148124803420369 * 0.148124803420369 / 5.0));
  CHECK_THAT(row[0][3], printed("28150.4151296628"));
  CHECK(row[1][0] == exact(2.0 * row[0][0]));
  CHECK(row[1][2] == exact(2.0 * row[0][2]));
  CHECK(row[2] == std::vector<double>(4, 0.0));
  CHECK(row[3] == row[2]);
  // The half-ellipsoid of pressure carries the normal force: 2/3 p_0 pi a^2.
  CHECK(2.0 / 3.0 * row[0][2] * std::numbers::pi * row[0][0] * row[0][0] == exact(100.0));
}

TEST_CASE("a sphere on a plane is a pair with the sphere's radius") {
  const Body plane{std::numeric_limits<double>::infinity(), 210000.0, 0.3};
  CHECK(pair(kSteelSphere, plane).effective_radius == exact(10.0));
  auto both_planes = kSteel;
  both_planes[0] = both_planes[1] = {plane.radius};
  CHECK(kForm.violation(both_planes).has_value());
}

TEST_CASE("first loading of two spheres has the printed motions") {
  const double ratios[] = {0.25, 0.5, 0.75, 0.9, 1.0};
  const char* motions[] = {"1.85984668757992e-4", "3.94352417200388e-4", "6.42778872954235e-4",
                           "8.36104754458954e-4", "1.06570364457568e-3"};
  const auto steel = steel_contact();
  for (std::size_t i = 0; i < 5; ++i) {
    const double force = 20.0 * ratios[i];
    const double motion = loading_motion(steel, force);
    CHECK_THAT(motion, printed(motions[i]));
    CHECK(backbone(steel, motion) == exact(force));
    CHECK(loading_motion(steel, -force) == -motion);
    const auto row = evaluate(kLoopForm, kSteel, {{force}}).back();
    CHECK(row[0] == exact(motion));
    CHECK(row[1] == exact(steel.contact_radius * std::cbrt(1.0 - ratios[i])));
  }
  CHECK(slip_motion(steel) == exact(1.06570364457568e-3));
  CHECK(backbone(steel, 1.0) == 20.0);
  CHECK(evaluate(kLoopForm, kSteel, {{25.0}}) == evaluate(kLoopForm, kSteel, {{20.0}}));
}

TEST_CASE("two spheres have the printed loop energies") {
  const double ratios[] = {0.25, 0.5, 0.9, 1.0};
  const char* energies[] = {"5.93312125243815e-5", "6.00496087212406e-4", "6.84161803629153e-3",
                            "1.70512583132109e-2"};
  const auto steel = steel_contact();
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(loop_energy_over_force(steel, 20.0 * ratios[i]) == exact(std::stod(energies[i])));
    CHECK_THAT(evaluate(kLoopForm, kSteel, {{-20.0 * ratios[i]}}).back()[2], printed(energies[i]));

    // Around the loop by Masing's branches.
    const double a = loading_motion(steel, 20.0 * ratios[i]);
    const auto rows = evaluate(kForm, kSteel, {{0.0}, {a}, {-a}, {a}, {-a}, {a}});
    CHECK(rows[1][0] == exact(20.0 * ratios[i]));
    CHECK(rows[2][0] == exact(-20.0 * ratios[i]));
    // The work of a loop is the small difference of two branches' works.
    CHECK(rows[5][3] - rows[3][3] == Approx(std::stod(energies[i])).epsilon(1e-11));
    CHECK(rows[5][1] - rows[3][1] == Approx(std::stod(energies[i])).epsilon(1e-12));
    CHECK(rows[5][2] == Approx(rows[3][2]).epsilon(1e-11));
  }
}

TEST_CASE("small loops of two spheres cost the cube of the force") {
  const auto steel = steel_contact();
  for (const double q : {1e-6, 1e-4}) {
    // (mu N)^2 Lam q^3/(36 a)
    const double leading = 400.0 * steel.compliance * q * q * q / (36.0 * steel.contact_radius);
    // The next term of the series is of the relative size q.
    CHECK(loop_energy_over_force(steel, 20.0 * q) == Approx(leading).epsilon(2.0 * q));
  }
  const double small = 1e-8 * slip_motion(steel);
  CHECK(backbone_work(steel, small) / (0.5 * initial_stiffness(steel) * small * small) ==
        Approx(1.0).epsilon(1e-8));
  // Where the series takes over nothing jumps.
  const double edge = kSeriesBelow * slip_motion(steel);
  const double below = edge * (1.0 - 1e-15);
  CHECK(loop_energy(steel, below) == Approx(loop_energy(steel, edge)).epsilon(1e-12));
  CHECK(backbone_work(steel, below) == Approx(backbone_work(steel, edge)).epsilon(1e-12));
}

TEST_CASE("the work of two spheres' first loading is the integral of its force") {
  const auto steel = steel_contact();
  for (const double x : {0.1, 0.6, 1.0, 1.4}) {
    const double end = x * slip_motion(steel);
    const int n = 2000;
    double work = 0.0;
    for (int i = 0; i < n; ++i) work += backbone(steel, end * (i + 0.5) / n) * end / n;
    // The midpoint rule's error dominates.
    CHECK(work == Approx(backbone_work(steel, end)).epsilon(1e-6));
    CHECK(backbone_work(steel, -end) == backbone_work(steel, end));
  }
}

TEST_CASE("beyond gross sliding two spheres dissipate like a Coulomb slider") {
  const auto steel = steel_contact();
  const double u = slip_motion(steel);
  CHECK(loop_energy(steel, 3.0 * u) == exact(loop_energy(steel, u) + 8.0 * 20.0 * u));
  const auto rows = evaluate(kForm, kSteel, {{0.0}, {3.0 * u}, {-3.0 * u}, {3.0 * u}});
  CHECK(rows[1][0] == 20.0);
  CHECK(rows[2][0] == exact(-20.0));
  CHECK(rows[3][1] - rows[1][1] == exact(loop_energy(steel, 3.0 * u)));
}

TEST_CASE("unloading two spheres leaves the printed motion of Mindlin and Deresiewicz") {
  // Their closed form: u = u_s {2 [1 - (q* - q)/2]^(2/3) - (1 - q*)^(2/3) - 1} while unloading.
  const auto steel = steel_contact();
  const double turn = 0.9;
  const double motion = loading_motion(steel, 20.0 * turn);
  for (const double q : {0.5, 0.0, -0.4, -0.9}) {
    const double left = slip_motion(steel) * (2.0 * std::pow(1.0 - 0.5 * (turn - q), 2.0 / 3.0) -
                                              std::pow(1.0 - turn, 2.0 / 3.0) - 1.0);
    const auto rows = evaluate(kForm, kSteel, {{0.0}, {motion}, {left}});
    CHECK(rows[2][0] == Approx(20.0 * q).epsilon(1e-12).margin(1e-12));
  }
}

TEST_CASE("two spheres' circle of stick carries the rest of the force") {
  // Cattaneo's superposition: a sliding contact's traction less the same on the stick circle.
  const auto steel = steel_contact();
  for (const double q : {0.2, 0.7}) {
    const double c = stick_radius(steel, 20.0 * q) / steel.contact_radius;
    CHECK(1.0 - c * c * c == exact(q));
    CHECK(loading_motion(steel, 20.0 * q) == exact(slip_motion(steel) * (1.0 - c * c)));
  }
}
