// SPDX-License-Identifier: Apache-2.0
#include "law/exact/continuous_update.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "law/friction/law_list.hpp"
#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;
using std::numbers::pi;

/// mu = 0.2 under |f3|, k = 1000 N/mm: the base set of the reference cases.
FrictionDefinition pressed(std::initializer_list<int> number = {1},
                           StickStiffness stick = fixed_stiffness(1000.0)) {
  FrictionDefinition definition = slider(0.2, 0.0, stick, number);
  definition.contact_force = DerivedComponent{norm_term({3}, 1.0)};
  return definition;
}

/// Returns P = |y - 1|.
Potential shifted_by_one() {
  Potential potential;
  potential.parts = potential.leaves = 1;
  potential.leaf[0].direction[0] = 1.0;
  potential.leaf[0].center = 1.0;
  potential.homogeneous = false;
  return potential;
}

/// The criteria of one component, a norm and a potential, and the tolerance of their methods.
struct Criterion {
  SlipCriterion of;
  double tolerance;
};
std::vector<Criterion> criteria_of_one() {
  Potential line;
  line.parts = line.leaves = 1;
  line.leaf[0].direction[0] = 1.0;
  return {{EuclideanPotential{}, 1e-13}, {line, 1e-9}};
}

/// The norm of two components as a potential: its closed solutions are those of the norm.
Potential norm_of_two() {
  Potential norm;
  norm.parts = norm.leaves = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    norm.leaf[i].part = static_cast<int>(i);
    norm.leaf[i].direction[i] = 1.0;
  }
  return norm;
}

TEST_CASE("an L-shaped path is exact with one increment a leg (reference case D1)") {
  struct Point {
    double travel, along, across;
  };
  const std::vector<Point> points{{.005, 19.3908725828043, 4.89837324807418},
                                  {.01, 17.7363776794015, 9.2423431452002},
                                  {.02, 12.9610854732777, 15.2318831191153},
                                  {.03, 8.50192069884561, 18.1029650728973},
                                  {.05, 3.26142463859956, 19.7322859630286}};
  for (const Point& point : points) {
    ExactRun run(pressed({1, 2}), at(0.0, 100.0));
    run.go(at(0.05, 100.0));
    run.go(at(0.05, 100.0, point.travel));
    CHECK(run.friction(1) == Approx(point.along).epsilon(2e-14));
    CHECK(run.friction(2) == Approx(point.across).epsilon(2e-14));
  }
  ExactRun run(pressed({1, 2}), at(0.0, 100.0));
  run.go(at(0.05, 100.0));
  run.go(at(0.05, 100.0, 0.05));
  CHECK(run.state.accumulated_slip == Approx(0.0662713633585835).epsilon(1e-14));
  // 20 N times the slip; the twelfth digit of the printed 1.32542726716717 is misplaced.
  CHECK(run.dissipation == Approx(20.0 * 0.0662713633585835).epsilon(1e-14));
  CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-14));
}

TEST_CASE("a limit that stays is exact at any tolerance whatever changes besides it") {
  // Reference case D1 while the temperature changes, of which the limit could be a function.
  FrictionDefinition definition = pressed({1, 2});
  definition.internal_contact_force = make_function({{50, 0}, {50, 100}}, {kOverTemperature});
  ExactRun run(definition, at(0.0, 50.0), 1e-3);
  run.go(at(0.05, 50.0));
  Waypoint end = at(0.05, 50.0, 0.05);
  end.temperature = 100.0;
  run.go(end);
  CHECK(run.friction(1) == Approx(3.26142463859956).epsilon(2e-14));
  CHECK(run.friction(2) == Approx(19.7322859630286).epsilon(2e-14));
  CHECK(run.state.accumulated_slip == Approx(0.0662713633585835).epsilon(1e-14));
}

TEST_CASE("an exact increment tells by how much the force is below the limit, or that it slips") {
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = pressed();
    definition.criterion = criterion.of;
    ExactRun run(definition, at(0.0, 100.0));
    CHECK(run.go(at(-0.005, 100.0)).phi == Approx(5.0 - 20.0));
    run.go(at(-0.05, 100.0));
    CHECK(run.last.phi == Approx(0.0).margin(1e-8));
    REQUIRE(run.changes.count > 0);
    const RegimeChange& slips = run.changes.at[static_cast<std::size_t>(run.changes.count - 1)];
    CHECK(slips.to == Regime::kSlip);
    CHECK(slips.force == Approx(-20.0));
  }
}

TEST_CASE("a limit that rises by 1e-7 of itself inside a segment is followed there") {
  // F_int over temperature: 100 up to 40, and rising to 60, where the segment ends.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force =
        make_function({{100, 0}, {100, 40}, {100.00001, 60}, {100, 61}}, {kOverTemperature});
    ExactRun run(definition);
    run.go(at(0.05));
    Waypoint end = at(0.1);
    end.temperature = 60.0;
    run.go(end);
    CHECK(run.friction(1) == Approx(20.000002).epsilon(criterion.tolerance));
  }
}

TEST_CASE("one, seven and a thousand increments a segment end alike on a polyline") {
  const std::vector<Waypoint> corners{at(0.05, 100.0),         at(0.05, 100.0, 0.05),
                                      at(-0.03, 100.0, 0.02),  at(-0.03, 100.0, -0.001),
                                      at(0.2, 100.0, -0.03),   at(0.19, 100.0, -0.025),
                                      at(0.195, 100.0, 0.001), at(0.0, 100.0)};
  for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.02)}) {
    std::vector<FrictionState> ends;
    std::vector<double> energies;
    for (const int count : {1, 7, 1000}) {
      ExactRun run(pressed({1, 2}, stick), at(0.0, 100.0));
      for (const Waypoint& corner : corners) run.go(corner, count);
      ends.push_back(run.state);
      energies.push_back(run.dissipation);
      CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-13));
    }
    for (std::size_t i = 1; i < ends.size(); ++i) {
      // Rounding of some thousand increments.
      CHECK(std::abs(ends[i].force[0] - ends[0].force[0]) <= 1e-12 * 20.0);
      CHECK(std::abs(ends[i].force[1] - ends[0].force[1]) <= 1e-12 * 20.0);
      CHECK(ends[i].accumulated_slip == Approx(ends[0].accumulated_slip).epsilon(1e-12));
      CHECK(energies[i] == Approx(energies[0]).epsilon(1e-12));
    }
  }
}

TEST_CASE("a normal force in phase with the motion gives the quadrilateral (reference case N1)") {
  // N = 100 + 500 u; one increment a half cycle, the corners lie inside of it.
  const auto point = [](double u) { return at(u, 100.0 + 500.0 * u); };
  ExactRun run(pressed(), point(0.0));
  run.go(point(0.1));
  CHECK(run.friction(1) == Approx(30.0).epsilon(1e-14));
  run.dissipation = run.work = 0.0;
  const double stored = run.last.stored_energy;
  run.go(point(-0.1));
  CHECK(run.friction(1) == Approx(-10.0).epsilon(1e-13));
  REQUIRE(run.changes.count == 2);
  CHECK(run.changes.at[0].to == Regime::kStick);
  CHECK(run.changes.at[0].fraction == 0.0);
  CHECK(run.changes.at[1].to == Regime::kSlip);
  CHECK(0.1 - 0.2 * run.changes.at[1].fraction == Approx(0.0454545454545455).epsilon(1e-13));
  CHECK(run.changes.at[1].force == Approx(-24.5454545454545).epsilon(1e-13));
  CHECK(run.last.onset == run.changes.at[1].fraction);
  run.go(point(0.1));
  CHECK(run.changes.at[1].force == Approx(12.2222222222222).epsilon(1e-13));
  CHECK(run.dissipation == Approx(608.0 / 99.0).epsilon(1e-13));
  CHECK(run.work == Approx(run.dissipation + run.last.stored_energy - stored).epsilon(1e-13));
}

TEST_CASE("with a limit that grows faster than the spring slip never begins (N1, wedging)") {
  const auto point = [](double u) { return at(u, 100.0 + 6000.0 * u); };
  ExactRun run(pressed(), point(0.0));
  run.go(point(0.5));
  CHECK(run.last.state.regime == Regime::kStick);
  CHECK(run.friction(1) == Approx(500.0));
  CHECK(run.last.slip_increment == 0.0);
}

TEST_CASE(
    "a force that is turned sticks under a limit that grows faster than its part of the motion") {
  // On the limit, 60 degrees from the motion: of 0.01 that turns 0.005 at most, while R grows by
  // 0.01.
  ExactRun run(pressed({1, 2}), at(0.0, 100.0));
  run.go(at(0.02, 100.0));
  run.go(at(0.025, 150.0, 0.01 * std::sqrt(0.75)));
  CHECK(run.changes.count == 0);
  CHECK(run.last.slip_increment == 0.0);
  CHECK(run.friction(1) == Approx(25.0));
}

TEST_CASE("unloading at rest slips, reloading does not (reference case N4)") {
  ExactRun run(pressed(), at(0.0, 100.0));
  run.go(at(0.015, 100.0));
  CHECK(run.friction(1) == Approx(15.0).epsilon(1e-15));
  run.go(at(0.015, 25.0));
  CHECK(run.friction(1) == Approx(5.0).epsilon(1e-14));
  CHECK(run.state.accumulated_slip == Approx(0.010).epsilon(1e-13));
  CHECK(run.dissipation == Approx(0.1).epsilon(1e-13));
  REQUIRE(run.changes.count == 1);
  CHECK(run.changes.at[0].fraction == Approx(1.0 / 3.0).epsilon(1e-13));
  run.go(at(0.015, 150.0));
  CHECK(run.friction(1) == Approx(5.0).epsilon(1e-14));
  CHECK(run.state.accumulated_slip == Approx(0.010).epsilon(1e-13));
  CHECK(run.dissipation == Approx(0.1).epsilon(1e-13));
}

TEST_CASE("lift-off forgets the force; contact that returns counts from there (N5)") {
  // N goes straight from 100 to -100 under a Macauley sum: open in the second half.
  FrictionDefinition definition = pressed();
  DerivedTerm term = norm_term({3}, 1.0);
  term.combine = TermOperator::kMacauleySum;
  definition.contact_force = DerivedComponent{term};
  ExactRun run(definition, at(0.0, 100.0));
  run.go(at(0.1, 100.0));
  run.go(at(0.1, -100.0));
  CHECK(run.last.state.regime == Regime::kOpen);
  CHECK(run.friction(1) == 0.0);
  // The spring came to rest by slip: all its energy is dissipated.
  CHECK(run.work == Approx(run.dissipation).epsilon(1e-13));
  CHECK(run.state.accumulated_slip == Approx(0.1).epsilon(1e-13));
  // N = -100 + 300 tau returns at tau = 1/3; by then 0.004 of the motion of 0.012 is over.
  run.go(at(0.112, 200.0));
  REQUIRE(run.changes.count >= 1);
  CHECK(run.changes.at[0].fraction == Approx(1.0 / 3.0).epsilon(1e-12));
  // mu dN = 60 N per 0.012 mm outruns k du = 12 N: stick with 1000 N/mm * 0.008 mm.
  CHECK(run.friction(1) == Approx(8.0).epsilon(1e-11));
  CHECK(run.last.state.regime == Regime::kStick);
}

