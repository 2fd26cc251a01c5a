// SPDX-License-Identifier: Apache-2.0
#include "law/update/return_mapping.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "law/connection/cylindrical.hpp"
#include "law/definition/potential.hpp"
#include "law/update/connector_tangent.hpp"
#include "reference/coulomb_slider.hpp"
#include "reference/parallel_sliders.hpp"
#include "reference/planar_slider.hpp"
#include "reference/varying_normal_force.hpp"
#include "reference/wear.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
namespace reference = slipbench::reference;
using std::numbers::pi;

// The base set of the reference cases: mu 0.2, N 100, k 1000, so limit 20 and elastic slip 0.02.
constexpr double kLimit = 20.0;
constexpr double kStiffness = 1000.0;

/// Both stick modes, which agree where the limit does not change.
std::array<StickStiffness, 2> both_modes() {
  return {fixed_stiffness(kStiffness), allowable_slip(kLimit / kStiffness)};
}

/// Exact up to the rounding of the sums of a path.
Approx exactly(double value) { return Approx(value).epsilon(1e-12).margin(1e-12); }

TEST_CASE("a slider sticks up to the limit and flips above it, not at it (J1)") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    run.move_to(1, 0.01);
    CHECK(run.friction(1) == exactly(10));
    CHECK(run.state.regime == Regime::kStick);
    run.move_to(1, 0.02);
    CHECK(run.friction(1) == exactly(20));
    CHECK(run.state.regime == Regime::kStick);
    CHECK(run.state.accumulated_slip == 0.0);
    run.move_to(1, 0.1);
    CHECK(run.friction(1) == exactly(20));
    CHECK(run.state.regime == Regime::kSlip);
    CHECK(run.state.accumulated_slip == exactly(0.08));
    CHECK(run.last.phi == Approx(0.0).margin(1e-12));
    CHECK(run.last.normal_force == 100.0);
    CHECK(run.last.mu == 0.2);
    CHECK(run.last.limit == exactly(20));
  }
}

TEST_CASE("the onset is the part of the increment before slip begins") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    CHECK(run.move_to(1, 0.1).onset == exactly(0.2));  // 0.02 of 0.1
    CHECK(run.move_to(1, 0.2).onset == 0.0);           // slips on
    CHECK(run.move_to(1, 0.1).onset == exactly(0.4));  // back through both elastic slips
    CHECK(run.move_to(1, 0.11).onset == 0.0);          // sticks
  }
  // Within one step of a path in two directions: (14.7) of the theory.
  FrictionRun plane(slider(0.2, 100.0, fixed_stiffness(kStiffness), {2, 3}));
  plane.position[1] = 0.03;
  plane.position[2] = 0.04;
  CHECK(plane.step().onset == exactly(0.4));  // 20 N of 50 N
}

TEST_CASE("a force above a limit that fell turns back through the inside of the limit") {
  FrictionRun run(slider(0.2, 100.0, fixed_stiffness(kStiffness)));
  run.move_to(1, 0.1);
  run.definition.internal_contact_force = 90.0;
  // From 20 to the trial -80 N over -0.1 mm: it meets -18 N after 0.38 of it.
  const FrictionUpdate& back = run.move_to(1, 0.0);
  CHECK(back.onset == exactly(0.38));
  CHECK(back.work == exactly(-0.038 * 0.5 * (20.0 - 18.0) + 0.062 * 18.0));
}

TEST_CASE("a slider's loop has the four corners and the energy of the closed form (J2)") {
  for (const StickStiffness stick : both_modes()) {
    for (const int per_leg : {1, 7}) {
      FrictionRun run(slider(0.2, 100.0, stick));
      run.ramp_to(1, 0.1, per_leg);
      const double slip0 = run.state.accumulated_slip;
      const double energy0 = run.dissipation;
      for (const auto& [u, f] : {std::pair{0.06, -20.0}, std::pair{-0.1, -20.0},
                                 std::pair{-0.06, 20.0}, std::pair{0.1, 20.0}}) {
        run.ramp_to(1, u, per_leg);
        CHECK(run.friction(1) == exactly(f));
      }
      CHECK(run.state.accumulated_slip - slip0 == exactly(0.32));
      CHECK(run.dissipation - energy0 == exactly(6.4));
    }
  }
}

TEST_CASE("a loop within the elastic slip never slips and costs nothing (J2)") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    for (int cycle = 0; cycle < 5; ++cycle) {
      for (const double u : {0.02, -0.02}) run.ramp_to(1, u, 4);
    }
    CHECK(run.state.accumulated_slip == 0.0);
    CHECK(run.dissipation == 0.0);
  }
}

TEST_CASE("running totals of slip and dissipation along 0, A, -A, A (J4)") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    double total = 0.0;
    for (const auto& [u, s] : {std::pair{0.1, 0.08}, std::pair{-0.1, 0.24}, std::pair{0.1, 0.40}}) {
      run.ramp_to(1, u, 5);
      CHECK(run.state.accumulated_slip == exactly(s));
      total = run.work - run.last.stored_energy;
      CHECK(total == exactly(run.dissipation));
    }
    CHECK(run.dissipation == exactly(8.0));
  }
}

TEST_CASE("a slider follows the closed form along a path with uneven turning points") {
  const reference::coulomb_slider::Slider body{kStiffness, kLimit};
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    auto expected = reference::coulomb_slider::start(0.0);
    for (const double u : {0.013, 0.31, 0.305, 0.29, 0.3, -0.02, -0.02, 0.5, 0.48, -7.0, 0.0}) {
      run.move_to(1, u);
      expected = reference::coulomb_slider::advance(body, expected, u);
      CHECK(run.friction(1) == exactly(expected.force));
      CHECK(run.state.accumulated_slip == exactly(expected.accumulated_slip));
      CHECK(run.dissipation == exactly(expected.dissipation));
      CHECK(run.work == exactly(expected.work));
      CHECK(run.last.stored_energy ==
            exactly(reference::coulomb_slider::stored_energy(body, expected.force)));
    }
  }
}

TEST_CASE("the force limit caps the friction force and shortens the elastic slip (J5)") {
  FrictionDefinition capped = slider(0.2, 100.0, fixed_stiffness(kStiffness));
  capped.force_limit = 15.0;
  FrictionRun run(capped);
  run.move_to(1, 0.015);
  CHECK(run.state.regime == Regime::kStick);
  run.move_to(1, 0.1);
  CHECK(run.friction(1) == exactly(15));
  CHECK(run.state.accumulated_slip == exactly(0.085));
  CHECK(run.last.mu == 0.2);
  capped.stick = allowable_slip(0.02);
  FrictionRun soft(capped);
  CHECK(soft.move_to(1, 0.01).state.force[0] == exactly(7.5));
  CHECK(soft.move_to(1, 0.1).state.force[0] == exactly(15));
}

TEST_CASE("a force limit above mu F_N never acts") {
  FrictionDefinition capped = slider(0.2, 100.0, fixed_stiffness(kStiffness));
  capped.force_limit = 20.0001;
  FrictionRun run(capped);
  CHECK(run.move_to(1, 1.0).state.force[0] == exactly(20));
}

