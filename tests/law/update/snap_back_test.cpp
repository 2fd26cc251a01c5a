// SPDX-License-Identifier: Apache-2.0
// Wear that the stick spring cannot follow: the force jumps, and where its energy goes.
#include "law/update/snap_back.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/exact_run.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// A limit of 1500 N that wears down to 250 N over 1 mm and stays there, on a spring of 1000 N/mm:
/// beta = 1.25. It jumps from 0 to 1.25 mm of slip, and the spring loses what lies between
/// 1500 - 1000 x and the limit: 125 N mm up to 1 mm and 31.25 N mm beyond.
FrictionDefinition worn() {
  FrictionDefinition definition = slider(0.25, 0.0, fixed_stiffness(1000.0));
  definition.internal_contact_force = make_function({{6000, 0}, {1000, 1}}, {kOverAccumulatedSlip});
  return definition;
}

TEST_CASE("an increment that steps over a fold tells beta and books the lost energy") {
  FrictionRun run(worn());
  run.move_to(1, 2.0);
  CHECK(run.friction(1) == Approx(250.0).epsilon(1e-12));
  CHECK(run.last.slip_increment == Approx(1.75).epsilon(1e-12));
  CHECK(run.last.snap_back == Approx(1.25).epsilon(1e-12));
  CHECK(run.last.jumps == 1);
  CHECK(run.last.onset == Approx(0.75).epsilon(1e-12));
  CHECK(run.last.jump_onset == Approx(0.75).epsilon(1e-12));
  CHECK(run.last.lost == Approx(156.25).epsilon(1e-12));
  CHECK(run.last.dissipation == Approx(875.0 + 250.0 * 0.75).epsilon(1e-12));
  // 1.5 mm up to 1500 N, and 0.5 mm at 250 N.
  CHECK(run.last.work == Approx(1125.0 + 125.0).epsilon(1e-12));
  CHECK(run.last.stored_energy == Approx(31.25).epsilon(1e-12));
}

TEST_CASE("the energy lost in a jump does not depend on the increments") {
  for (const int count : {1, 3, 7, 40, 1000}) {
    for (const double sense : {1.0, -1.0}) {
      FrictionRun run(worn());
      double lost = 0.0;
      int jumps = 0;
      for (int i = 1; i <= count; ++i) {
        run.move_to(1, sense * 2.0 * i / count);
        lost += run.last.lost;
        jumps += run.last.jumps;
      }
      INFO(count << " increments, sense " << sense);
      CHECK(jumps == 1);
      CHECK(lost == Approx(156.25).epsilon(1e-10));
      CHECK(run.work == Approx(1250.0).epsilon(1e-10));
      CHECK(run.work - run.dissipation - lost == Approx(31.25).epsilon(1e-10));
    }
  }
}

TEST_CASE("a force that begins beyond its limit falls by what the limit is below it") {
  // 20 N over a limit of 10 N on 1 N/mm: 10 mm of slip at constant motion, and 2 mm with it.
  const FrictionDefinition definition = slider(0.1, 100.0, fixed_stiffness(1.0));
  const ConnectorIncrement increment;
  const LimitFunction limit(definition, increment, {}, 0.0);
  const SnapBackPath path = snap_back_path(limit, 1.0, 12.0, 20.0, false);
  CHECK(path.jumps == 0);
  CHECK(path.at_rest == Approx(10.0));
  CHECK(path.fallen == Approx(0.5 * 10.0 * 10.0).epsilon(1e-12));
  CHECK(path.lost == 0.0);
  CHECK(path.friction_work == Approx(120.0).epsilon(1e-12));
}

