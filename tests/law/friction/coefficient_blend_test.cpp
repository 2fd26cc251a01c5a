// SPDX-License-Identifier: Apache-2.0
// A change of friction in progress: mu = start + weight (law - start), docs/theory, section 9.2.
#include "law/friction/coefficient_blend.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/friction_run.hpp"
#include "tests/support/law_tables.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

TEST_CASE("a blend goes from the start value to the law, and its slopes with it") {
  const CoefficientPoint law{0.3, -0.02, 0.001};
  for (const double weight : {0.0, 0.25, 0.9}) {
    const CoefficientPoint point = blended({0.1, weight}, law);
    CHECK(point.mu == Approx(0.1 + weight * 0.2).epsilon(1e-15));
    CHECK(point.to_slip_rate == weight * -0.02);
    CHECK(point.to_contact_force == weight * 0.001);
  }
}

TEST_CASE("at full weight, and by default, there is the law alone, to the last bit") {
  const CoefficientPoint law{0.1 + 0.2, -0.1 / 3.0, 1.0 / 7.0};
  for (const CoefficientBlend& blend :
       {CoefficientBlend{}, CoefficientBlend{0.7, 1.0}, CoefficientBlend{1e9, 1.0}}) {
    const CoefficientPoint point = blended(blend, law);
    CHECK(point.mu == law.mu);
    CHECK(point.to_slip_rate == law.to_slip_rate);
    CHECK(point.to_contact_force == law.to_contact_force);
  }
}

TEST_CASE("the limit uses the blended coefficient, under the force limit") {
  for (const StickStiffness stick : {fixed_stiffness(1000.0), allowable_slip(0.02)}) {
    FrictionDefinition definition = slider(0.2, 100.0, stick);
    definition.blend = {0.4, 0.75};
    FrictionRun run(definition);
    run.move_to(1, 1.0);
    CHECK(run.last.mu == Approx(0.25).epsilon(1e-14));
    CHECK(run.friction(1) == Approx(25.0).epsilon(1e-14));
    definition.force_limit = 22.0;
    FrictionRun capped(definition);
    capped.move_to(1, 1.0);
    CHECK(capped.friction(1) == Approx(22.0).epsilon(1e-14));
  }
}

TEST_CASE("at weight 0 from nothing there is no grip") {
  FrictionDefinition definition = slider(0.2, 100.0, fixed_stiffness(1000.0));
  definition.blend = {0.0, 0.0};
  FrictionRun run(definition);
  run.move_to(1, 1.0);
  CHECK(run.last.state.regime == Regime::kOpen);
  CHECK(run.friction(1) == 0.0);
}

TEST_CASE("an implicit slip under a blend solves its own equation") {
  FrictionDefinition definition = slider(0.0, 100.0, fixed_stiffness(1000.0));
  definition.law = ExponentialDecay{0.3, 0.2, 0.05};
  definition.blend = {0.5, 0.4};
  FrictionRun run(definition);
  run.move_to(1, 2.0);
  const double slip = run.state.accumulated_slip;
  const double mu = 0.5 + 0.4 * (0.2 + 0.1 * std::exp(-0.05 * slip) - 0.5);
  // The force k (u - s) loses as many digits as the slip has before it.
  CHECK(1000.0 * (2.0 - slip) == Approx(100.0 * mu).epsilon(1e-11));
  CHECK(run.friction(1) == Approx(100.0 * mu).epsilon(1e-13));
}

}  // namespace