TEST_CASE("a signed contact force is added before its magnitude is taken (J6)") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(kStiffness));
  definition.contact_force = ComponentContactForce{1};
  for (const auto& [f2, normal] : {std::pair{-80.0, 20.0}, std::pair{80.0, 180.0},
                                   std::pair{-100.0, 0.0}, std::pair{-130.0, 30.0}}) {
    FrictionRun run(definition);
    run.force[1] = f2;
    run.move_to(1, 1.0);
    CHECK(run.last.normal_force == normal);
    CHECK(run.last.contact_force == f2 + 100.0);
    CHECK(run.friction(1) == exactly(0.2 * normal));
  }
  definition.contact_force = DerivedComponent{norm_term({2}, 1.0)};
  FrictionRun magnitude(definition);
  magnitude.force[1] = -80.0;
  CHECK(magnitude.move_to(1, 1.0).normal_force == 180.0);
}

TEST_CASE("three sliders in parallel make the Masing loops (M1)") {
  const std::array<double, 3> stiffness = {1000, 500, 250};
  const std::array<double, 3> limit = {10, 15, 20};
  std::vector<FrictionRun> runs;
  for (std::size_t i = 0; i < 3; ++i) {
    runs.emplace_back(slider(1.0, limit[i], fixed_stiffness(stiffness[i])));
  }
  const auto move_to = [&](double u) {
    double force = 0.0;
    for (FrictionRun& run : runs) {
      run.ramp_to(1, u, 3);
      force += run.friction(1);
    }
    return force;
  };
  const auto dissipated = [&] {
    return runs[0].dissipation + runs[1].dissipation + runs[2].dissipation;
  };
  for (const auto& [u, f] : {std::pair{0.01, 17.5}, std::pair{0.02, 25.0}, std::pair{0.03, 32.5},
                             std::pair{0.05, 37.5}, std::pair{0.08, 45.0}, std::pair{0.1, 45.0}}) {
    CHECK(move_to(u) == exactly(f));
  }
  CHECK(move_to(0.04) == exactly(-20));
  CHECK(move_to(0.0) == exactly(-30));
  CHECK(move_to(-0.1) == exactly(-45));
  CHECK(move_to(0.1) == exactly(45));
  const double before = dissipated();
  CHECK(move_to(0.04) == exactly(-20));
  CHECK(move_to(0.06) == exactly(15));
  CHECK(move_to(0.1) == exactly(45));
  CHECK(dissipated() - before == exactly(0.8));
  for (const auto& [amplitude, energy] :
       {std::pair{0.1, 9.4}, std::pair{0.05, 2.8}, std::pair{0.025, 0.6}}) {
    move_to(amplitude);
    move_to(-amplitude);
    move_to(amplitude);
    const double start = dissipated();
    move_to(-amplitude);
    move_to(amplitude);
    CHECK(dissipated() - start == exactly(energy));
  }
}

/// Normal force given as reaction f2.
FrictionDefinition under_reaction(StickStiffness stick) {
  FrictionDefinition definition = slider(0.2, 0.0, stick);
  definition.contact_force = ComponentContactForce{1};
  return definition;
}

TEST_CASE("a normal force in phase with the motion gives the quadrilateral loop (N1)") {
  const reference::varying_normal_force::Slider body{0.2, kStiffness};
  std::array<double, 2> error{};
  for (const int refinement : {0, 1}) {
    FrictionRun run(under_reaction(fixed_stiffness(kStiffness)));
    reference::varying_normal_force::State expected;
    expected.normal_force = 100.0;
    double energy = 0.0;
    const auto go = [&](double from, double to, int count) {
      for (int i = 1; i <= count; ++i) {
        const double u = from + (to - from) * i / count;
        run.force[1] = 100.0 + 500.0 * u;
        run.move_to(1, u);
        expected = reference::varying_normal_force::advance(body, expected, u, run.force[1]);
        // The force on a monotone piece is exact whatever the step; slip likewise.
        CHECK(run.friction(1) == exactly(expected.force));
        CHECK(run.state.accumulated_slip == exactly(expected.accumulated_slip));
        energy += run.last.dissipation;
      }
    };
    const int count = 200 << refinement;
    go(0.0, 0.1, count);
    CHECK(run.friction(1) == exactly(30));
    energy = 0.0;
    go(0.1, 0.0454545454545455, count);
    CHECK(run.friction(1) == exactly(-24.5454545454545));
    go(0.0454545454545455, -0.1, count);
    CHECK(run.friction(1) == exactly(-10));
    go(-0.1, -0.0777777777777778, count);
    CHECK(run.friction(1) == exactly(12.2222222222222));
    go(-0.0777777777777778, 0.1, count);
    CHECK(run.friction(1) == exactly(30));
    error[static_cast<std::size_t>(refinement)] = energy - 608.0 / 99.0;
  }
  // Backward sums of the dissipation: first order in the step.
  CHECK(std::abs(error[0]) < 0.02);
  CHECK(error[1] / error[0] == Approx(0.5).margin(0.02));
}

TEST_CASE("with k <= mu g forward slip never starts: the slider wedges without an error (N1)") {
  FrictionRun run(under_reaction(fixed_stiffness(90.0)));
  for (int i = 0; i <= 100; ++i) {
    run.force[1] = 100.0 + 500.0 * 0.1 * i;
    run.move_to(1, 0.1 * i);
    CHECK(run.state.regime == Regime::kStick);
  }
}

TEST_CASE("a normal force in quadrature costs the energy of the closed form to first order (N2)") {
  std::array<double, 2> error{};
  for (const int refinement : {0, 1}) {
    FrictionRun run(under_reaction(fixed_stiffness(kStiffness)));
    const int count = 2000 << refinement;
    double energy = 0.0;
    for (int turn = 0; turn < 3; ++turn) {
      energy = run.dissipation;
      for (int i = 1; i <= count; ++i) {
        const double p = 2.0 * pi * i / count;
        run.force[1] = 100.0 * (1.0 - 0.5 * std::cos(p));
        run.move_to(1, 0.1 * std::sin(p));
      }
    }
    error[static_cast<std::size_t>(refinement)] =
        std::abs(run.dissipation - energy - 6.37613910583832);
  }
  CHECK(error[1] < 1e-2);
  CHECK(error[1] < 0.7 * error[0]);
}

TEST_CASE("unloading the normal force at rest relaxes the force along the limit (N4)") {
  for (const int count : {1, 10, 1000}) {
    FrictionRun run(under_reaction(fixed_stiffness(kStiffness)));
    run.force[1] = 100.0;
    run.move_to(1, 0.015);
    CHECK(run.friction(1) == exactly(15));
    for (int i = 1; i <= count; ++i) {
      run.force[1] = 100.0 - 75.0 * i / count;
      run.step();
    }
    CHECK(run.friction(1) == exactly(5));
    CHECK(run.state.accumulated_slip == exactly(0.010));
    // The integral of the limit over the slip is 0.1; the backward sum is below by one step.
    CHECK(run.dissipation <= 0.1);
    CHECK(run.dissipation == Approx(0.1).margin(0.5 * 15.0 * 0.010 / count * 1.5));
    run.force[1] = 150.0;
    run.step();
    CHECK(run.friction(1) == exactly(5));
    CHECK(run.state.regime == Regime::kStick);
  }
}