TEST_CASE("a force without contact at its begin is gone without slip, contact behind or not") {
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double motion : {0.0, 0.005}) {
      for (const double force : {0.0, 100.0}) {
        for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.02)}) {
          const bool fixed = stick.mode == StickStiffness::Mode::kStiffness;
          CAPTURE(criterion.tolerance, motion, force, fixed);
          FrictionDefinition definition = pressed({1}, stick);
          definition.criterion = criterion.of;
          // A contact force of rounding is none.
          ExactRun run(definition, at(0.0, motion * force > 0.0 ? 1e-11 : 0.0));
          run.state.force[0] = 10.0;
          run.state.elastic_slip[0] = 0.01;
          run.state.regime = Regime::kStick;
          run.go(at(motion, force));
          CHECK(run.friction(1) == Approx(force > 0.0 ? 1000.0 * motion : 0.0).epsilon(1e-12));
          CHECK(run.state.accumulated_slip == 0.0);
          CHECK(run.last.dissipation == 0.0);
          CHECK(run.last.lost == Approx(fixed ? 0.05 : 0.0));
          REQUIRE(run.changes.count > 0);
          CHECK(run.changes.at[0].to == Regime::kOpen);
          CHECK(run.changes.at[0].fraction == 0.0);
        }
      }
    }
  }
}

TEST_CASE("a contact force that changes its sign opens for an instant") {
  for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.02)}) {
    for (const Criterion& criterion : criteria_of_one()) {
      FrictionDefinition definition = slider(0.2, 0.0, stick);
      definition.criterion = criterion.of;
      definition.contact_force = ComponentContactForce{2};
      ExactRun run(definition, at(0.0, 100.0));
      run.go(at(0.01, 100.0));
      CHECK(run.friction(1) == Approx(10.0));
      run.go(at(0.01, -100.0));
      // Nothing has moved since contact returned.
      CHECK(run.friction(1) == Approx(0.0).margin(criterion.tolerance));
      REQUIRE(run.changes.count >= 2);
      const RegimeChange& last = run.changes.at[static_cast<std::size_t>(run.changes.count - 1)];
      CHECK(last.to == Regime::kStick);
      CHECK(last.fraction == Approx(0.5).epsilon(1e-12));
    }
  }
}

TEST_CASE("with an elastic slip the force scales with the limit while it sticks") {
  ExactRun run(pressed({1}, allowable_slip(0.02)), at(0.0, 100.0));
  run.go(at(0.01, 100.0));
  CHECK(run.friction(1) == Approx(10.0).epsilon(1e-14));
  run.go(at(0.01, 30.0));
  CHECK(run.friction(1) == Approx(3.0).epsilon(1e-14));
  CHECK(run.dissipation == 0.0);
  // Slip over 0.05 while N goes from 30 to 90: dissipation is the mean limit over the slip part.
  run.go(at(0.06, 90.0));
  const double onset = 0.2;  // 0.01 mm of 0.05 to the allowable slip
  const double mean = 0.5 * 0.2 * ((30.0 + 60.0 * onset) + 90.0);
  CHECK(run.state.accumulated_slip == Approx(0.04).epsilon(1e-13));
  CHECK(run.dissipation == Approx(mean * 0.04).epsilon(1e-11));
  CHECK(run.friction(1) == Approx(18.0).epsilon(1e-14));
}

TEST_CASE("linear wear has the closed solution, reversals too (reference case W1)") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force =
      make_function({{100.0, 0.0}, {0.0, 2.0}}, {{IndependentKind::kAccumulatedSlip}});
  ExactRun run(definition, at(0.0));
  run.go(at(0.1));
  CHECK(run.friction(1) == Approx(19.1919191919192).epsilon(1e-13));
  CHECK(run.state.accumulated_slip == Approx(0.0808080808080808).epsilon(1e-13));
  const std::vector<double> forces{
      17.5594327109479, 15.8939667051084, 14.1948549213732, 12.4614176470575, 10.6929614379072,
      8.8887788406932,  7.04814811020215, 5.17033292050927, 3.25458207041855, 1.30012918295226};
  double side = -1.0;
  for (const double force : forces) {
    run.go(at(0.1 * side));
    CHECK(run.friction(1) == Approx(side * force).epsilon(1e-12));
    side = -side;
  }
  CHECK(run.state.accumulated_slip == Approx(1.86998708170477).epsilon(1e-12));
  CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-12));
}

TEST_CASE("slip that wears the limit away opens where it does") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  // A limit that more slip would bring back is out of reach.
  const Rows gone{{100.0, 0.0}, {0.0, 0.5}};
  const Rows back{{100.0, 0.0}, {0.0, 0.5}, {0.0, 0.6}, {100.0, 0.7}};
  for (const Rows& rows : {gone, back}) {
    definition.internal_contact_force = make_function(rows, {{IndependentKind::kAccumulatedSlip}});
    for (const Criterion& criterion : criteria_of_one()) {
      definition.criterion = criterion.of;
      for (const int count : {1, 7, 100}) {
        ExactRun run(definition, at(0.0));
        run.go(at(2.0), count);
        CHECK(run.state.regime == Regime::kOpen);
        CHECK(run.state.accumulated_slip == Approx(0.5).epsilon(1e-9));
        CHECK(run.friction(1) == 0.0);
        // mu integral F_int ds = 0.2 * 100 * 0.5 / 2
        CHECK(run.dissipation == Approx(5.0).epsilon(1e-9));
        // The limit falls by 40 N/mm, the spring by 1000.
        if (count == 1) CHECK(run.last.snap_back == Approx(0.04).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("a limit that wears faster than the spring lets the force jump, with its energy booked") {
  // 3000 N on 1000 N/mm; between 0.5 and 1.5 mm of slip the limit falls by 3000 N/mm: beta = 3. And
  // the same in units of length in which all of it is small.
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double unit : {1.0, 1e-9}) {
      for (const int count : {1, 3, 10}) {
        FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0 / unit));
        definition.criterion = criterion.of;
        definition.contact_force = NoContactForce{};
        definition.internal_contact_force =
            make_function({{6000, 0}, {6000, 0.5 * unit}, {0, 1.5 * unit}}, {kOverAccumulatedSlip});
        ExactRun run(definition);
        double lost = 0.0;
        double snap_back = 0.0;
        int jumps = 0;
        for (int i = 1; i <= count; ++i) {
          run.go(at(6.0 * unit * i / count));
          lost += run.last.lost;
          snap_back = std::max(snap_back, run.last.snap_back);
          jumps += run.last.jumps;
          if (run.last.jumps > 0) {
            // At 3.5 mm of motion.
            CHECK((i - 1 + run.last.jump_onset) / count == Approx(3.5 / 6.0));
          }
        }
        CHECK(jumps == 1);
        CHECK(snap_back == Approx(3.0));
        // Nothing is left to slip on behind 1.5 mm: the spring relaxes by its 3 mm without
        // friction.
        const double near = 10.0 * criterion.tolerance;
        CHECK(run.state.accumulated_slip / unit == Approx(1.5).epsilon(near));
        CHECK(run.dissipation / unit == Approx(3000.0 * 0.5 + 1500.0 * 1.0).epsilon(near));
        CHECK(lost / unit == Approx(4500.0 - 1500.0).epsilon(near));
        CHECK(run.work == Approx(run.dissipation + lost).epsilon(near));
      }
    }
  }
}

TEST_CASE("the steepest wear of a jump is told wherever it is between knots") {
  // The wear begins at beta = 3 and is 30 for a hundredth of a millimetre.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force = make_function(
        {{6000, 0}, {6000, 0.5}, {5040, 0.66}, {4440, 0.67}, {0, 2.0}}, {kOverAccumulatedSlip});
    ExactRun run(definition);
    run.go(at(6.0));
    CHECK(run.last.snap_back == Approx(30.0).epsilon(1e-9));

    // And where the coefficient falls by 0.05 between 4440 and 4380 N, of which 6000 N wear a mm.
    definition.internal_contact_force =
        make_function({{6000, 0}, {6000, 0.5}, {0, 1.5}}, {kOverAccumulatedSlip});
    definition.law = TabularCoefficient{make_function(
        {{0.45, 0.0}, {0.45, 4380.0}, {0.5, 4440.0}, {0.5, 7000.0}}, {kOverContactForce})};
    ExactRun falling(definition);
    falling.go(at(6.0));
    CHECK(falling.last.snap_back == Approx(6.0 * (0.5 + 0.05 / 60.0 * 4440.0)).epsilon(1e-9));

    // F_lim = 1.2e-4 F^2 - 1e-8 F^3 is steepest at 4000 N, by 0.48.
    ModifiedDarmstad bent;
    bent.c1 = -1e-8;
    bent.c3 = 1.2e-4;
    definition.law = bent;
    ExactRun bending(definition);
    bending.go(at(6.0));
    CHECK(bending.last.snap_back == Approx(6.0 * 0.48).epsilon(1e-9));
  }
}

