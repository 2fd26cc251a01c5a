// SPDX-License-Identifier: Apache-2.0
// Packs whose lanes differ in one thing only, each with its own result.
#include "law/batch/pack.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "law/friction/law_list.hpp"

namespace {

using namespace slipbench::law;

TEST_CASE("lanes that different components press have limits of their own") {
  std::vector<FrictionDefinition> definitions(3);
  for (std::size_t lane = 0; lane < definitions.size(); ++lane) {
    definitions[lane].law = ConstantCoefficient{0.5};
    definitions[lane].contact_force = ComponentContactForce{static_cast<int>(lane) + 1};
  }
  ConnectorIncrement increment;
  increment.duration = 1.0;
  increment.end.position[0] = 1.0;
  increment.end.motion[0] = 1.0;
  for (int lane = 0; lane < 3; ++lane) increment.force[lane + 1] = 10.0 * (lane + 1);
  Pack pack(definitions, {});
  pack.advance(std::array{increment}, InstructionSet::kPortable);
  for (std::size_t lane = 0; lane < definitions.size(); ++lane) {
    CHECK(pack.is_common(lane));
    CHECK(pack.state(lane).force[0] == 5.0 * static_cast<double>(lane + 1));
  }
}

}  // namespace