TEST_CASE("in elastic-slip mode the sticking force follows the normal force at constant slip") {
  FrictionRun run(under_reaction(allowable_slip(0.02)));
  run.force[1] = 100.0;
  run.move_to(1, 0.015);
  CHECK(run.friction(1) == exactly(15));
  run.force[1] = 25.0;
  run.step();
  CHECK(run.friction(1) == exactly(3.75));
  CHECK(run.state.accumulated_slip == 0.0);
  run.force[1] = 200.0;
  run.step();
  CHECK(run.friction(1) == exactly(30));
}

TEST_CASE("after lift-off the force restarts from zero, counted from re-contact (N5)") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(under_reaction(stick));
    run.force[1] = 100.0;
    run.move_to(1, 0.05);
    const double slip = run.state.accumulated_slip;
    run.force[1] = 0.0;
    for (const double u : {0.06, 0.2, -0.3}) {
      run.move_to(1, u);
      CHECK(run.state.regime == Regime::kOpen);
      CHECK(run.friction(1) == 0.0);
      CHECK(run.last.stored_energy == 0.0);
      CHECK(run.last.dissipation == 0.0);
      CHECK(run.state.accumulated_slip == slip);
    }
    run.force[1] = 100.0;
    run.move_to(1, -0.3);
    CHECK(run.friction(1) == 0.0);
    CHECK(run.state.regime == Regime::kStick);
    run.move_to(1, -0.29);
    CHECK(run.friction(1) == exactly(10));
  }
}

TEST_CASE("the two-dimensional path of the example is met, elastic-slip mode") {
  for (const StickStiffness stick : {allowable_slip(0.01), fixed_stiffness(2000.0)}) {
    FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
    struct Leg {
      double d2, d3, f2, f3;
    };
    // The forces are given to five decimals.
    for (const Leg& leg : {Leg{.004, 0, 8, 0}, Leg{.004, 0, 16, 0},
                           Leg{.010, .006, 18.97367, 6.32456}, Leg{0, .02, 7.58043, 18.50776},
                           Leg{-.005, 0, -2.41957, 18.50776}, Leg{-.02, 0, -18.33120, 7.99795}}) {
      run.position[1] += leg.d2;
      run.position[2] += leg.d3;
      run.step();
      CHECK(run.friction(2) == Approx(leg.f2).margin(5e-6));
      CHECK(run.friction(3) == Approx(leg.f3).margin(5e-6));
    }
    CHECK(run.state.accumulated_slip == Approx(0.037144).margin(5e-7));
    CHECK(run.dissipation == Approx(0.742882).margin(5e-7));
  }
}

TEST_CASE("on an L-shaped path the radial return converges to the closed form, first order (D1)") {
  struct Point {
    double w, f2, f3;
  };
  const std::array<Point, 5> exact = {{{.005, 19.3908725828043, 4.89837324807418},
                                       {.01, 17.7363776794015, 9.2423431452002},
                                       {.02, 12.9610854732777, 15.2318831191153},
                                       {.03, 8.50192069884561, 18.1029650728973},
                                       {.05, 3.26142463859956, 19.7322859630286}}};
  for (const StickStiffness stick : both_modes()) {
    std::array<double, 2> force_error{};
    std::array<double, 2> slip_error{};
    for (const std::size_t refinement : {0U, 1U}) {
      FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
      run.move_to(2, 0.05);
      const double first_leg = run.state.accumulated_slip;
      CHECK(first_leg == exactly(0.03));
      const int count = 500 << refinement;
      for (const Point& point : exact) {
        run.ramp_to(3, point.w, count);
        force_error[refinement] =
            std::max(force_error[refinement],
                     std::hypot(run.friction(2) - point.f2, run.friction(3) - point.f3));
        CHECK(std::hypot(run.friction(2), run.friction(3)) == exactly(20));
      }
      slip_error[refinement] = std::abs(run.state.accumulated_slip - 0.0662713633585835);
    }
    CHECK(force_error[1] < 0.01);  // step/elastic slip = 1e-3 at most, times the limit 20
    CHECK(force_error[1] / force_error[0] == Approx(0.5).margin(0.03));
    CHECK(slip_error[1] < 1e-5);
    CHECK(slip_error[1] / slip_error[0] == Approx(0.5).margin(0.03));
  }
  const auto closed = reference::planar_slider::l_path({kStiffness, kLimit}, 0.03);
  CHECK(closed.force.x == exactly(8.50192069884561));
}

TEST_CASE("on a circle the radial return settles to its own closed form (D2h)") {
  struct Turn {
    int count;
    double lag, slip;
  };
  for (const Turn& turn : {Turn{12, 0.658492453662131, 0.25431024697805},
                           Turn{36, 0.497123139440017, 0.276835951751279},
                           Turn{100, 0.442717428009306, 0.283964868953003},
                           Turn{200, 0.42717096796885, 0.285952888857469},
                           Turn{360, 0.420226874250516, 0.28683356157622}}) {
    const auto closed =
        reference::planar_slider::discrete_circle({kStiffness, kLimit}, 0.05, turn.count);
    for (const StickStiffness stick : both_modes()) {
      FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
      double slip = 0.0;
      for (int i = 1; i <= 5 * turn.count; ++i) {
        if (i == 4 * turn.count + 1) slip = run.state.accumulated_slip;
        const double p = 2.0 * pi * (i % turn.count) / turn.count;
        run.position[1] = 0.05 * (std::cos(p) - 1.0);
        run.position[2] = 0.05 * std::sin(p);
        run.step();
      }
      const double lag = 0.5 * pi - std::atan2(run.friction(3), run.friction(2));
      // Steady after four turns: the transient has died out as exp(-k R 8 pi / limit).
      CHECK(lag == Approx(turn.lag).margin(1e-10));
      CHECK(run.state.accumulated_slip - slip == Approx(turn.slip).margin(1e-10));
      CHECK(lag == Approx(closed.lag).margin(1e-10));
      CHECK(run.dissipation >= 0.0);
    }
  }
}

TEST_CASE("on a circle from rest slip begins at the closed form's angle (D3)") {
  const double onset = 0.402715841580662;
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
    const auto go = [&](double p) {
      run.position[1] = 0.05 * (std::cos(p) - 1.0);
      run.position[2] = 0.05 * std::sin(p);
      run.step();
    };
    go(0.2);
    go(onset * (1.0 - 1e-9));
    CHECK(run.state.regime == Regime::kStick);
    CHECK(run.friction(2) == Approx(-4.0).epsilon(1e-8));
    CHECK(run.friction(3) == Approx(19.5959179422654).epsilon(1e-8));
    go(onset * (1.0 + 1e-9));
    CHECK(run.state.regime == Regime::kSlip);
  }
}

TEST_CASE("helical slip of a shaft shares the limit between force and moment (D6)") {
  const PredefinedFriction shaft = Cylindrical{0.24, 0.55, 0.0}.predefined().front();
  for (const StickStiffness stick : {fixed_stiffness(1e5), allowable_slip(1e-3)}) {
    FrictionDefinition definition;
    definition.slip = shaft.slip;
    definition.contact_force = shaft.contact_force;
    definition.law = ConstantCoefficient{0.15};
    definition.stick = stick;
    FrictionRun run(definition);
    run.force = {{0, 300, 400, 0, 55, 0}};
    run.duration = 0.01;
    for (int i = 1; i <= 200; ++i) {
      run.position[0] = 0.3 * 0.01 * i;
      run.position[3] = 1.25 * 0.01 * i;
      run.step();
    }
    CHECK(run.last.normal_force == exactly(700));
    CHECK(run.friction(1) == Approx(74.2462120245875).epsilon(1e-12));
    CHECK(run.friction(4) == Approx(17.819090885901).epsilon(1e-12));
    CHECK(run.last.slip_rate == Approx(0.424264068711929).epsilon(1e-11));
    CHECK(run.last.dissipation / run.duration == Approx(44.5477272147525).epsilon(1e-11));
  }
}

