// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "law/update/connector_tangent.hpp"
#include "law/update/return_mapping.hpp"
#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

constexpr double kStiffness = 1000.0;
constexpr double kElasticSlip = 0.02;

/// One increment is a handful of operations; the implicit root is found to a few last digits of the
/// slip, of which the force carries k times as much.
Approx exactly(double value) { return Approx(value).epsilon(1e-12).margin(1e-12); }

std::array<StickStiffness, 2> both_modes() {
  return {fixed_stiffness(kStiffness), allowable_slip(kElasticSlip)};
}

/// The motion of one increment from rest that slips by `slip` and ends at the force `limit`: the
/// elastic slip is limit/k with a stick stiffness and the allowable one else.
double motion_for(const StickStiffness& stick, double slip, double limit) {
  const bool fixed = stick.mode == StickStiffness::Mode::kStiffness;
  return slip + (fixed ? limit / kStiffness : kElasticSlip);
}

TEST_CASE(
    "a coefficient over contact force reads its magnitude where the contact force is signed") {
  // mu = 0.1 + 0.002 F_N, so F_lim = 0.1 F_N + 0.002 F_N^2 with slope 0.1 + 0.004 F_N.
  for (const StickStiffness stick : both_modes()) {
    FrictionDefinition definition = slider(0.0, 20.0, stick);
    definition.contact_force = ComponentContactForce{1};
    definition.law = TabularCoefficient{make_function({{0.1, 0}, {0.3, 100}}, {kOverContactForce})};
    for (const auto& [f2, normal, sign] :
         {std::tuple{-100.0, 80.0, -1.0}, std::tuple{-60.0, 40.0, -1.0},
          std::tuple{60.0, 80.0, 1.0}}) {
      FrictionRun run(definition);
      run.force[1] = f2;
      run.move_to(1, 1.0);
      CHECK(run.last.contact_force == f2 + 20.0);
      CHECK(run.last.normal_force == normal);
      CHECK(run.last.mu == exactly(0.1 + 0.002 * normal));
      CHECK(run.friction(1) == exactly((0.1 + 0.002 * normal) * normal));
      const ConnectorTangent tangent = connector_tangent(run.definition, run.increment(), run.last);
      CHECK(tangent.to_force(0, 1) == exactly(sign * (0.1 + 0.004 * normal)));
    }
  }
}

TEST_CASE("wear within an increment: the dissipation is the worn limit times the slip") {
  // F_int = 100 - 50 s and mu = 0.2: after a slip of 0.08 the limit has come from 20 to 19.2.
  for (const StickStiffness stick : both_modes()) {
    FrictionDefinition definition = slider(0.2, 0.0, stick);
    definition.internal_contact_force = make_function({{100, 0}, {0, 2}}, {kOverAccumulatedSlip});
    FrictionRun run(definition);
    run.move_to(1, motion_for(stick, 0.08, 19.2));
    CHECK(run.last.slip_increment == exactly(0.08));
    CHECK(run.last.limit == exactly(19.2));
    CHECK(run.last.dissipation == exactly(19.2 * 0.08));
    // The next increment starts from the worn limit: 0.1 more slip wears it to 18.2.
    const double from = run.position[0];
    const double relaxed = stick.mode == StickStiffness::Mode::kStiffness ? 1.0 / kStiffness : 0.0;
    run.move_to(1, from + 0.1 - relaxed);
    CHECK(run.last.slip_increment == exactly(0.1));
    CHECK(run.last.dissipation == exactly(18.2 * 0.1));
  }
}

TEST_CASE(
    "a coefficient falling with the rate: the dissipation is the limit at the increment's rate") {
  // A slip of 1 in 0.5 is a rate of 2: mu = 0.2 + 0.1 exp(-0.5 * 2), F_N = 100.
  const double limit = 20.0 + 10.0 * std::exp(-1.0);
  for (const StickStiffness stick : both_modes()) {
    FrictionDefinition definition = slider(0.0, 100.0, stick);
    definition.law = ExponentialDecay{0.3, 0.2, 0.5};
    FrictionRun run(definition);
    run.duration = 0.5;
    run.move_to(1, motion_for(stick, 1.0, limit));
    CHECK(run.last.slip_rate == exactly(2.0));
    CHECK(run.last.limit == exactly(limit));
    CHECK(run.last.dissipation == exactly(limit));
  }
}

TEST_CASE(
    "a coefficient rising with the rate: the dissipation is the limit at the increment's rate") {
  // A slip of 0.5 in 0.5 is a rate of 1: mu = 0.1 + 0.1, F_N = 100.
  for (const StickStiffness stick : both_modes()) {
    FrictionDefinition definition = slider(0.0, 100.0, stick);
    definition.law = TabularCoefficient{make_function({{0.1, 0}, {0.3, 2}}, {kOverSlipRate})};
    FrictionRun run(definition);
    run.duration = 0.5;
    run.move_to(1, -motion_for(stick, 0.5, 20.0));
    CHECK(run.last.slip_rate == exactly(1.0));
    CHECK(run.friction(1) == exactly(-20.0));
    CHECK(run.last.dissipation == exactly(10.0));
  }
}

}  // namespace