TEST_CASE("a slip that comes to rest before the fold has met none") {
  FrictionDefinition definition = worn();
  definition.internal_contact_force =
      make_function({{6000, 0}, {5900, .5}, {900, 1.5}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 1.9);  // trial 1900 N: 1500 + 950 x, at rest before 0.5 mm
  CHECK(run.last.slip_increment == Approx(400.0 / 950.0).epsilon(1e-12));
  CHECK(run.last.multiple_roots);  // the fold is ahead
  CHECK(run.last.snap_back == Approx(0.05).epsilon(1e-12));
  CHECK(run.last.jumps == 0);
  CHECK(run.last.lost == 0.0);
  run.move_to(1, 2.5);
  CHECK(run.last.snap_back == Approx(1.25).epsilon(1e-12));
  CHECK(run.last.jumps == 1);
}

TEST_CASE("a limit that wears away in the jump loses what the spring still holds") {
  FrictionDefinition definition = worn();
  definition.internal_contact_force = make_function({{6000, 0}, {0, 1}}, {kOverAccumulatedSlip});
  for (const int count : {1, 9, 400}) {
    FrictionRun run(definition);
    double lost = 0.0;
    for (int i = 1; i <= count; ++i) lost += run.move_to(1, 2.0 * i / count).lost;
    CHECK(run.state.regime == Regime::kOpen);
    // The spring has 1500^2 / 2000; friction takes 750 of it.
    CHECK(lost == Approx(375.0).epsilon(1e-10));
    CHECK(run.dissipation == Approx(750.0).epsilon(1e-10));
    CHECK(run.work == Approx(1125.0).epsilon(1e-10));
  }
}

TEST_CASE("slip that wears the limit away within its increment began at the limit before it") {
  FrictionDefinition definition = worn();
  definition.internal_contact_force = make_function({{400, 0}, {0, 1}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 2.0);  // 100 N are met at 0.1 mm
  CHECK(run.state.regime == Regime::kOpen);
  CHECK(run.last.slip_increment == Approx(1.0).epsilon(1e-12));
  CHECK(run.last.onset == Approx(0.05).epsilon(1e-12));
  definition.stick = allowable_slip(0.1);
  CHECK(FrictionRun(definition).move_to(1, 2.0).onset == Approx(0.05).epsilon(1e-12));
}

TEST_CASE("a potential meets the same fold along its normal") {
  FrictionDefinition definition = worn();
  definition.slip = slip_space({1, 2});
  Potential potential;
  potential.exponent = 2.0;
  for (std::size_t i = 0; i < 2; ++i) {
    PotentialLeaf& leaf = potential.leaf[i];
    leaf.part = static_cast<int>(i);
    leaf.direction[i] = 1.0;
  }
  potential.leaves = potential.parts = 2;
  definition.criterion = potential;
  FrictionRun run(definition);
  run.position[0] = 1.2;
  run.move_to(2, 1.6);
  CHECK(run.last.snap_back == Approx(1.25).epsilon(1e-9));
  CHECK(run.last.jumps == 1);
  CHECK(run.last.lost == Approx(156.25).epsilon(1e-9));
  CHECK(run.last.work == Approx(1250.0).epsilon(1e-9));
}

Potential of_one_component(double shift) {
  Potential potential;
  potential.parts = potential.leaves = 1;
  potential.leaf[0].direction[0] = 1.0;
  potential.leaf[0].center = shift;
  potential.homogeneous = shift == 0.0;
  return potential;
}

TEST_CASE("a potential whose limit wears away slips from the limit before it and costs nothing") {
  FrictionDefinition definition = worn();
  definition.internal_contact_force = make_function({{400, 0}, {0, 1}}, {kOverAccumulatedSlip});
  definition.criterion = of_one_component(0.0);
  for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.1)}) {
    definition.stick = stick;
    FrictionRun run(definition);
    run.move_to(1, 2.0);  // 100 N are met at 0.1 mm
    CHECK(run.state.regime == Regime::kOpen);
    CHECK(run.last.onset == Approx(0.05).epsilon(1e-12));
    CHECK(run.last.dissipation == 0.0);  // the limit of the end times the slip
  }
}

TEST_CASE("a potential of one component jumps as the component does, wherever it comes from") {
  // From either side, within the limit of 1500 N and beyond it.
  for (const double begin : {-2.0, -0.8, 0.0, 0.5, 1.6}) {
    FrictionState old;
    old.elastic_slip[0] = begin;
    old.force[0] = 1000.0 * begin;
    FrictionRun component(worn());
    FrictionDefinition definition = worn();
    definition.criterion = of_one_component(0.0);
    FrictionRun potential(definition);
    component.state = potential.state = old;
    const FrictionUpdate& u = component.move_to(1, 2.0 - begin);
    const FrictionUpdate& v = potential.move_to(1, 2.0 - begin);
    INFO("from " << old.force[0] << " N");
    CHECK(v.jumps == u.jumps);
    CHECK(v.onset == Approx(u.onset).epsilon(1e-12));
    CHECK(v.jump_onset == Approx(u.jump_onset).epsilon(1e-12));
    CHECK(v.lost == Approx(u.lost).epsilon(1e-12));
    CHECK(v.dissipation == Approx(u.dissipation).epsilon(1e-12));
    CHECK(v.work == Approx(u.work).epsilon(1e-12));
    // From beyond the limit an increment takes the force down to it step by step, not at once.
    if (std::abs(old.force[0]) > 1500.0) continue;
    ExactRun exact(worn());
    exact.state = old;
    exact.go(at(2.0 - begin));
    CHECK(u.work == Approx(exact.work).epsilon(1e-9));
  }
}

TEST_CASE("under a shift friction takes the work of the force that is held, not of the limit") {
  FrictionDefinition definition = worn();
  definition.criterion = of_one_component(100.0);
  FrictionRun run(definition);
  run.move_to(1, 2.1);
  // All forces of the first test 100 N higher, over 1.75 mm of slip.
  CHECK(run.friction(1) == Approx(350.0).epsilon(1e-12));
  CHECK(run.last.slip_increment == Approx(1.75).epsilon(1e-12));
  CHECK(run.last.jump_onset == Approx(1600.0 / 2100.0).epsilon(1e-12));
  CHECK(run.last.lost == Approx(156.25).epsilon(1e-12));
  CHECK(run.last.dissipation == Approx(875.0 + 250.0 * 0.75 + 175.0).epsilon(1e-12));
  // 1.6 mm up to 1600 N, and 0.5 mm at 350 N.
  CHECK(run.last.work == Approx(1280.0 + 175.0).epsilon(1e-12));
}