TEST_CASE("a force beyond a limit that wears away relaxes with all of its energy dissipated") {
  // 30 N over 20 N that fall by 1000 N/mm, as the spring.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force =
        make_function({{100, 0}, {0, 0.02}}, {kOverAccumulatedSlip});
    ExactRun run(definition);
    run.state.force[0] = 30.0;
    run.state.elastic_slip[0] = 0.03;
    run.state.regime = Regime::kStick;
    run.go(at(0.0));
    CAPTURE(criterion.tolerance);
    CHECK(run.friction(1) == Approx(0.0).margin(1e-9));
    CHECK(run.state.accumulated_slip == Approx(0.02).epsilon(1e-9));
    CHECK(run.dissipation == Approx(0.45).epsilon(1e-9));
    CHECK(run.last.lost == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("a viscous force that begins without contact is gone, too") {
  for (const double force : {0.0, 100.0}) {
    FrictionDefinition definition = pressed();
    definition.law = TabularCoefficient{make_function({{0.1, 0}, {0.5, 2}}, {kOverSlipRate})};
    ExactRun run(definition);
    run.state.force[0] = 10.0;
    run.state.elastic_slip[0] = 0.01;
    run.state.regime = Regime::kStick;
    run.go(at(0.005, force));
    CAPTURE(force);
    CHECK(run.friction(1) == Approx(force > 0.0 ? 5.0 : 0.0).epsilon(1e-9));
    CHECK(run.state.accumulated_slip == 0.0);
    CHECK(run.last.dissipation == 0.0);
  }
}

TEST_CASE("a viscous force falls at once from what no rate holds, with its energy dissipated") {
  // 20 N under a contact force that has fallen to 1 N: 0.5 N are held at most, 0.1 N at last.
  FrictionDefinition definition = pressed();
  definition.law = TabularCoefficient{make_function({{0.1, 0}, {0.5, 2}}, {kOverSlipRate})};
  ExactRun run(definition, at(0.0, 1.0));
  run.state.force[0] = 20.0;
  run.state.elastic_slip[0] = 0.02;
  run.state.regime = Regime::kSlip;
  run.go(at(0.0, 1.0));
  CHECK(run.last.converged);
  CHECK(run.friction(1) == Approx(0.1).epsilon(1e-6));
  CHECK(run.dissipation == Approx((400.0 - 0.01) / 2000.0).epsilon(1e-7));
}

TEST_CASE("a limit that wears as fast as the spring lets the force go at once, with its energy") {
  // 50 N that fall by 1000 N/mm on a spring of 1000 N/mm.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force =
        make_function({{100.0, 0.0}, {0.0, 0.05}}, {kOverAccumulatedSlip});
    ExactRun run(definition);
    run.go(at(0.06));
    CHECK(run.friction(1) == Approx(0.0).margin(1e-6));
    CHECK(run.state.accumulated_slip == Approx(0.05).epsilon(1e-8));
    CHECK(run.dissipation == Approx(1.25).epsilon(1e-8));
    CHECK(run.last.lost == Approx(0.0).margin(1e-8));
    CHECK(run.last.snap_back == Approx(1.0).epsilon(1e-12));
  }
}

/// Returns the end of a way on which the temperature goes from 0 to 1 and the motion to 2.
Waypoint warm_at_two() {
  Waypoint end = at(2.0);
  end.temperature = 1.0;
  return end;
}

TEST_CASE("the steepest wear is told to the end of a piece, whatever steps come there") {
  // At the temperature T in [0, 1] F_int falls by 20 + 80 T per slip, up to a slip of 1.
  FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force =
      make_function({{500, 0, 0}, {480, 1, 0}, {480, 9, 0}, {500, 0, 1}, {400, 1, 1}, {400, 9, 1}},
                    {kOverAccumulatedSlip, kOverTemperature});
  for (const Criterion& criterion : criteria_of_one()) {
    definition.criterion = criterion.of;
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
      INFO("tolerance " << tolerance);
      ExactRun run(definition, {}, tolerance);
      run.go(warm_at_two());
      // At L = 1 the spring holds (480 - 80 T) / 2 = 1000 (s - 1), with T = s / 2: s = 1.24 / 1.02.
      CHECK(run.last.snap_back == Approx((10.0 + 20.0 * 1.24 / 1.02) / 1000.0).epsilon(1e-5));
    }
  }
}

TEST_CASE("the steepest wear is told where it lies inside of a piece") {
  // At the temperature T the coefficient is 0.5 - 0.3 T, and F_int falls by 20 + 120 T per slip:
  // the limit falls fastest at T = 0.75, by 0.275 * 110.
  FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = NoContactForce{};
  definition.law = TabularCoefficient{make_function({{0.5, 0}, {0.2, 1}}, {kOverTemperature})};
  definition.internal_contact_force =
      make_function({{600, 0, 0}, {520, 4, 0}, {600, 0, 1}, {40, 4, 1}},
                    {kOverAccumulatedSlip, kOverTemperature});
  for (const Criterion& criterion : criteria_of_one()) {
    definition.criterion = criterion.of;
    ExactRun run(definition);
    run.go(warm_at_two());
    // A potential is looked at where its sub-increments end.
    const bool by_events = std::holds_alternative<EuclideanPotential>(criterion.of);
    CHECK(run.last.snap_back == Approx(0.03025).epsilon(by_events ? 1e-12 : 1e-2));
  }
}

TEST_CASE("a contact that slip builds up opens all the same where time takes it") {
  // F_int = 10 + 2 L - 40 T, never below 0, while the motion goes from 0 to 2 and T from 0 to 1:
  // slip ends at L = 2 T = 10 / 18.
  FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1e5));
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force = make_function(
      {{10, 0, 0}, {14, 2, 0}, {-30, 0, 1}, {-26, 2, 1}}, {kOverAccumulatedSlip, kOverTemperature});
  for (const Criterion& criterion : criteria_of_one()) {
    definition.criterion = criterion.of;
    ExactRun run(definition);
    run.go(warm_at_two());
    CHECK(run.last.converged);
    CHECK(run.state.regime == Regime::kOpen);
    CHECK(run.state.accumulated_slip == Approx(10.0 / 18.0).epsilon(1e-9));
    CHECK(run.friction(1) == 0.0);
  }
}

TEST_CASE("a viscous joint lifts off at the very end of an increment") {
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
  definition.contact_force = DerivedComponent{norm_term({3}, 1.0)};
  definition.law = TabularCoefficient{make_function({{0.2, 0}, {0.3, 10}}, {kOverSlipRate})};
  for (const int count : {1, 10}) {
    ExactRun run(definition, at(0.0, 100.0), 1e-10);
    run.go(at(5.0, 100.0), count);
    CHECK(run.friction(1) == Approx(25.0).epsilon(1e-9));
    run.go(at(10.0), count);
    CHECK(run.last.converged);
    CHECK(run.state.regime == Regime::kOpen);
    CHECK(run.state.accumulated_slip == Approx(10.0).epsilon(1e-9));
    CHECK(run.work == Approx(run.dissipation).epsilon(1e-9));
  }
}