TEST_CASE("the rotational stick stiffness of a shaft is k R^2 (D6)") {
  FrictionDefinition definition;
  definition.slip = Cylindrical{0.24, 0.0, 0.0}.predefined().front().slip;
  definition.internal_contact_force = 1000.0;
  definition.law = ConstantCoefficient{0.5};
  definition.stick = fixed_stiffness(1e4);
  FrictionRun run(definition);
  run.move_to(4, 1e-3);
  CHECK(run.state.regime == Regime::kStick);
  CHECK(run.friction(4) == exactly(1e4 * 0.24 * 0.24 * 1e-3));
}

/// Press fit of reference case W1: F_int = 100 - 50 s.
FrictionDefinition linear_wear(AccumulatedSlipTiming timing) {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(kStiffness));
  definition.internal_contact_force = make_function({{100, 0}, {0, 2}}, {kOverAccumulatedSlip});
  definition.accumulated_slip = timing;
  return definition;
}

TEST_CASE("wear at the end of the increment is exact for any step (W1)") {
  const reference::wear::LinearWear wear{0.2, kStiffness, 100.0, 50.0};
  for (const int count : {1, 3, 100}) {
    FrictionRun run(linear_wear(AccumulatedSlipTiming::kEnd));
    for (const auto& [u, f] : {std::pair{0.1, 19.1919191919192}, std::pair{0.5, 15.1515151515152},
                               std::pair{1.0, 10.1010101010101}}) {
      run.ramp_to(1, u, count);
      CHECK(run.friction(1) == exactly(f));
      CHECK(run.friction(1) == exactly(reference::wear::monotone(wear, u).force));
      CHECK(run.state.accumulated_slip ==
            exactly(reference::wear::monotone(wear, u).accumulated_slip));
    }
  }
}

TEST_CASE("wear at the start of the increment is behind by one step, first order (W1)") {
  std::array<double, 2> error{};
  for (const std::size_t refinement : {0U, 1U}) {
    FrictionRun run(linear_wear(AccumulatedSlipTiming::kStart));
    run.ramp_to(1, 1.0, 100 << refinement);
    error[refinement] = run.friction(1) - 10.1010101010101;
  }
  // One step of slip, 0.01, wears 0.5 N off F_int: 0.1 N of friction.
  CHECK(error[0] == Approx(0.1).epsilon(0.05));
  CHECK(error[1] / error[0] == Approx(0.5).margin(0.02));
}

TEST_CASE("cyclic wear lowers the peaks as the closed form says (W1)") {
  const std::array<double, 10> peaks = {
      17.5594327109479, 15.8939667051084, 14.1948549213732, 12.4614176470575, 10.6929614379072,
      8.8887788406932,  7.04814811020215, 5.17033292050927, 3.25458207041855, 1.30012918295226};
  for (const int count : {1, 13}) {
    FrictionRun run(linear_wear(AccumulatedSlipTiming::kEnd));
    run.ramp_to(1, 0.1, count);
    CHECK(run.friction(1) == exactly(19.1919191919192));
    double sign = -1.0;
    for (const double peak : peaks) {
      run.ramp_to(1, sign * 0.1, count);
      CHECK(run.friction(1) == Approx(sign * peak).epsilon(1e-12));
      sign = -sign;
    }
    CHECK(run.state.accumulated_slip == Approx(1.86998708170477).epsilon(1e-12));
  }
}

TEST_CASE("exponential wear through a fine table follows the closed form (W2)") {
  Rows rows;
  const double spacing = 1.0 / 512.0;
  for (int i = 0; i <= 2048; ++i) {
    rows.push_back({40.0 + 60.0 * std::exp(-i * spacing / 0.5), i * spacing});
  }
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(kStiffness));
  definition.internal_contact_force = make_function(rows, {kOverAccumulatedSlip});
  for (const int count : {1, 50}) {
    FrictionRun run(definition);
    for (const auto& [u, f, s] : {std::tuple{0.1, 18.1887497853451, 0.0818112502146549},
                                  std::tuple{0.5, 12.5265485832812, 0.487473451416719},
                                  std::tuple{1.0, 9.65569031465667, 0.990344309685343},
                                  std::tuple{3.0, 8.03022660152833, 2.99196977339847}}) {
      run.ramp_to(1, u, count);
      // The table's chord errs by spacing^2/8 times the curvature 240, times mu.
      CHECK(run.friction(1) == Approx(f).margin(2.5e-5));
      CHECK(run.state.accumulated_slip == Approx(s).margin(2.5e-8));
    }
  }
}

TEST_CASE("accumulated slip never recovers under reversal (W4)") {
  FrictionRun run(linear_wear(AccumulatedSlipTiming::kEnd));
  double slip = 0.0;
  double internal = 100.0;
  for (const double u : {0.1, 0.3, 0.1, 0.11, -0.2, 0.0}) {
    run.move_to(1, u);
    CHECK(run.state.accumulated_slip >= slip);
    CHECK(run.last.normal_force <= internal);
    slip = run.state.accumulated_slip;
    internal = run.last.normal_force;
  }
}

/// Falling friction of reference case K3: N 100, k 1000, 0.3 to 0.2 with decay 0.05, v 1.
FrictionDefinition falling() {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(kStiffness));
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  return definition;
}

TEST_CASE("above the threshold of the time step falling friction settles smoothly (K5)") {
  FrictionRun run(falling());
  run.duration = 9.6e-4;
  for (int i = 1; i <= 20000; ++i) run.move_to(1, i * run.duration);
  // Just above the threshold 9.512e-4 the transient decays slowly; 20000 steps are enough.
  CHECK(run.friction(1) == Approx(29.5122942450071).epsilon(1e-9));
  CHECK(run.last.slip_rate == Approx(1.0).epsilon(1e-7));
}

TEST_CASE("below the threshold falling friction oscillates between the stated forces (K5)") {
  FrictionRun run(falling());
  run.duration = 9.5e-4;
  double lowest = 1e9;
  double highest = 0.0;
  for (int i = 1; i <= 40000; ++i) {
    run.move_to(1, i * run.duration);
    if (i > 30000) {
      lowest = std::min(lowest, run.friction(1));
      highest = std::max(highest, run.friction(1));
    }
  }
  // The reference gives two decimals.
  CHECK(lowest == Approx(29.05).margin(0.02));
  CHECK(highest == Approx(30.00).margin(0.02));
}