TEST_CASE("wear as steep as the spring is soft is met by the least jump, which loses nothing") {
  // 10 - x down to 6, on a spring of 1: at a trial force of 10 all slips up to 4 are in balance.
  FrictionDefinition definition = slider(1.0, 0.0, fixed_stiffness(1.0));
  definition.internal_contact_force = make_function({{10, 0}, {6, 4}}, {kOverAccumulatedSlip});
  FrictionRun run(definition);
  run.move_to(1, 11.0);
  CHECK(run.last.snap_back == 1.0);
  CHECK(run.last.jumps == 1);
  CHECK(run.last.slip_increment == Approx(5.0).epsilon(1e-14));
  CHECK(run.last.lost == Approx(0.0).margin(1e-13));
  CHECK(run.last.dissipation == Approx(32.0 + 6.0).epsilon(1e-14));
}

TEST_CASE("a jump of a maximum in small increments and in an exact one loses the same") {
  // 1500 N and 500 N under a limit of 1500 - 1250 L, 250 N from L = 1 mm on: they fall to 250 N
  // after 1.25 mm and 0.25 mm of slip, of which friction takes 875 + 125.
  FrictionDefinition definition = worn();
  definition.slip = slip_space({1, 2});
  definition.internal_contact_force = make_function({{6000, 0}, {1000, 1}}, {kOverAccumulatedSlip});
  Potential potential;
  potential.combine = PotentialOperator::kMax;
  for (std::size_t i = 0; i < 2; ++i) {
    potential.leaf[i].part = static_cast<int>(i);
    potential.leaf[i].direction[i] = 1.0;
  }
  potential.leaves = potential.parts = 2;
  definition.criterion = potential;
  const double lost = (1500.0 * 1500.0 + 500.0 * 500.0 - 2.0 * 250.0 * 250.0) / 2000.0 - 1000.0;
  ExactRun exact(definition);
  exact.go(at(3.0, 0.0, 1.0));
  CHECK(exact.last.jumps == 1);
  CHECK(exact.last.lost == Approx(lost).epsilon(1e-9));
  CHECK(exact.work == Approx(exact.dissipation + lost + exact.last.stored_energy).epsilon(1e-9));
  double sum = 0.0;
  FrictionRun run(definition);
  for (int i = 1; i <= 3000; ++i) {
    run.position[0] = i / 1000.0;
    sum += run.move_to(2, i / 3000.0).lost;
  }
  // Of first order: the work of the increment with the jump.
  CHECK(sum == Approx(lost).epsilon(0.02));
}

TEST_CASE("a coefficient that rises with the slip rate holds the force in a slow enough fall") {
  FrictionDefinition definition = worn();
  definition.law = TabularCoefficient{make_function({{.25, 0}, {10.25, 10}}, {kOverSlipRate})};
  FrictionRun run(definition);
  run.move_to(1, 2.0);
  // The fall mu c where the slip ends, over the spring and the rise F_N dmu/dL beside it.
  const double fall = 5000.0 * run.last.mu;
  const double holds = 1000.0 + run.last.normal_force;
  CHECK(fall > 1000.0);
  CHECK(run.last.snap_back == Approx(fall / holds).epsilon(1e-8));  // taken 1e-9 before the end
  CHECK(run.last.jumps == 0);
}

TEST_CASE("what cannot fold is not judged: elastic slip, the start's slip, no wear") {
  FrictionDefinition definition = worn();
  definition.stick = allowable_slip(1.5);
  CHECK(FrictionRun(definition).move_to(1, 4.0).snap_back == 0.0);
  definition = worn();
  definition.accumulated_slip = AccumulatedSlipTiming::kStart;
  CHECK(FrictionRun(definition).move_to(1, 4.0).snap_back == 0.0);
  definition = worn();
  definition.internal_contact_force = 6000.0;
  CHECK(FrictionRun(definition).move_to(1, 4.0).snap_back == 0.0);
}

TEST_CASE("across two components the fold and its energy are those along the force") {
  FrictionDefinition definition = worn();
  definition.slip = slip_space({1, 2});
  FrictionRun run(definition);
  run.position[0] = 1.2;
  run.move_to(2, 1.6);
  CHECK(run.last.snap_back == Approx(1.25).epsilon(1e-12));
  CHECK(run.last.lost == Approx(156.25).epsilon(1e-12));
  CHECK(run.last.work == Approx(1250.0).epsilon(1e-12));
}

TEST_CASE("the update for many runs of a history tells of a fold too") {
  FrictionRun run(worn());
  run.position[0] = 2.0;
  CHECK(update_force(run.definition, run.increment(), run.state).snap_back ==
        Approx(1.25).epsilon(1e-12));
}

}  // namespace