TEST_CASE("a viscous joint turns back while the last of its contact wears away") {
  FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0), {1, 2});
  definition.contact_force = NoContactForce{};
  definition.internal_contact_force = make_function({{1000, 0}, {0, 1}}, {kOverAccumulatedSlip});
  definition.law = TabularCoefficient{make_function({{0, 0}, {0.3, 4}}, {kOverSlipRate})};
  for (const int count : {1, 3}) {
    ExactRun run(definition, {}, 1e-10);
    run.go(at(0.999), count);
    CHECK(run.state.regime == Regime::kSlip);
    run.go(at(0.5), count);
    CHECK(run.last.converged);
    CHECK(run.state.regime == Regime::kOpen);
    CHECK(run.state.accumulated_slip == Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("a force turns over in less of an increment than rounding") {
  FrictionDefinition definition = pressed();
  definition.law = ConstantCoefficient{1e-30};
  ExactRun run(definition, at(0.0, 100.0));
  run.go(at(1.0, 100.0));
  run.go(at(0.0, 110.0));
  CHECK(run.last.converged);
  CHECK(run.state.regime == Regime::kSlip);
  CHECK(run.friction(1) == Approx(-1.1e-28).epsilon(1e-12));
  CHECK(run.state.accumulated_slip == Approx(2.0).epsilon(1e-12));
}

TEST_CASE("a jump lands on the first equilibrium of several, and the next begins at a peak") {
  for (const double unit : {1.0, 1e-4}) {  // of force
    for (const Criterion& criterion : criteria_of_one()) {
      const double within = criterion.tolerance;
      FrictionDefinition definition;
      definition.criterion = criterion.of;
      definition.contact_force = NoContactForce{};
      definition.internal_contact_force = make_function(
          {{100 * unit, 0}, {50 * unit, 0.1}, {95 * unit, 0.15}, {20 * unit, 0.3}, {20 * unit, 10}},
          {kOverAccumulatedSlip});
      definition.law = ConstantCoefficient{1.0};
      definition.stick = fixed_stiffness(100.0 * unit);
      // From 100 N the spring's 100 (1 - x) meets 50 + 900 (x - 0.1) at x = 0.14, not 20 at 0.8.
      ExactRun run(definition);
      run.go(at(1.05));
      CHECK(run.friction(1) / unit == Approx(90.5).epsilon(within));
      CHECK(run.last.slip_increment == Approx(0.145).epsilon(within));
      CHECK(run.last.jumps == 1);
      CHECK(run.last.lost / unit == Approx(2.8).epsilon(within));
      CHECK(run.last.snap_back == Approx(5.0).epsilon(within));
      // Along the rising limit to 95 at x = 0.15, and from there to 20.
      run.go(at(1.3));
      CHECK(run.friction(1) / unit == Approx(20.0).epsilon(within));
      CHECK(run.last.slip_increment == Approx(1.1 - 0.145).epsilon(within));
      CHECK(run.last.jumps == 1);
      CHECK(run.last.lost / unit == Approx(22.5).epsilon(within));
      CHECK(run.last.snap_back == Approx(5.0).epsilon(within));
    }
  }
}

TEST_CASE("a force at rest jumps as well once its limit has come down to it") {
  // F = 1100 N at rest, F_C from 1000 N to 50 N: at 100 N force and limit are 1000 N where the wear
  // begins to let the limit fall by 1500 N/mm, to 25 N. They meet there again.
  for (const double unit : {1.0, 1e-9}) {
    FrictionDefinition definition = slider(0.25, 0.0, fixed_stiffness(1000.0 / unit));
    definition.contact_force = ComponentContactForce{2};
    definition.internal_contact_force =
        make_function({{4000, 0}, {3900, 0.1 * unit}, {0, 0.75 * unit}}, {kOverAccumulatedSlip});
    ExactRun run(definition, at(0.0, 1000.0));
    run.go(at(1.1 * unit, 1000.0));
    run.go(at(1.1 * unit, 50.0));
    CHECK(run.last.jumps == 1);
    CHECK(run.last.jump_onset == Approx(900.0 / 950.0).epsilon(1e-9));
    // What the spring held, less (1000 N + 25 N)/2 over 0.65 mm and 25 N over 0.325 mm.
    CHECK(run.last.lost / unit == Approx(500.0 - 0.3125 - 341.25).epsilon(1e-9));
    CHECK(run.friction(1) == Approx(12.5).epsilon(1e-9));
    CHECK(run.state.accumulated_slip / unit == Approx(1.0875).epsilon(1e-10));
  }
}

TEST_CASE(
    "a jump is met where a cell begins, and inside of one that bends over the contact force") {
  const auto run_to = [](const FrictionDefinition& definition, double way, int count) {
    ExactRun run(definition);
    double lost = 0.0;
    for (int i = 1; i <= count; ++i) {
      run.go(at(way * i / count));
      lost += run.last.lost;
    }
    CHECK(run.work == Approx(run.dissipation + lost + run.last.stored_energy).epsilon(1e-12));
    return std::array{double{run.state.accumulated_slip}, run.dissipation, lost};
  };
  const auto slider_on = [](const std::vector<std::vector<double>>& wear) {
    FrictionDefinition definition = slider(0.25, 0.0, fixed_stiffness(1000.0));
    definition.contact_force = NoContactForce{};
    definition.internal_contact_force =
        make_function(wear, {{IndependentKind::kAccumulatedSlip, 0}});
    return definition;
  };
  for (const int count : {1, 3, 50}) {
    // beta 0.25 to 1 mm, then 1.5: from 750 N the spring loses 281.25 N mm, friction takes 187.5.
    const auto worn = run_to(slider_on({{4000, 0}, {3000, 1}, {0, 1.5}}), 8.0, count);
    CHECK(worn[0] == Approx(1.5).epsilon(1e-11));
    CHECK(worn[1] == Approx(875.0 + 187.5).epsilon(1e-11));
    CHECK(worn[2] == Approx(93.75).epsilon(1e-10));
    // Behind a limit that rises: 1250 N at 1 mm, beta 1.125 down to 125 N at 2 mm.
    const auto risen = run_to(slider_on({{1000, 0}, {5000, 1}, {500, 2}}), 8.0, count);
    CHECK(risen[2] == Approx(70.3125).epsilon(1e-10));

    // F_N = 1000 (1 - x), mu = 0.1 + 0.8 x down to 500 N, then 0.5: a parabola to 250 N, then
    // 500 (1 - x). At 400 N/mm that falls faster than the spring, in the middle of the cell of
    // wear, and is met again nowhere.
    FrictionDefinition bent = slider_on({{1000, 0}, {0, 1}});
    bent.stick = fixed_stiffness(400.0);
    bent.law = TabularCoefficient{
        make_function({{0.5, 0}, {0.5, 500}, {0.1, 1000}}, {{IndependentKind::kContactForce, 0}})};
    const auto parabola = run_to(bent, 2.0, count);
    CHECK(parabola[0] == Approx(1.0).epsilon(1e-9));
    // 1000 (0.1 x + 0.7 x^2/2 - 0.8 x^3/3) to 0.5, then a triangle.
    CHECK(parabola[1] == Approx(1000.0 * (0.05 + 0.0875 - 0.1 / 3.0) + 62.5).epsilon(1e-9));
    CHECK(parabola[2] == Approx(250.0 * 250.0 / 800.0 - 62.5).epsilon(1e-9));
  }
}

TEST_CASE("a jump begins where a smooth limit falls faster than the spring follows") {
  // F_N = 1000 (1 - x), mu = 0.1 + 0.8 x to x = 0.5: 1000 (0.1 + 0.7 x - 0.8 x^2), which falls by
  // 50 N/mm at x = 0.46875. Behind 0.5 it is 500 (1 - x), and force and limit meet nowhere.
  for (const int count : {1, 3}) {
    FrictionDefinition definition = slider(0.25, 0.0, fixed_stiffness(50.0));
    definition.contact_force = NoContactForce{};
    definition.internal_contact_force = make_function({{1000, 0}, {0, 1}}, {kOverAccumulatedSlip});
    definition.law =
        TabularCoefficient{make_function({{0.5, 0}, {0.5, 500}, {0.1, 1000}}, {kOverContactForce})};
    ExactRun run(definition);
    double lost = 0.0;
    for (int i = 1; i <= count; ++i) {
      run.go(at(8.0 * i / count));
      lost += run.last.lost;
    }
    const double x = 0.46875;
    const double force = 1000.0 * (0.1 + x * (0.7 - x * 0.8));
    const double before = 1000.0 * x * (0.1 + x * (0.35 - x * 0.8 / 3.0));
    const double all = 1000.0 * (0.05 + 0.0875 - 0.1 / 3.0) + 62.5;
    CHECK(run.state.accumulated_slip == Approx(1.0).epsilon(1e-9));
    CHECK(run.dissipation == Approx(all).epsilon(1e-9));
    CHECK(lost == Approx(force * force / 100.0 - (all - before)).epsilon(1e-9));
    CHECK(run.work == Approx(run.dissipation + lost).epsilon(1e-9));
  }
}

TEST_CASE("slip that wears the contact force through 0 goes on behind") {
  // F_C + F_int = 50 + 50 u - 100 L, with R = 0.5 |F_C + F_int|/k: 0 at L = 0.5 + 0.5 u = u.
  // Behind, L + 0.5 (100 L - 50 - 50 u)/1000 = u.
  for (const int count : {1, 7, 50}) {
    FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
    definition.contact_force = ComponentContactForce{1};
    definition.internal_contact_force =
        make_function({{150, 0}, {0, 1.5}}, {{IndependentKind::kAccumulatedSlip, 0}});
    Waypoint begin = at(0.0);
    begin.force[1] = -100.0;
    Waypoint end = at(1.4);
    end.force[1] = -30.0;
    ExactRun run(definition, begin);
    run.go(end, count);
    const double slip = (1.4 + 0.025 + 0.025 * 1.4) / 1.05;
    CHECK(run.state.accumulated_slip == Approx(slip).epsilon(1e-12));
    CHECK(run.friction(1) == Approx(1000.0 * (1.4 - slip)).epsilon(1e-10));
    CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-12));
  }
}

TEST_CASE("a varying limit on a turning path: increments do not matter, the energies close") {
  const std::vector<Waypoint> corners{at(0.05, 130.0), at(0.05, 60.0, 0.05), at(-0.03, 20.0, 0.02),
                                      at(-0.03, 140.0, -0.01), at(0.1, 80.0, 0.1)};
  std::vector<FrictionState> ends;
  std::vector<double> energies;
  for (const int count : {1, 7, 300}) {
    ExactRun run(pressed({1, 2}), at(0.0, 100.0), 1e-12);
    for (const Waypoint& corner : corners) run.go(corner, count);
    ends.push_back(run.state);
    energies.push_back(run.dissipation);
    CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-12));
  }
  for (std::size_t i = 1; i < ends.size(); ++i) {
    // The tolerance of the integration, a few hundred times over.
    CHECK(std::abs(ends[i].force[0] - ends[0].force[0]) <= 1e-11 * 16.0);
    CHECK(std::abs(ends[i].force[1] - ends[0].force[1]) <= 1e-11 * 16.0);
    CHECK(ends[i].accumulated_slip == Approx(ends[0].accumulated_slip).epsilon(1e-11));
    CHECK(energies[i] == Approx(energies[0]).epsilon(1e-11));
  }
}

TEST_CASE("slip under a limit that changes linearly turns by a power of the limit") {
  // Without an event: from a right angle on, tan(psi/2) = (lim/lim0)^(-k len/dlim) tan(psi0/2).
  ExactRun run(pressed({1, 2}), at(0.0, 100.0));
  run.go(at(0.05, 100.0));
  run.go(at(0.05, 50.0, 0.02));
  const double turn = 1000.0 * 0.02 / 10.0 * std::log(20.0 / 10.0);
  const double half = std::exp(-turn);
  const double cosine = (1.0 - half * half) / (1.0 + half * half);
  CHECK(run.friction(2) == Approx(10.0 * cosine).epsilon(1e-11));
  CHECK(run.last.state.regime == Regime::kSlip);
}

TEST_CASE("a limit that jumps down relaxes the spring at once whatever it does later") {
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double unit : {1.0, 1e-6}) {  // of length
      for (const double motion : {0.0, 0.01}) {
        for (const double later : {40.0, 1e5}) {
          FrictionDefinition definition = pressed({1}, fixed_stiffness(1000.0 / unit));
          definition.criterion = criterion.of;
          ExactRun run(definition, at(0.0, 100.0));
          run.go(at(0.1 * unit, 100.0));
          // The history begins its next piece at N = 40.
          ConnectorIncrement increment;
          increment.duration = 1.0;
          increment.begin_position = run.here().position;
          increment.end.position = increment.begin_position;
          const Ambient begin = increment.end;
          ConnectorForce begin_force;
          begin_force[2] = 40.0;
          increment.end.position[0] += motion * unit;
          increment.force[2] = later;
          RegimeChanges changes;
          const FrictionUpdate u = continuous_update(
              run.definition, path_segment(run.definition, increment, begin, begin_force),
              run.state, 1e-12, &changes);
          // A limit that grows again holds all that the motion adds.
          const double slip = later > 40.0 ? 0.0 : motion;
          const double force = 8.0 + 1000.0 * (motion - slip);
          CHECK(u.state.force[0] == Approx(force).epsilon(later > 40.0 ? 1e-8 : 1e-14));
          CHECK(u.slip_increment / unit == Approx(0.012 + slip).epsilon(criterion.tolerance));
          // (20^2 - 8^2)/(2 k), and 8 N over the motion
          CHECK(u.dissipation / unit == Approx(0.168 + 8.0 * slip).epsilon(criterion.tolerance));
          CHECK(u.work / unit ==
                Approx(0.5 * (8.0 + force) * motion).epsilon(std::max(criterion.tolerance, 1e-8)));
        }
      }
    }
  }
}

TEST_CASE("an allowable elastic slip that jumps down relaxes the spring at once") {
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double motion : {0.0, 0.01}) {
      FrictionDefinition definition = pressed({1}, allowable_slip(0.02));
      definition.criterion = criterion.of;
      ExactRun run(definition, at(0.0, 100.0));
      run.go(at(0.1, 100.0));
      run.definition.stick.value = 0.008;
      run.go(at(0.1 + motion, 100.0));
      CHECK(run.friction(1) == Approx(20.0).epsilon(1e-13));
      CHECK(run.last.slip_increment == Approx(0.012 + motion).epsilon(criterion.tolerance));
      CHECK(run.last.dissipation == Approx(20.0 * (0.012 + motion)).epsilon(criterion.tolerance));
      CHECK(run.last.work == Approx(20.0 * motion).epsilon(criterion.tolerance).margin(1e-10));
    }
  }
}