TEST_CASE("far below the threshold falling friction is a saw-tooth and says so (K3)") {
  FrictionRun run(falling());
  run.duration = 1e-5;
  std::vector<int> drops;
  double lowest = 1e9;
  double highest = 0.0;
  for (int i = 1; i <= 20000; ++i) {
    const double before = run.friction(1);
    run.move_to(1, i * run.duration);
    if (i > 5000) {
      lowest = std::min(lowest, run.friction(1));
      highest = std::max(highest, run.friction(1));
      if (run.friction(1) < before - 5.0) {
        drops.push_back(i);
        CHECK(run.last.multiple_roots);
      }
    }
  }
  CHECK(lowest == Approx(20.0).margin(0.01));  // one step of k v dt = 0.01 N
  CHECK(highest == Approx(30.0).margin(0.011));
  REQUIRE(drops.size() > 10);
  const double period =
      (drops.back() - drops.front()) * run.duration / static_cast<double>(drops.size() - 1);
  CHECK(period == Approx(0.0100).margin(2e-5));
}

TEST_CASE("with several roots the first one is taken, at a knot-bounded dip") {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(5.0));
  definition.law = TabularCoefficient{make_function({{.1, 0}, {.4, 1}, {.05, 2}}, {kOverSlipRate})};
  FrictionRun run(definition);
  run.move_to(1, 4.0);  // trial force 20: roots at 2/7, between 1 and 2, and at 3
  CHECK(run.state.accumulated_slip == exactly(2.0 / 7.0));
  CHECK(run.friction(1) == exactly(20.0 - 10.0 / 7.0));
  CHECK(run.last.phi == Approx(0.0).margin(1e-12));
}

TEST_CASE("with several roots the first one is taken, inside one cell of two tables") {
  // mu rises with rate while F_int falls with slip: F_lim = (0.1 + 0.9 x)(100 - 90 x), a hump
  // between two knots where h is positive at both.
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(5.0));
  definition.law = TabularCoefficient{make_function({{.1, 0}, {1.0, 1}}, {kOverSlipRate})};
  definition.internal_contact_force = make_function({{100, 0}, {10, 1}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 4.0);
  const double x = (86.0 - std::sqrt(86.0 * 86.0 - 4.0 * 81.0 * 10.0)) / 162.0;
  CHECK(run.state.accumulated_slip == exactly(x));
  CHECK(run.friction(1) == exactly(20.0 - 5.0 * x));
}

TEST_CASE("of two roots in a cell the first one is taken though the other is at its end") {
  // F_lim = (0.1 + 0.9 x)(100 - 100 x) under 50 - 50 x: 50 = 10 + 90 x, and nothing is left at 1.
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(50.0));
  definition.law = TabularCoefficient{make_function({{.1, 0}, {1.0, 1}}, {kOverSlipRate})};
  definition.internal_contact_force = make_function({{100, 0}, {0, 1}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 1.0);
  CHECK(run.state.regime == Regime::kSlip);
  CHECK(run.state.accumulated_slip == exactly(4.0 / 9.0));
  CHECK(run.friction(1) == exactly(250.0 / 9.0));
}

TEST_CASE("a limit that the force just touches at a knot ends the slip there") {
  // 50 - 100 x against a limit that rises to 25 at 0.25, where both are the same, and falls faster.
  FrictionDefinition definition = slider(1.0, 0.0, fixed_stiffness(100.0));
  definition.internal_contact_force =
      make_function({{20, 0}, {25, .25}, {10, .3125}, {0, .5}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 0.5);
  CHECK(run.state.accumulated_slip == exactly(0.25));
  CHECK(run.friction(1) == exactly(25.0));
}

TEST_CASE("of the roots of a cubic limit the first one is taken before its bend and under a cap") {
  // mu is linear in the rate and in N, from its corners, and N falls with the slip.
  struct Cubic {
    double trial, stiffness;
    double rest, fast, pressed, both;  // mu at (rate, N): (0, 0), (1, 0), (0, 100), (1, 100)
    double from, to;                   // N
    double cap, below;
  };
  for (const Cubic& c : {
           // Falls more slowly than the spring only up to a root near 0.05; others near 0.33, 1.03.
           Cubic{26.0, 20.0, .95, .45, .35, .9, 35.0, 11.0, HUGE_VAL, 0.05},
           // Roots near 0.2 and 0.83 in one cell.
           Cubic{38.4, 36.0, .36, .32, .38, .42, 100.0, 9.0, 34.6, 0.2},
       }) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(c.stiffness));
    definition.law = TabularCoefficient{
        make_function({{c.rest, 0, 0}, {c.fast, 1, 0}, {c.pressed, 0, 100}, {c.both, 1, 100}},
                      {kOverSlipRate, kOverContactForce})};
    definition.internal_contact_force =
        make_function({{c.from, 0}, {c.to, 1}}, {kOverAccumulatedSlip});
    definition.force_limit = c.cap;
    FrictionRun run(definition);
    run.move_to(1, c.trial / c.stiffness);
    const double x = run.state.accumulated_slip;
    INFO("trial " << c.trial);
    CHECK(x < c.below);
    const double n = c.from + (c.to - c.from) * x;
    const double mu = (c.rest + (c.fast - c.rest) * x) * (1.0 - 0.01 * n) +
                      (c.pressed + (c.both - c.pressed) * x) * 0.01 * n;
    CHECK(run.friction(1) == exactly(mu * n));
    CHECK(run.friction(1) == exactly(c.trial - c.stiffness * x));
  }
}

TEST_CASE("the root of a cubic limit is met wherever its bend lies") {
  // F_lim = (m + p x + q N) N with N = a + b x, steeper nowhere than the spring: one root, at x.
  for (const double p : {-0.3, -0.1, 0.2, 0.4}) {
    for (const double q : {-0.003, -0.001, 0.0, 0.002}) {
      for (const double b : {-80.0, -40.0, 10.0, 30.0}) {
        const double m = 0.9, a = 90.0;
        const auto mu = [&](double x, double n) { return m + p * x + q * n; };
        FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(500.0));
        definition.law = TabularCoefficient{make_function(
            {{mu(0, 0), 0, 0}, {mu(1, 0), 1, 0}, {mu(0, 150), 0, 150}, {mu(1, 150), 1, 150}},
            {kOverSlipRate, kOverContactForce})};
        definition.internal_contact_force =
            make_function({{a, 0}, {a + b, 1}}, {kOverAccumulatedSlip});
        for (const double x : {0.1, 0.5, 0.9}) {
          const double limit = mu(x, a + b * x) * (a + b * x);
          FrictionRun run(definition);
          run.move_to(1, x + limit / 500.0);
          INFO("p " << p << " q " << q << " b " << b << " x " << x);
          CHECK(run.state.accumulated_slip == exactly(x));
          CHECK(run.friction(1) == exactly(limit));
        }
      }
    }
  }
}

TEST_CASE("a root is not passed over in a cell however narrow") {
  // The same hump over slips from 1 to 1 + w, of which the joint has had `before`.
  for (const auto& [before, w] : {std::pair{0.0, 1e-3},
                                  {0.0, 1e-6},
                                  {0.0, 1e-9},
                                  {0.0, 1e-12},
                                  {128.0, 1e-5},
                                  {128.0, 1e-6},
                                  {128.0, 1e-11},
                                  {1024.0, 1e-4},
                                  {65536.0, 3e-3},
                                  {65536.0, 1e-3}}) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(5.0));
    definition.law =
        TabularCoefficient{make_function({{.1, 0}, {.1, 1}, {1.0, 1 + w}}, {kOverSlipRate})};
    definition.internal_contact_force =
        make_function({{100, 0}, {100, before + 1}, {10, before + 1 + w}}, {kOverAccumulatedSlip});
    FrictionRun run(definition);
    run.state.accumulated_slip = before;
    run.move_to(1, 5.0);
    INFO("width " << w << " after " << before);
    CHECK(run.last.slip_increment == Approx(1.0).epsilon(w));
    // The limit rises by some 90/w: the rounding of the place counts.
    CHECK(run.friction(1) == Approx(20.0).margin(5.0 * w + 1e-13 * (1.0 + before) / w));
  }
}

