// SPDX-License-Identifier: Apache-2.0
// States of friction that differ in one member.
#include "law/definition/friction_state.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace slipbench::law;

TEST_CASE("states are equal if all they hold is") {
  const FrictionState state;
  FrictionState other = state;
  CHECK(other == state);
  other.elastic_slip[5] = 1e-3;
  CHECK_FALSE(other == state);
  other = state;
  other.force[5] = 1.0;
  CHECK_FALSE(other == state);
  other = state;
  other.regime = Regime::kOpen;
  CHECK_FALSE(other == state);
  other = state;
  other.accumulated_slip = {1.0, 0.0};
  CHECK_FALSE(other == state);
  other = state;
  other.accumulated_slip = {0.0, 1e-20};
  CHECK_FALSE(other == state);
}

}  // namespace