TEST_CASE("slip that happens at once has no rate: the limit is that at rest") {
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = pressed({1}, allowable_slip(0.02));
    definition.criterion = criterion.of;
    definition.law = TabularCoefficient{make_function({{0.2, 0.0}, {0.1, 1.0}}, {kOverSlipRate})};
    ExactRun run(definition, at(0.0, 100.0));
    run.go(at(0.1, 100.0));
    run.definition.stick.value = 0.008;
    run.go(at(0.1, 100.0));
    CHECK(run.friction(1) == Approx(20.0).epsilon(1e-13));
    CHECK(run.last.slip_increment == Approx(0.012).epsilon(criterion.tolerance));
    CHECK(run.last.dissipation == Approx(20.0 * 0.012).epsilon(criterion.tolerance));
  }
}

TEST_CASE(
    "an allowable elastic slip that shrinks at rest lets go where it comes down to the state") {
  // From 0.02 to 0.005: at 0.01, two thirds on its way.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = pressed({1}, allowable_slip(0.02));
    definition.criterion = criterion.of;
    ExactRun run(definition, at(0.0, 100.0));
    run.go(at(0.01, 100.0));
    ConnectorIncrement increment;
    increment.duration = 1.0;
    increment.begin_position = run.here().position;
    increment.end.position = increment.begin_position;
    increment.force[2] = 100.0;
    const PathSegment segment =
        path_segment(run.definition, increment, increment.end, increment.force);
    run.definition.stick.value = 0.005;
    const FrictionUpdate u = continuous_update(run.definition, segment, run.state, 1e-12);
    CHECK(u.state.force[0] == Approx(20.0).epsilon(1e-12));
    CHECK(u.onset == Approx(2.0 / 3.0).epsilon(criterion.tolerance));
    CHECK(u.slip_increment == Approx(0.005).epsilon(criterion.tolerance));
    CHECK(u.dissipation == Approx(0.1).epsilon(criterion.tolerance));
  }
}

TEST_CASE("a coefficient over the rate of the motion holds over the whole segment") {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0));
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  definition.slip_rate = SlipRateMeasure::kRelativeMotion;
  Waypoint end = at(10.0);
  end.duration = 0.2;
  for (const int count : {1, 9}) {
    ExactRun run(definition, at(0.0));
    run.go(end, count);
    CHECK(run.friction(1) == Approx(100.0 * 0.20820849986239).epsilon(1e-13));
  }
}

TEST_CASE("a coefficient that rises with the slip rate is followed to the tolerance") {
  // y = N (mu0 + c L'), L' = v - y'/k: y - y_end falls as exp(-k t/(N c)) from the onset on.
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0));
  definition.law =
      TabularCoefficient{make_function({{0.2, 0.0}, {0.3, 1.0}}, {{IndependentKind::kSlipRate}})};
  Waypoint end = at(0.05);
  end.duration = 0.1;  // v = 0.5
  const double v = 0.5;
  const double onset = 0.02 / v;
  const double tau = 100.0 * 0.1 / 1000.0;
  const double force = 100.0 * (0.2 + 0.1 * v) - 100.0 * 0.1 * v * std::exp(-(0.1 - onset) / tau);
  for (const int count : {1, 3, 20}) {
    ExactRun run(definition, at(0.0), 1e-10);
    run.go(end, count);
    CHECK(run.friction(1) == Approx(force).epsilon(1e-9));
    CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-8));
    CHECK(run.last.state.regime == Regime::kSlip);
    if (count == 1) {
      REQUIRE(run.changes.count >= 1);
      CHECK(run.changes.at[0].fraction == Approx(onset / 0.1).margin(1e-5));
    }
  }
}

TEST_CASE("a corner next to the begin of an increment is met under a coefficient over the rate") {
  // Almost without viscosity: after a millionth of the warming the limit has fallen from 12 N to
  // 4 N, and rises to 30 N from there on.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.law = TabularCoefficient{make_function({{0.2, 0.0}, {0.201, 10.0}}, {kOverSlipRate})};
  definition.internal_contact_force =
      make_function({{100, 50.0 - 1e-4}, {20, 50}, {150, 100}}, {kOverTemperature});
  Waypoint point = at(0.0);
  point.temperature = 50.0 - 5e-5;
  ExactRun run(definition, point);
  point.position[0] = 0.011;
  run.go(point);
  CHECK(run.friction(1) == Approx(11.0));
  point.temperature = 100.0;
  run.go(point);
  CHECK(run.friction(1) == Approx(4.0).epsilon(1e-3));
}

TEST_CASE("a potential is followed to the tolerance") {
  FrictionDefinition definition = pressed({1, 2});
  definition.criterion = norm_of_two();
  ExactRun run(definition, at(0.0, 100.0), 1e-10);
  run.go(at(0.05, 100.0));
  run.go(at(0.05, 100.0, 0.05));
  CHECK(run.friction(1) == Approx(3.26142463859956).epsilon(1e-8));
  CHECK(run.friction(2) == Approx(19.7322859630286).epsilon(1e-8));
  CHECK(run.dissipation == Approx(1.32542726716717).epsilon(1e-8));
  run.go(at(0.05, 100.0));
  REQUIRE(run.changes.count >= 1);
  CHECK(run.changes.at[0].to == Regime::kStick);
  CHECK(run.changes.at[0].fraction == 0.0);
}

TEST_CASE("a contribution goes on where one of its terms pulls and another does not") {
  // X_2 = <y_2> + <y_4> with y_4 < 0: the path is that of the norm, in any number of increments.
  FrictionDefinition definition = pressed({1, 2, 4});
  Potential potential = norm_of_two();
  potential.leaves = 3;
  potential.leaf[1].kind = potential.leaf[2].kind = PotentialLeaf::Kind::kHalfLine;
  potential.leaf[2].part = 1;
  potential.leaf[2].direction[2] = 1.0;
  definition.criterion = potential;
  ExactRun run(definition, at(0.0, 100.0), 1e-10);
  Waypoint along = at(0.05, 100.0), across = at(0.05, 100.0, 0.05);
  along.position[3] = across.position[3] = -0.005;
  run.go(along);
  run.go(across, 3);
  CHECK(run.friction(1) == Approx(3.26142463859956).epsilon(1e-8));
  CHECK(run.friction(2) == Approx(19.7322859630286).epsilon(1e-8));
  CHECK(run.friction(4) == Approx(-5.0).epsilon(1e-12));
}

TEST_CASE("a peak of the coefficient over the rate of the slip is met on the way of a potential") {
  // A rate from 0 to 0.48 mm/s as the force turns, a peak at 0.25 mm/s.
  std::vector<double> dissipated;
  for (const SlipCriterion& criterion :
       std::vector<SlipCriterion>{EuclideanPotential{}, norm_of_two()}) {
    FrictionDefinition definition = slider(0.2, 100.0, allowable_slip(0.02), {1, 2});
    definition.law = TabularCoefficient{make_function(
        {{0.2, 0}, {0.2, 0.249}, {0.3, 0.25}, {0.2, 0.251}, {0.2, 1}}, {kOverSlipRate})};
    definition.criterion = criterion;
    ExactRun run(definition, at(0.0), 1e-10);
    run.go(at(0.05));
    Waypoint across = at(0.05, 0.0, 0.05);
    across.duration = 0.1;
    run.go(across);
    dissipated.push_back(run.last.dissipation);
  }
  CHECK(dissipated[1] == Approx(dissipated[0]).epsilon(1e-7));
}

TEST_CASE("a potential slips on its limit at any tolerance") {
  for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.02)}) {
    FrictionDefinition definition = pressed({1, 2}, stick);
    definition.criterion = norm_of_two();
    ExactRun run(definition, at(0.0, 100.0), 1e-3);
    run.go(at(0.05, 100.0));
    run.go(at(0.05, 80.0, 0.05));
    CHECK(run.last.converged);
    CHECK(run.last.phi == Approx(0.0).margin(1e-11));
  }
}

TEST_CASE("a limit with forty corners in one increment is followed through them all") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  Rows rows;
  for (int i = 0; i <= 40; ++i) {
    rows.push_back({i % 2 == 0 ? 100.0 : 60.0, static_cast<double>(i)});
  }
  definition.internal_contact_force = make_function(rows, {kOverTemperature});
  Waypoint end = at(0.2 + 0.05);
  end.temperature = 40.0;
  for (const Criterion& criterion : criteria_of_one()) {
    definition.criterion = criterion.of;
    for (const int count : {1, 40}) {
      ExactRun run(definition, at(0.0));
      run.go(at(0.05));
      run.go(end, count);
      // Where it falls slip is 0.008 more than the motion of 0.005, which gives the spring 5 N
      // where it rises by 8: stick. Of the next fall 3 N do not reach down to the force.
      CHECK(run.friction(1) == Approx(17.0).epsilon(1e-9));
      CHECK(run.state.accumulated_slip == Approx(0.25 - 0.017).epsilon(1e-9));
    }
  }
}

TEST_CASE("a dip of the limit is seen behind a begin at which the limit is as near to the force") {
  // 100 (t - 29/32)^2 ((t - 1/32)^2 + 0.0006) + 9.97, over a force of 10.
  std::array<double, 5> limit{9.97, 0.0, 0.0, 0.0, 0.0};
  const std::array dip{29.0 * 29.0 / 1024.0, -29.0 / 16.0, 1.0};
  const std::array begin{1.0 / 1024.0 + 6e-4, -1.0 / 16.0, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) limit[i + j] += 100.0 * dip[i] * begin[j];
  }
  // Such is a table over four independents along its diagonal. Of t^d a corner with n of them at 1
  // has n (n - 1) .. (n - d + 1) in 4 (4 - 1) .. (4 - d + 1) parts.
  Rows rows;
  for (int corner = 0; corner < 16; ++corner) {
    std::vector<double> row{0.0};
    for (int k = 0; k < 4; ++k) row.push_back(corner >> k & 1);
    const double n = row[1] + row[2] + row[3] + row[4];
    double part = 1.0;
    for (int d = 0; d <= 4; ++d) {
      row[0] += limit[static_cast<std::size_t>(d)] * part;
      part *= (n - d) / std::max(4 - d, 1);
    }
    rows.push_back(row);
  }
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(1.0, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force =
        make_function(rows, {kOverTemperature, over_field(0), over_field(1), over_field(2)});
    Waypoint point = at(0.0);
    point.fields = {0.0, 0.0, 0.0};
    ExactRun run(definition, point);
    point.position[0] = 0.01;
    run.go(point);
    CHECK(run.friction(1) == Approx(10.0));
    point.temperature = 1.0;
    point.fields = {1.0, 1.0, 1.0};
    run.go(point);
    CHECK(run.friction(1) == Approx(9.97).epsilon(1e-10));
  }
}