TEST_CASE("the first of many roots is found and flagged, whatever the duration") {
  // mu goes up and down over the rate; h falls and rises with it from knot to knot. Under c |y|,
  // with c times the contact force, y returns by c of the slip.
  const Rows rows = {{.1, 0}, {.4, .7}, {.05, 1.3}, {.35, 2.1}, {.02, 2.9}, {.4, 3.7}, {.1, 4.1}};
  for (const double c : {1.0, 0.5, 2.0}) {
    FrictionDefinition definition = slider(0.0, 100.0 * c, fixed_stiffness(1.0));
    definition.law = TabularCoefficient{make_function(rows, {kOverSlipRate})};
    if (c != 1.0) {
      Potential line;
      line.parts = line.leaves = 1;
      line.leaf[0].direction[0] = 1.0;
      line.leaf[0].factor = c;
      definition.criterion = line;
    }
    for (int i = 1; i <= 400; ++i) {
      for (const double trial : {11.0, 38.0, 45.0}) {
        const double duration = 0.01 * i;
        double root = -1.0;
        int roots = 0;
        for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
          const double x0 = rows[k][1] * duration, x1 = rows[k + 1][1] * duration;
          const double h0 = trial - c * x0 - 100.0 * rows[k][0];
          const double h1 = trial - c * x1 - 100.0 * rows[k + 1][0];
          if ((h0 > 0.0) != (h1 > 0.0)) {
            if (++roots == 1) root = x0 + (x1 - x0) * h0 / (h0 - h1);
          }
        }
        if (trial - c * rows.back()[1] * duration - 100.0 * rows.back()[0] > 0.0) {
          if (++roots == 1) root = (trial - 100.0 * rows.back()[0]) / c;
        }
        FrictionRun run(definition);
        run.duration = duration;
        run.move_to(1, trial);
        INFO("factor " << c << " duration " << duration << " trial " << trial);
        CHECK(run.state.accumulated_slip == Approx(root).epsilon(1e-11));
        CHECK(run.last.multiple_roots == (roots > 1));
      }
    }
  }
}

TEST_CASE("a potential at rest below a limit that falls fast with the slip has further roots") {
  // 0.5 |y| on 50 mu: the limit falls by 500 N/mm of slip at first, the force by 0.25 of 1000.
  for (const double steepness : {1.0, 0.4}) {
    FrictionDefinition definition = slider(0.0, 50.0, fixed_stiffness(1000.0));
    definition.law = ExponentialDecay{0.2, 0.1, 100.0 * steepness};
    Potential line;
    line.parts = line.leaves = 1;
    line.leaf[0].direction[0] = 1.0;
    line.leaf[0].factor = 0.5;
    definition.criterion = line;
    FrictionRun run(definition);
    run.move_to(1, 0.001);
    CHECK(run.last.multiple_roots == (steepness == 1.0));
  }
}

TEST_CASE("knots behind the only root are no further roots") {
  // 2000 - 100 x and then less: met by 3000 - 1000 x at 10/9, before two knots within 3 of slip.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force =
      make_function({{1e4, 0}, {9e3, 2}, {8.8e3, 2.5}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 3.0);
  CHECK(run.state.accumulated_slip == exactly(10.0 / 9.0));
  CHECK_FALSE(run.last.multiple_roots);
}

TEST_CASE("a limit on its cap at rest may leave the cap within the increment") {
  SECTION("through the slip rate") {
    FrictionDefinition definition = falling();
    definition.force_limit = 25.0;  // below 30 at rest, above 20 at speed
    FrictionRun run(definition);
    run.duration = 1.0;
    run.move_to(1, 100.0);
    CHECK(run.last.limit ==
          Approx(100.0 * (0.2 + 0.1 * std::exp(-0.05 * run.last.slip_increment))).epsilon(1e-12));
    CHECK(run.friction(1) == Approx(1e3 * (100.0 - run.last.slip_increment)).epsilon(1e-9));
  }
  SECTION("through wear on a prolonged table") {
    FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(kStiffness));
    definition.internal_contact_force =
        make_function({{1000, 0}, {950, 1}}, {kOverAccumulatedSlip}, 1, Extrapolation::kLinear);
    definition.force_limit = 20.0;
    FrictionRun run(definition);
    run.state.accumulated_slip = 2.0;  // beyond the last knot
    run.move_to(1, 17.99);
    CHECK(run.last.limit < 5.0);
    CHECK(run.last.limit ==
          Approx(0.2 * (1000.0 - 50.0 * run.state.accumulated_slip)).epsilon(1e-9));
  }
}

TEST_CASE("on the cap the first root is taken though the coefficient falls further on") {
  // Trial force 22 on a cap of 18: the first root is 4/1000, where mu F_N is still 18.6; another
  // one lies near 19/1000, where only 3.1 are left.
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(kStiffness));
  definition.law = ExponentialDecay{0.3, 0.0, 0.12};
  definition.force_limit = 18.0;
  FrictionRun run(definition);
  run.duration = 1e-3;
  run.move_to(1, 0.022);
  CHECK(run.state.accumulated_slip == exactly(0.004));
  CHECK(run.friction(1) == exactly(18.0));
  CHECK(run.last.tangent.radial == 0.0);
}

TEST_CASE("the rate may be that of the relative motion, known beforehand") {
  for (const StickStiffness stick : {fixed_stiffness(kStiffness), allowable_slip(0.03)}) {
    FrictionDefinition definition = falling();
    definition.stick = stick;
    definition.slip_rate = SlipRateMeasure::kRelativeMotion;
    FrictionRun run(definition);
    run.duration = 0.1;
    run.move_to(1, 1.0);  // rate 10
    CHECK(run.last.slip_rate == Approx(10.0).epsilon(1e-15));
    CHECK(run.last.mu == Approx(0.260653065971263).epsilon(1e-14));
    CHECK(run.friction(1) == Approx(26.0653065971263).epsilon(1e-14));
    run.move_to(1, 1.001);  // also in stick
    CHECK(run.last.slip_rate == Approx(0.01).epsilon(1e-10));
  }
}

TEST_CASE("without a duration rates count as zero") {
  for (const StickStiffness stick : {fixed_stiffness(kStiffness), allowable_slip(0.03)}) {
    for (const SlipRateMeasure measure :
         {SlipRateMeasure::kSlip, SlipRateMeasure::kRelativeMotion}) {
      FrictionDefinition definition = falling();
      definition.stick = stick;
      definition.slip_rate = measure;
      FrictionRun run(definition);
      run.duration = 0.0;
      run.move_to(1, 1.0);
      CHECK(run.friction(1) == exactly(30));
      CHECK(run.last.slip_rate == 0.0);
    }
  }
}