/// Returns F_int = bottom + curvature (t - place)^2 along the diagonal of temperature and a field.
InternalContactForce along_diagonal(double bottom, double curvature, double place) {
  const auto at_part = [&](double t) { return bottom + curvature * (t - place) * (t - place); };
  const double aside = at_part(0.0) - curvature * place;
  return make_function({{at_part(0.0), 0, 0}, {aside, 1, 0}, {aside, 0, 1}, {at_part(1.0), 1, 1}},
                       {kOverTemperature, over_field(0)});
}

/// Returns a slider that has moved at the begin of that diagonal.
ExactRun moved(const FrictionDefinition& definition, double motion) {
  Waypoint point = at(0.0);
  point.fields = {0.0};
  ExactRun run(definition, point);
  point.position[0] = motion;
  if (motion != 0.0) run.go(point);
  return run;
}

/// Goes on to a motion at the end of the diagonal.
ExactRun go_along_diagonal(ExactRun run, double motion, int count) {
  Waypoint point = run.here();
  point.position[0] = motion;
  point.temperature = point.fields[0] = 1.0;
  run.go(point, count);
  return run;
}

TEST_CASE("a coefficient that gives way under a peak or in a dip of the contact force is seen") {
  // F_int = 50 -+ 100 (t - top)^2 along the diagonal of temperature and a field; mu falls from 0.5
  // to 0.1 next to 50 N. The tops are those between two, and in reach of three, of sixteen parts.
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double top : {17.0 / 32.0, 19.0 / 32.0}) {
      for (const double sense : {1.0, -1.0}) {
        CAPTURE(criterion.tolerance, top, sense);
        const double low = 50.0 - sense * (top < 0.55 ? 0.05 : 0.16);
        FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
        definition.criterion = criterion.of;
        definition.internal_contact_force = along_diagonal(50.0, -sense * 100.0, top);
        Rows rows{{0.5, 0.0}, {0.5, low - 0.01}, {0.1, low}, {0.1, 200.0}};
        // On the way into the dip the limit grows before it gives way.
        if (sense < 0.0) rows = {{0.1, 0.0}, {0.1, low}, {0.9, low + 0.01}, {0.3, 60.0}};
        definition.law = TabularCoefficient{make_function(rows, {kOverContactForce})};
        const ExactRun begin = moved(definition, 0.006);
        CHECK(begin.friction(1) == Approx(6.0));
        const ExactRun run = go_along_diagonal(begin, 0.006, 1);
        CHECK(run.friction(1) == Approx(0.1 * std::min(low, 50.0)).epsilon(1e-8));
      }
    }
  }
}

TEST_CASE("a limit that dips below a force alike before and behind a look is met") {
  // 0.5 (bottom + 128 (t - 9/16)^2): equal at 4 and 5 eighths of the segment, in all digits.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.5, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force = along_diagonal(11.75, 128.0, 9.0 / 16.0);
    const ExactRun run = go_along_diagonal(moved(definition, 0.006), 0.006, 1);
    CHECK(run.friction(1) == Approx(0.5 * 11.75).epsilon(1e-8));
  }
}

TEST_CASE("a shifted potential lets go in a dip of its limit between any looks") {
  // |y - 8.7|: a limit below 8.7 N holds nothing. It is 8.45 N for an instant.
  FrictionDefinition definition = slider(1.0, 0.0, fixed_stiffness(1000.0));
  Potential shifted = shifted_by_one();
  shifted.leaf[0].center = 8.7;
  definition.criterion = shifted;
  definition.internal_contact_force = along_diagonal(8.45, 400.0, 17.0 / 32.0);
  const ExactRun run = go_along_diagonal(moved(definition, 0.008), 0.008, 1);
  CHECK(run.friction(1) == 0.0);
  CHECK(run.last.lost == Approx(0.032));
}

TEST_CASE("a limit that comes up for an instant between any looks holds then") {
  // mu falls from 0.1 to 0 between 84.9 and 85 N; the least contact force is 84.96 N.
  double dissipation = 0.0;
  for (const Criterion& criterion : criteria_of_one()) {
    for (const int count : {1, 7}) {
      FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
      definition.criterion = criterion.of;
      definition.internal_contact_force = along_diagonal(84.96, 100.0, 17.0 / 32.0);
      definition.law =
          TabularCoefficient{make_function({{0.1, 84.9}, {0.0, 85.0}}, {kOverContactForce})};
      const ExactRun run = go_along_diagonal(moved(definition, 0.0), 1.0, count);
      if (dissipation == 0.0) dissipation = run.dissipation;
      CHECK(dissipation > 0.05);
      CHECK(run.dissipation == Approx(dissipation).epsilon(1e-8));
    }
  }
}

TEST_CASE("slip goes through a coefficient that gives way for an eighth of an increment") {
  // mu falls from 0.5 to 0.1 just below the peak of 50 N at 0.95.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.internal_contact_force = along_diagonal(50.0, -40.0, 0.95);
    definition.law = TabularCoefficient{
        make_function({{0.5, 0.0}, {0.5, 49.92}, {0.1, 49.93}, {0.1, 100.0}}, {kOverContactForce})};
    const ExactRun whole = go_along_diagonal(moved(definition, 0.05), 0.2, 1);
    const ExactRun divided = go_along_diagonal(moved(definition, 0.05), 0.2, 100);
    CHECK(whole.friction(1) == Approx(divided.friction(1)).epsilon(1e-8));
    CHECK(whole.work == Approx(divided.work).epsilon(1e-8));
  }
}

TEST_CASE("a force that turns while wear and time take its contact through 0 is followed") {
  // Steps are rounded to the digits of tau where the limit is next to nothing.
  FrictionDefinition definition = slider(0.3, 0.0, fixed_stiffness(1000.0), {1, 2});
  definition.contact_force = ComponentContactForce{2};
  definition.internal_contact_force = make_function({{100, 0}, {80, 0.2}}, {kOverAccumulatedSlip});
  std::vector<double> slips;
  for (const int count : {1, 2, 3, 50}) {
    ExactRun run(definition);
    run.go(at(0.0088, 0.0, 0.01));
    run.go(at(-0.0028, -213.82, 0.0009), count);
    CHECK(run.last.converged);
    slips.push_back(run.state.accumulated_slip);
  }
  CHECK(slips[0] > 0.006);
  for (const double slip : slips) CHECK(slip == Approx(slips[0]).epsilon(1e-9));
}

TEST_CASE("a potential without motion converges under a limit that comes and goes") {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0), {1, 2});
  definition.criterion = norm_of_two();
  definition.internal_contact_force =
      make_function({{0, 0}, {0, 0.3}, {100, 0.35}, {0, 0.4}, {0, 1}}, {kOverTemperature});
  ExactRun run(definition);
  Waypoint warm = at(0.0);
  warm.temperature = 1.0;
  CHECK(run.go(warm).converged);
  CHECK(run.dissipation == 0.0);
}

TEST_CASE("the norm of two forces that passes below a knot between any looks is seen") {
  // mu falls from 0.2 to 0 below 10 N; the least norm is 9.99 N.
  for (const Criterion& criterion : criteria_of_one()) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
    definition.criterion = criterion.of;
    definition.contact_force = DerivedComponent{norm_term({3, 4}, 1.0)};
    definition.law = TabularCoefficient{
        make_function({{0.0, 9.98}, {0.2, 10.0}, {0.2, 200.0}}, {kOverContactForce})};
    Waypoint point = at(0.0);
    point.force[2] = -100.0;
    point.force[3] = 9.99;
    ExactRun run(definition, point);
    point.position[0] = 0.0015;
    run.go(point);
    CHECK(run.friction(1) == Approx(1.5));
    point.force[2] = 112.0;
    run.go(point);
    CHECK(run.friction(1) == Approx(0.1 * 9.99).epsilon(1e-8));
  }
}

TEST_CASE("a potential of all components is followed, and tells its direction in stick") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0), {1, 2, 3, 4, 5, 6});
  Potential norm;
  norm.parts = norm.leaves = kComponents;
  for (std::size_t i = 0; i < kComponents; ++i) {
    norm.leaf[i].part = static_cast<int>(i);
    norm.leaf[i].direction[i] = 1.0;
  }
  definition.criterion = norm;
  ExactRun run(definition);
  Waypoint end;
  for (const double motion : {0.005, 0.05}) {
    for (int c = 0; c < kComponents; ++c) end.position[c] = motion;
    run.go(end);
    const double force = motion < 0.01 ? 5.0 : 20.0 / std::sqrt(6.0);
    for (int number = 1; number <= kComponents; ++number) {
      CHECK(run.friction(number) == Approx(force).epsilon(1e-10));
    }
    for (const double d : run.last.direction) CHECK(d == Approx(1.0 / std::sqrt(6.0)));
  }
}

TEST_CASE("a shifted potential with an allowable elastic slip slips at its two limits") {
  // |y - 1| = 20 at 21 and at -19 N.
  FrictionDefinition definition = pressed({1}, allowable_slip(0.02));
  definition.criterion = shifted_by_one();
  ExactRun run(definition, at(0.0, 100.0));
  run.go(at(0.3, 100.0));
  CHECK(run.friction(1) == Approx(21.0));
  run.go(at(0.0, 100.0));
  CHECK(run.friction(1) == Approx(-19.0));
  run.go(at(-0.3, 100.0), 3);
  CHECK(run.friction(1) == Approx(-19.0));
  CHECK(run.state.regime == Regime::kSlip);
}

TEST_CASE("a force that turns under a shifted potential stays on its limit to the last digits") {
  // |y - (1, 0)| = 20 N, with an elastic slip.
  FrictionDefinition definition = pressed({1, 2}, allowable_slip(0.02));
  Potential shifted = norm_of_two();
  shifted.leaf[0].center = 1.0;
  shifted.homogeneous = false;
  definition.criterion = shifted;
  ExactRun run(definition, at(0.0, 100.0), 1e-6);
  run.go(at(0.3, 100.0));
  CHECK(run.friction(1) == Approx(21.0));
  for (const double turn : {0.01, 0.02, 0.05}) {
    run.go(at(0.3, 100.0, turn));
    CHECK(std::hypot(run.friction(1) - 1.0, run.friction(2)) == Approx(20.0).epsilon(1e-14));
  }
}

TEST_CASE("a shifted potential loses its grip where the limit comes down to its value at rest") {
  // P = |y - 1|: a limit of 1 holds no more than the force 0.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force =
      make_function({{100.0, 0.0}, {5.0, 50.0}, {100.0, 100.0}}, {kOverTemperature});
  definition.criterion = shifted_by_one();
  ExactRun run(definition, at(0.0), 1e-10);
  run.go(at(0.01));
  CHECK(run.friction(1) == Approx(10.0));
  Waypoint warm = at(0.01);
  warm.temperature = 100.0;
  run.go(warm);
  CHECK(run.friction(1) == Approx(0.0).margin(1e-9));
  REQUIRE(run.changes.count >= 2);
  const RegimeChange& last = run.changes.at[static_cast<std::size_t>(run.changes.count - 1)];
  CHECK(last.to == Regime::kStick);
  CHECK(last.fraction == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a shifted potential grips between two ends at which it does not") {
  // P = |y - 1| under 0.5 + 6 t (1 - t), which is above 1 for t within 0.5 +- sqrt(1/6). In that
  // time the motion stretches the spring to 2 N, the most that a limit of 1 holds.
  FrictionDefinition definition = slider(0.0, 10.0, fixed_stiffness(1000.0));
  definition.criterion = shifted_by_one();
  definition.law = TabularCoefficient{make_function(
      {{0.05, 0, 0}, {0.35, 1, 0}, {0.35, 0, 1}, {0.05, 1, 1}}, {kOverTemperature, over_field(0)})};
  Waypoint point = at(0.0);
  point.fields = {0.0};
  ExactRun run(definition, point, 1e-10);
  point.position[0] = 0.01;
  point.temperature = point.fields[0] = 1.0;
  run.go(point);
  CHECK(run.state.accumulated_slip == Approx(0.02 * std::sqrt(1.0 / 6.0) - 0.002).epsilon(1e-8));
  CHECK(run.state.regime == Regime::kOpen);
}

/// A belt of half a turn, mu = 0.2 and 1000 N/mm, that flows in component 2.
FrictionDefinition half_turn() {
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0), {2});
  definition.criterion = Capstan{pi};
  definition.contact_force = ComponentContactForce{0};
  return definition;
}

Waypoint flow_to(double flow, double tension) {
  Waypoint w;
  w.position[1] = flow;
  w.force[0] = tension;
  return w;
}

TEST_CASE("a belt that turns back sticks through zero, wherever that is in an increment") {
  const double backward = 100.0 * -std::expm1(-0.2 * pi);
  for (int i = 0; i < 50; ++i) {
    const double motion = 0.05 + 0.0015 * i;  // it slips forward from 0.134 mm on
    ExactRun run(half_turn(), flow_to(0.0, 100.0));
    run.go(flow_to(-0.3, 100.0));
    run.go(flow_to(-0.3 + motion, 100.0));
    CHECK(run.friction(2) == Approx(1000.0 * motion - backward).margin(1e-10));
    CHECK(run.last.slip_increment == 0.0);
  }
}

TEST_CASE("a belt whose tension jumps down relaxes at once and sticks through zero from there") {
  ExactRun run(half_turn(), flow_to(0.0, 100.0));
  run.go(flow_to(-0.3, 100.0));
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.begin_position = increment.end.position = run.here().position;
  const Ambient begin = increment.end;
  increment.end.position[1] += 0.038;
  ConnectorForce begin_force;
  begin_force[0] = increment.force[0] = 30.0;
  RegimeChanges changes;
  const FrictionUpdate u =
      continuous_update(run.definition, path_segment(run.definition, increment, begin, begin_force),
                        run.state, 1e-12, &changes);
  const double band = -std::expm1(-0.2 * pi);
  CHECK(u.slip_increment == Approx(70.0 * band / 1000.0).epsilon(1e-12));
  // From -14.0 to 24.0, below the 26.2 that slip forward.
  CHECK(u.state.force[0] == Approx(38.0 - 30.0 * band).epsilon(1e-12));
}

TEST_CASE("a belt is followed through both sides of its band") {
  const double ratio = std::exp(0.2 * pi);
  for (const int count : {1, 13}) {
    ExactRun run(half_turn(), flow_to(0.0, 100.0));
    run.go(flow_to(0.3, 100.0), count);
    CHECK(run.friction(2) == Approx(100.0 * (ratio - 1.0)).epsilon(1e-13));
    run.go(flow_to(-0.3, 100.0), count);
    CHECK(run.friction(2) == Approx(-100.0 * (1.0 - 1.0 / ratio)).epsilon(1e-13));
    const double forward = 100.0 * (ratio - 1.0);
    const double backward = 100.0 * (1.0 - 1.0 / ratio);
    const double slip = 0.3 - forward / 1000.0 + 0.6 - (forward + backward) / 1000.0;
    CHECK(run.state.accumulated_slip == Approx(slip).epsilon(1e-12));
    CHECK(run.work == Approx(run.dissipation + run.last.stored_energy).epsilon(1e-12));
    // The tension falls at rest: the belt slides back to the narrower band.
    run.go(flow_to(-0.3, 50.0), count);
    CHECK(run.friction(2) == Approx(-0.5 * backward).epsilon(1e-13));
    run.go(flow_to(-0.2, -50.0), count);
    CHECK(run.state.regime == Regime::kOpen);
  }
}

TEST_CASE("slip that ends slowly, early in an increment, goes on until then") {
  // F_lim = 2e-5 N^3, N = 100 (1 + t), over k du/dt = 61 N: the limit rises faster from
  // N = 100 sqrt(61/60) on, t = 0.0083. With next to no viscosity, which changes nothing.
  FrictionDefinition definition = pressed();
  definition.law = GeneralizedViscous{.c2 = 1e-12, .c4 = 2e-5, .area = 1.0};
  ExactRun run(definition, at(0.0, 100.0));
  run.go(at(0.05, 100.0));
  run.go(at(0.111, 200.0));
  const double end = std::sqrt(61.0 / 60.0);
  const double slip = 0.061 * (end - 1.0) - 0.02 * (end * end * end - 1.0);
  CHECK(run.last.slip_increment == Approx(slip).margin(1e-7 * 0.02));
  CHECK(run.last.state.regime == Regime::kStick);
}

TEST_CASE("slip that is slow beside the motion goes on to the end of an increment") {
  // The limit rises by 2 N; the motion is that of the elastic slip and a part of 0.02 mm more.
  FrictionDefinition fixed = pressed();
  fixed.criterion = criteria_of_one().back().of;
  FrictionDefinition viscous = pressed();
  viscous.law = TabularCoefficient{make_function({{0.2, 0}}, {kOverSlipRate})};
  FrictionDefinition elastic = pressed({1}, allowable_slip(0.02));
  elastic.criterion = fixed.criterion;
  for (const FrictionDefinition& definition : {fixed, viscous, elastic}) {
    const bool follows = definition.stick.mode == StickStiffness::Mode::kStiffness;
    for (double part = 1e-3; part > 1e-12; part /= 8.0) {
      CAPTURE(follows, part);
      const double slip = 0.02 * part;
      ExactRun run(definition, at(0.0, 100.0));
      run.go(at(0.05, 100.0));
      run.go(at(0.05 + (follows ? 0.002 : 0.0) + slip, 110.0));
      CHECK(run.last.converged);
      // A viscous force so near to its limit rests, and is moved on later.
      CHECK(run.last.slip_increment == Approx(slip).margin(1e-9 * 0.02));
      CHECK(run.friction(1) == Approx(22.0).epsilon(1e-9));
    }
  }
}

TEST_CASE("slip ends in any increment, however short") {
  // F_lim = 2e-5 N^3, N = 100 (1 + t): it rises as fast as k du/dt = 61 N where `end` is passed.
  FrictionDefinition definition = pressed();
  definition.criterion = criteria_of_one().back().of;
  definition.law = GeneralizedViscous{.c4 = 2e-5, .area = 1.0};
  const double end = std::sqrt(61.0 / 60.0);
  for (double length = 0.1; length > 1e-8; length /= 7.0) {
    CAPTURE(length);
    const double begin = end - 0.3 * length;
    const double force = 20.0 * begin * begin * begin;
    ExactRun run(definition, at(0.0, 100.0 * begin));
    run.go(at(0.05, 100.0 * begin));
    CHECK(run.friction(1) == Approx(force));
    run.go(at(0.05 + 0.061 * length, 100.0 * (begin + length)));
    const double slip = 0.061 * (end - begin) - (0.02 * end * end * end - 1e-3 * force);
    CHECK(run.last.converged);
    CHECK(run.last.slip_increment == Approx(slip).margin(1e-10 * 0.02));
    CHECK(run.last.state.regime == Regime::kStick);
  }
}

TEST_CASE("slip goes on where its limit is next to nothing of what it is the difference of") {
  // F_N = F_C + 1000 N (1 - slip/mm) from 0.005 N on: the last digits of F_int are 2e-11 of that.
  FrictionDefinition definition = pressed({1}, fixed_stiffness(1e8));
  definition.criterion = criteria_of_one().back().of;
  definition.contact_force = ComponentContactForce{2};
  definition.internal_contact_force = make_function({{1000, 0}, {0, 1}}, {kOverAccumulatedSlip});
  for (const double worn : {0.3, 0.5, 0.7}) {
    CAPTURE(worn);
    const double pull = 0.005 - 1000.0 * (1.0 - worn);
    ExactRun run(definition, at(0.0, pull), 1e-9);
    run.state.accumulated_slip = worn;
    run.go(at(3e-6, pull));
    // slip + 0.2 (0.005 - 1000 slip)/k = 3e-6
    const double slip = (3e-6 - 1e-11) / (1.0 - 2e-6);
    CHECK(run.last.converged);
    CHECK(run.last.slip_increment == Approx(slip).epsilon(1e-9));
    CHECK(run.friction(1) == Approx(0.2 * (0.005 - 1000.0 * slip)).epsilon(1e-8));
  }
}

TEST_CASE("slip of a short increment goes through a contact force of 0 of large terms") {
  // F_N = |F_C + 1000 N (1 - slip/mm)| from 0.005 N down to 0 and up again.
  FrictionDefinition definition = pressed({1}, fixed_stiffness(1e6));
  definition.contact_force = ComponentContactForce{2};
  definition.internal_contact_force = make_function({{1000, 0}, {0, 1}}, {kOverAccumulatedSlip});
  for (const Criterion& criterion : criteria_of_one()) {
    definition.criterion = criterion.of;
    for (int i = 1; i < 40; ++i) {
      const double worn = i / 40.0 + 0.003;
      const double pull = 0.005 - 1000.0 * (1.0 - worn);
      CAPTURE(worn, criterion.tolerance);
      ExactRun run(definition, at(0.0, pull), 1e-9);
      run.state.accumulated_slip = worn;
      run.go(at(1.2e-5, pull));
      CHECK(run.last.converged);
      // slip + 0.2 (1000 slip - 0.005)/k = 1.2e-5 behind 0
      const double slip = (1.2e-5 + 1e-9) / (1.0 + 2e-4);
      CHECK(run.last.slip_increment == Approx(slip).epsilon(1e-8));
      CHECK(run.friction(1) == Approx(0.2 * (1000.0 * slip - 0.005)).epsilon(1e-6));
    }
  }
}