TEST_CASE("in elastic-slip mode the slip rate is that of the increment, the coefficient implicit") {
  FrictionDefinition definition = falling();
  definition.stick = allowable_slip(0.03);
  FrictionRun run(definition);
  run.duration = 0.5;
  run.move_to(1, 5.03);
  CHECK(run.last.slip_increment == exactly(5.0));
  CHECK(run.last.slip_rate == exactly(10.0));
  CHECK(run.friction(1) == Approx(26.0653065971263).epsilon(1e-12));
  run.step();  // at rest again: the coefficient is the static one, the elastic slip unchanged
  CHECK(run.state.regime == Regime::kStick);
  CHECK(run.friction(1) == exactly(30));
}

TEST_CASE("a frictionless definition has no effect and no slip") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.0, 100.0, stick, {2, 3}));
    for (const double u : {0.1, 5.0, -3.0}) {
      run.move_to(2, u);
      CHECK(run.friction(2) == 0.0);
      CHECK(run.state.accumulated_slip == 0.0);
      CHECK(run.state.regime == Regime::kOpen);
      CHECK(run.last.dissipation == 0.0);
    }
  }
}

TEST_CASE("a coefficient that vanishes only at rest grips as soon as there is slip") {
  for (const StickStiffness stick : {fixed_stiffness(kStiffness), allowable_slip(0.02)}) {
    for (const double normal_force : {100.0, 1e-4}) {
      FrictionDefinition definition = slider(0.0, normal_force, stick);
      definition.law = TabularCoefficient{make_function({{0, 0}, {0.2, 1}}, {kOverSlipRate})};
      FrictionRun run(definition);
      run.move_to(1, 0.5);
      CHECK(run.state.regime == Regime::kSlip);
      CHECK(run.friction(1) > 0.05 * normal_force);
      CHECK(run.friction(1) == Approx(0.2 * normal_force * run.last.slip_rate).epsilon(1e-12));
    }
  }
}

TEST_CASE("a coefficient that is 0 at the rate of an elastic slip takes the force, not the slip") {
  Potential line;
  line.parts = line.leaves = 1;
  line.leaf[0].direction[0] = 1.0;
  for (const SlipCriterion& criterion :
       {SlipCriterion(EuclideanPotential{}), SlipCriterion(line), SlipCriterion(Capstan{1.0})}) {
    for (const int count : {1, 10, 1000}) {
      INFO("criterion " << criterion.index() << ", increments " << count);
      FrictionDefinition definition = slider(0.0, 0.0, allowable_slip(0.05));
      definition.criterion = criterion;
      definition.contact_force = ComponentContactForce{2};
      definition.law = TabularCoefficient{make_function({{0.3, 0}, {0, 10}}, {kOverSlipRate})};
      FrictionRun run(definition);
      run.force[2] = 100.0;
      run.duration = 0.1 / count;
      // At 20 mm/s, and back at 5 mm/s.
      run.ramp_to(1, 2.0, count);
      CHECK(run.state.regime == Regime::kSlip);
      CHECK(run.friction(1) == 0.0);
      CHECK(run.state.accumulated_slip == exactly(1.95));
      CHECK(run.state.elastic_slip[0] == exactly(0.05));
      CHECK(connector_tangent(run.definition, run.increment(), run.last).to_motion(0, 0) == 0.0);
      CHECK(run.last.onset == exactly(count == 1 ? 0.025 : 0.0));
      run.ramp_to(1, 1.4, count);
      run.ramp_to(1, 0.9, count);
      CHECK(run.state.accumulated_slip == exactly(1.95 + 1.0));
      if (criterion.index() != 2) CHECK(run.friction(1) == exactly(-15.0));
      CHECK(run.dissipation > 0.0);
    }
  }
  // A limit that is but small tells where its slip began.
  FrictionDefinition small = slider(0.0, 1.0, fixed_stiffness(kStiffness));
  small.law = TabularCoefficient{make_function({{0.2, 0}, {0.3, 1}}, {kOverSlipRate})};
  FrictionRun weak(small);
  weak.move_to(1, 1.0);
  CHECK(weak.last.onset == exactly(weak.last.limit / kStiffness));
  CHECK(weak.last.limit > 0.29);
  // A contact that the slip wears away is lost all the same.
  FrictionDefinition worn = slider(0.3, 0.0, allowable_slip(0.05));
  worn.internal_contact_force = make_function({{100, 0}, {0, 1}}, {kOverAccumulatedSlip});
  FrictionRun run(worn);
  run.move_to(1, 2.0);
  CHECK(run.state.regime == Regime::kOpen);
  CHECK(run.state.accumulated_slip == exactly(1.0));
}

TEST_CASE("a grip that the least slip wears away holds as long as it is there") {
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(kStiffness));
  definition.law = TabularCoefficient{make_function({{0, 0}, {0.2, 1}}, {kOverSlipRate})};
  definition.internal_contact_force = make_function({{100, 0}, {0, 5e-4}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.duration = 1e-3;
  run.move_to(1, 2e-4);
  CHECK(run.state.regime == Regime::kSlip);
  // 0.2 - 1000 x = 200 x (100 - 2e5 x)
  const double x = (21000.0 - std::sqrt(21000.0 * 21000.0 - 4.0 * 4e7 * 0.2)) / 8e7;
  CHECK(run.last.slip_increment == Approx(x).epsilon(1e-10));
}

TEST_CASE("where nothing held at rest the grip that wears away was lost before any slip") {
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(kStiffness));
  definition.law = TabularCoefficient{make_function({{0, 0}, {0.2, 1}}, {kOverSlipRate})};
  definition.internal_contact_force = make_function({{100, 0}, {0, 0.1}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 0.5);
  CHECK(run.state.regime == Regime::kOpen);
  CHECK(run.last.slip_increment == 0.0);
}

TEST_CASE("an increment without motion changes nothing, in stick and in slip") {
  for (const StickStiffness stick : both_modes()) {
    for (const double u : {0.0, 0.013, 0.2}) {
      FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
      run.position[1] = u;
      run.position[2] = 0.7 * u;
      run.step();
      const FrictionState before = run.state;
      for (int i = 0; i < 100; ++i) run.step();
      CHECK(run.state.force[0] == Approx(before.force[0]).epsilon(1e-15));
      CHECK(run.state.force[1] == Approx(before.force[1]).epsilon(1e-15));
      CHECK(run.state.accumulated_slip == before.accumulated_slip);
      CHECK(run.state.regime == Regime::kStick);
      CHECK(run.last.work == 0.0);
    }
  }
}

TEST_CASE("a reversal exactly on the limit sticks at once") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick));
    run.move_to(1, 0.1);
    run.move_to(1, 0.1 - 1e-9);
    CHECK(run.state.regime == Regime::kStick);
    CHECK(run.friction(1) == Approx(20.0 - 1e-6).epsilon(1e-12));
    // From +limit to -limit exactly: still stick.
    FrictionRun full(slider(0.2, 100.0, stick));
    full.move_to(1, 0.02);
    full.move_to(1, -0.02);
    CHECK(full.state.accumulated_slip == 0.0);
    CHECK(full.friction(1) == exactly(-20));
  }
}

TEST_CASE("in a plane, motion across the force at the limit slips only to second order") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
    run.move_to(2, 0.1);
    const double before = run.state.accumulated_slip;
    run.move_to(3, 1e-6);
    // slip = sqrt(g^2 + d^2) - g = d^2/(2 g); the rounding of g dominates.
    CHECK(run.state.accumulated_slip - before == Approx(2.5e-11).margin(1e-16));
  }
}

TEST_CASE("increments of a thousand million elastic slips keep their accuracy") {
  for (const StickStiffness stick : both_modes()) {
    FrictionRun run(slider(0.2, 100.0, stick, {2, 3}));
    run.position[1] = 3e7 * 0.4;
    run.position[2] = 4e7 * 0.4;
    run.step();
    CHECK(run.friction(2) == exactly(12));
    CHECK(run.friction(3) == exactly(16));
    CHECK(run.state.accumulated_slip == Approx(2e7 - 0.02).epsilon(1e-15));
    run.position[1] = -run.position[1];
    run.position[2] = -run.position[2];
    run.step();
    CHECK(run.friction(2) == exactly(-12));
    run.position[1] += 1e-2 * 0.6;  // the elastic slip has not drowned in the slip
    run.position[2] += 1e-2 * 0.8;
    run.step();
    CHECK(run.state.regime == Regime::kStick);
    CHECK(run.friction(2) == Approx(-6).epsilon(1e-6));  // rounding of the position, 1e7 by 1e-2
  }
}

TEST_CASE("implicit laws survive increments of a thousand million elastic slips") {
  for (const double factor : {1e3, 1e9}) {
    FrictionRun decay(falling());
    decay.duration = 1.0;
    decay.move_to(1, 0.03 * factor);
    CHECK(decay.friction(1) ==
          Approx(100.0 * (0.2 + 0.1 * std::exp(-0.05 * decay.last.slip_rate))).epsilon(1e-12));
    FrictionRun worn(linear_wear(AccumulatedSlipTiming::kEnd));
    worn.move_to(1, 0.02 * factor);
    CHECK(worn.friction(1) == Approx(0.0).margin(1e-12));
    // The internal contact force is worn off at a slip of 2: from there on there is no friction.
    CHECK(worn.state.accumulated_slip == Approx(2.0).epsilon(1e-12));
    CHECK(worn.state.regime == Regime::kOpen);
  }
}

/// All numbers of a result, to look for NaN.
std::vector<double> numbers(const FrictionUpdate& u) {
  std::vector<double> all(u.state.force.begin(), u.state.force.end());
  all.insert(all.end(), u.state.elastic_slip.begin(), u.state.elastic_slip.end());
  all.insert(all.end(), u.direction.begin(), u.direction.end());
  all.insert(all.end(), u.motion_direction.begin(), u.motion_direction.end());
  for (const double x :
       {double{u.state.accumulated_slip}, u.state.accumulated_slip.left_out(), u.tangent.transverse,
        u.tangent.radial, u.tangent.rate, u.tangent.contact, u.phi, u.normal_force, u.contact_force,
        u.mu, u.limit, u.slip_increment, u.slip_rate, u.dissipation, u.stored_energy, u.work}) {
    all.push_back(x);
  }
  return all;
}

TEST_CASE("degenerate increments give numbers, never NaN") {
  std::vector<FrictionLaw> laws = {ConstantCoefficient{0.0}, ConstantCoefficient{0.2},
                                   ExponentialDecay{0.3, 0.0, 5.0}, ExponentialDecay{0, 0, 0}};
  laws.push_back(TabularCoefficient{make_function({{0, 0}, {0.2, 1}, {0, 2}}, {kOverSlipRate})});
  laws.push_back(TabularCoefficient{
      make_function({{0.2, 0, 0}, {0, 0, 100}}, {kOverSlipRate, kOverContactForce})});
  for (const FrictionLaw& law : laws) {
    for (const StickStiffness stick : {fixed_stiffness(1e60), fixed_stiffness(1e-60),
                                       allowable_slip(1e-60), allowable_slip(1e3)}) {
      for (const double normal : {0.0, 1e-60, 1.0, 100.0, 1e60}) {
        for (const double duration : {0.0, 1e-12, 1.0}) {
          FrictionDefinition definition = slider(0.0, normal, stick, {2, 3});
          definition.law = law;
          FrictionRun run(definition);
          run.duration = duration;
          for (const double u : {0.0, 0.0, 1e-9, 1.0, 1.0, -2.0, 0.0}) {
            run.move_to(2, u);
            for (const double x : numbers(run.last)) {
              INFO("law " << law.index() << " stick " << stick.value << " N " << normal << " dt "
                          << duration << " u " << u);
              REQUIRE_FALSE(std::isnan(x));
            }
            const auto tangent = connector_tangent(definition, run.increment(), run.last);
            REQUIRE_FALSE(tangent.to_motion.hasNaN());
            REQUIRE_FALSE(tangent.to_force.hasNaN());
            CHECK(run.last.slip_increment >= 0.0);
            CHECK(run.last.dissipation >= 0.0);
            CHECK(std::hypot(run.state.force[0], run.state.force[1]) <=
                  run.last.limit * (1.0 + 1e-12));
          }
        }
      }
    }
  }
}

TEST_CASE("a wear table prolonged below zero leaves no contact, not a negative one") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(kStiffness));
  definition.internal_contact_force =
      make_function({{100, 0}, {50, 1}}, {kOverAccumulatedSlip}, 1, Extrapolation::kLinear);
  FrictionRun run(definition);
  run.ramp_to(1, 5.0, 50);
  CHECK(run.last.normal_force == 0.0);
  CHECK(run.friction(1) == 0.0);
  CHECK(run.state.regime == Regime::kOpen);
}

TEST_CASE("every dimension of the slip space slips along the motion") {
  for (int dimension = 1; dimension <= 6; ++dimension) {
    SlipSpace space;
    space.dimension = dimension;
    for (int i = 0; i < dimension; ++i) {
      space.component[static_cast<std::size_t>(i)] = i;
      space.scale[static_cast<std::size_t>(i)] = 1.0 + 0.5 * i;
    }
    for (const StickStiffness stick : both_modes()) {
      FrictionDefinition definition = slider(0.2, 100.0, stick);
      definition.slip = space;
      FrictionRun run(definition);
      double square = 0.0;
      for (int i = 0; i < dimension; ++i) {
        run.position[i] = 0.3 + 0.1 * i;
        square += std::pow(space.scale[static_cast<std::size_t>(i)] * run.position[i], 2);
      }
      run.step();
      CHECK(run.state.accumulated_slip == exactly(std::sqrt(square) - 0.02));
      for (int i = 0; i < dimension; ++i) {
        const double scale = space.scale[static_cast<std::size_t>(i)];
        CHECK(run.friction(i + 1) ==
              exactly(20.0 * scale * scale * run.position[i] / std::sqrt(square)));
      }
    }
  }
}

TEST_CASE("the old state is not touched and the same input gives the same result") {
  FrictionRun run(slider(0.2, 100.0, fixed_stiffness(kStiffness), {2, 3}));
  run.move_to(2, 0.1);
  const FrictionState old = run.state;
  run.position[2] = 0.05;
  const FrictionUpdate first = update(run.definition, run.increment(), run.state);
  const FrictionUpdate second = update(run.definition, run.increment(), run.state);
  CHECK(run.state == old);
  CHECK(first.state == second.state);
  CHECK(numbers(first) == numbers(second));
}

}  // namespace