TEST_CASE("a coefficient on its floor is that of a contact, however small") {
  // mu = N/1000 - 0.1, on its floor of 1e-30 below 100 N: the slip goes on there.
  FrictionDefinition definition = pressed();
  definition.law = GeneralizedViscous{.fric = -0.1, .c1 = 1e-3, .area = 1.0};
  ExactRun run(definition, at(0.0, 200.0));
  run.go(at(0.3, 200.0));
  CHECK(run.friction(1) == Approx(20.0));
  run.go(at(1.3, 50.0));
  CHECK(run.state.accumulated_slip == Approx(1.3).epsilon(1e-12));
  run.go(at(1.4, 60.0));
  CHECK(run.state.accumulated_slip == Approx(1.4).epsilon(1e-12));
  CHECK(run.state.regime == Regime::kSlip);
}

TEST_CASE("a coefficient that only motion gives holds, whatever the time and the unit of force") {
  // 0 up to a rate of 1, 0.5 at the rate 2 of the motion.
  for (const Criterion& criterion : criteria_of_one()) {
    for (const double unit : {1.0, 1e-6}) {
      for (const double duration : {0.1, 1.0, 10.0}) {
        CAPTURE(criterion.tolerance, unit, duration);
        FrictionDefinition definition = slider(0.0, 100.0 * unit, allowable_slip(0.01));
        definition.criterion = criterion.of;
        definition.law = TabularCoefficient{make_function({{0, 1}, {0.5, 2}}, {kOverSlipRate})};
        ExactRun run(definition);
        Waypoint end = at(2.0 * duration);
        end.duration = duration;
        run.go(end);
        CHECK(run.friction(1) == Approx(50.0 * unit));
        CHECK(run.state.accumulated_slip == Approx(2.0 * duration - 0.01));
      }
    }
  }
}

TEST_CASE("corners at small rates are seen whatever the rate, its unit and the slip of the past") {
  // 20 N to the rate 1, 30 N from the rate 3 on, on the way of the rate to v.
  struct Motion {
    double rate, accumulated_slip, unit;
  };
  for (const auto& [rate, before, unit] : {Motion{1e3, 0.0, 1.0}, Motion{1e3, 1e6, 1.0},
                                           Motion{1e8, 0.0, 1.0}, Motion{1e8, 0.0, 1e-6}}) {
    CAPTURE(rate, before, unit);
    FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0));
    definition.law =
        TabularCoefficient{make_function({{0.2, unit}, {0.3, 3.0 * unit}}, {kOverSlipRate})};
    // F' = k (v - 1 - (F - 20)/5) for the time t: F = 20 + 5 (v - 1) (1 - exp(-200 t)).
    const double t = -std::log1p(-2.0 / (rate - 1.0)) / 200.0;
    const double between = rate * (20.0 * t + 5.0 * ((rate - 1.0) * t - 2.0 / 200.0));
    ExactRun run(definition);
    run.state.accumulated_slip = before;
    Waypoint end = at(1.0);
    end.duration = 1.0 / (rate * unit);
    run.go(end);
    CHECK(run.work == Approx(0.2 + between + 30.0 * (0.98 - rate * t)).epsilon(1e-8));
  }
}

TEST_CASE("a small force under a coefficient over the rate of the slip has a direction") {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0), {1, 2});
  definition.law = TabularCoefficient{make_function({{0.002, 0}, {0.004, 1}}, {kOverSlipRate})};
  ExactRun run(definition);
  run.go(at(0.3, 0.0, 0.4));
  CHECK(run.last.state.force[0] == Approx(0.6 * 0.3).epsilon(1e-6));
  CHECK(run.last.direction[0] == Approx(0.6));
  CHECK(run.last.direction[1] == Approx(0.8));
}

TEST_CASE("wear under a coefficient over the contact force is followed to its end") {
  // F_N = 100 - 50 L: F_lim = a + b L + c L^2, and L + F_lim(L)/k = u. With mu = 0.1 + 0.002 F_N,
  // and with 0.4 - 0.002 F_N, flat where the slip begins.
  struct Wear {
    Rows mu;
    double a, b, c;
  };
  for (const Wear& wear : {Wear{{{0.1, 0}, {0.4, 150}}, 30.0, -25.0, 5.0},
                           Wear{{{0.4, 0}, {0.1, 150}}, 20.0, 0.0, -5.0}}) {
    FrictionDefinition definition = slider(0.0, 0.0, fixed_stiffness(1000.0));
    definition.internal_contact_force = make_function({{100, 0}, {50, 1}}, {kOverAccumulatedSlip});
    definition.law = TabularCoefficient{make_function(wear.mu, {kOverContactForce})};
    const double b = 1.0 + wear.b / 1000.0;
    const double c = wear.a / 1000.0 - 0.8;
    const double slip = -2.0 * c / (b + std::sqrt(b * b - 4.0 * wear.c / 1000.0 * c));
    for (const bool rests : {false, true}) {  // on the limit, before the slip
      ExactRun run(definition);
      if (rests) run.go(at(wear.a / 1000.0));
      run.go(at(0.8));
      CHECK(run.state.accumulated_slip == Approx(slip).epsilon(1e-13));
      CHECK(run.friction(1) == Approx(wear.a + slip * (wear.b + slip * wear.c)).epsilon(1e-11));
    }
  }
}

TEST_CASE("what has no continuous solution is known beforehand") {
  FrictionDefinition falling = slider(0.0, 100.0, fixed_stiffness(1000.0));
  falling.law = ExponentialDecay{0.3, 0.2, 0.05};
  CHECK(no_continuous_solution(falling) == NoContinuousSolution::kWeakening);
  falling.stick = allowable_slip(0.01);
  CHECK_FALSE(no_continuous_solution(falling));
  falling.stick = fixed_stiffness(1000.0);
  falling.slip_rate = SlipRateMeasure::kRelativeMotion;
  CHECK_FALSE(no_continuous_solution(falling));
  FrictionDefinition worn = slider(0.2, 0.0, fixed_stiffness(1000.0));
  worn.internal_contact_force =
      make_function({{100.0, 0.0}, {0.0, 2.0}}, {{IndependentKind::kAccumulatedSlip}});
  CHECK_FALSE(no_continuous_solution(worn));
  worn.accumulated_slip = AccumulatedSlipTiming::kStart;
  CHECK(no_continuous_solution(worn) == NoContinuousSolution::kWearAtStart);
  worn.accumulated_slip = AccumulatedSlipTiming::kEnd;
  worn.stick = allowable_slip(0.01);
  Potential shifted;
  shifted.parts = shifted.leaves = 1;
  shifted.leaf[0].direction[0] = 1.0;
  worn.criterion = shifted;
  CHECK_FALSE(no_continuous_solution(worn));
  shifted.leaf[0].center = 1.0;
  shifted.homogeneous = false;
  worn.criterion = shifted;
  CHECK(no_continuous_solution(worn) == NoContinuousSolution::kShiftWithElasticSlip);
  worn.stick = fixed_stiffness(1000.0);
  CHECK_FALSE(no_continuous_solution(worn));
}

TEST_CASE("the force on a falling coefficient with an elastic slip follows the rate of the slip") {
  FrictionDefinition definition = slider(0.0, 100.0, allowable_slip(0.01));
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  Waypoint end = at(1.0);
  end.duration = 0.1;
  ExactRun run(definition, at(0.0));
  run.go(end);
  CHECK(run.friction(1) == Approx(26.0653065971263).epsilon(1e-13));
  CHECK(run.dissipation == Approx(26.0653065971263 * 0.99).epsilon(1e-12));
  // Until it slips it knows nothing of a rate.
  CHECK(run.work == Approx(run.dissipation + 0.5 * 30.0 * 0.01).epsilon(1e-12));
  REQUIRE(run.changes.count == 1);
  CHECK(run.changes.at[0].limit == Approx(30.0).epsilon(1e-12));
}

TEST_CASE("a coefficient that vanishes at the rate of the slip takes the force, not the contact") {
  // As one that falls to next to nothing: the slip goes on, and the elastic slip is kept.
  for (const double left : {0.0, 1e-12}) {
    for (const Criterion& criterion : criteria_of_one()) {
      FrictionDefinition definition = pressed({1}, allowable_slip(0.01));
      definition.criterion = criterion.of;
      definition.law =
          TabularCoefficient{make_function({{0.2, 0.0}, {left, 1.0}}, {kOverSlipRate})};
      for (const int count : {1, 7}) {
        CAPTURE(left, count);
        Waypoint fast = at(1.0, 100.0);
        fast.duration = 0.25;
        ExactRun run(definition, at(0.0, 100.0));
        run.go(fast, count);
        CHECK(run.state.regime == Regime::kSlip);
        CHECK(std::abs(run.friction(1)) <= 1e-9);
        CHECK(run.state.accumulated_slip == Approx(0.99).epsilon(criterion.tolerance));
        CHECK(run.dissipation <= 1e-9);
        CHECK(run.work == Approx(0.5 * 20.0 * 0.01).margin(1e-9));
        run.go(at(1.003, 100.0), count);
        CHECK(run.friction(1) == Approx(20.0 * 0.997).epsilon(criterion.tolerance));
        CHECK(run.state.accumulated_slip == Approx(0.993).epsilon(criterion.tolerance));
        CHECK(run.dissipation == Approx(20.0 * 0.997 * 0.003).epsilon(1e-7));
      }
    }
  }
}

TEST_CASE("knots of a table over temperature are met inside an increment") {
  // F_int over temperature: 100 at 0, 20 at 50, 150 at 100; the force at rest follows the dip.
  FrictionDefinition definition = slider(0.2, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force = make_function({{100.0, 0.0}, {20.0, 50.0}, {150.0, 100.0}},
                                                    {{IndependentKind::kTemperature}});
  for (const int count : {1, 3, 50}) {
    Waypoint warm = at(0.015);
    ExactRun run(definition, at(0.0));
    run.go(warm);
    warm.temperature = 100.0;
    run.go(warm, count);
    CHECK(run.friction(1) == Approx(4.0).epsilon(1e-12));
    CHECK(run.state.accumulated_slip == Approx(0.011).epsilon(1e-12));
    CHECK(run.state.regime == Regime::kStick);
  }
}

}  // namespace
