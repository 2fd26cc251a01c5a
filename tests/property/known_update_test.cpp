// SPDX-License-Identifier: Apache-2.0
#include "law/update/known_update.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "law/update/return_mapping.hpp"
#include "tests/support/random_definition.hpp"
#include "tests/support/random_history.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// All that update_known() sets, by its bits.
std::vector<std::uint64_t> bits(const FrictionUpdate& u) {
  std::vector<std::uint64_t> all;
  for (const auto& v : {u.state.elastic_slip, u.state.force, u.direction}) {
    for (const double x : v) all.push_back(std::bit_cast<std::uint64_t>(x));
  }
  for (const double x :
       {double{u.state.accumulated_slip}, u.state.accumulated_slip.left_out(), u.phi,
        u.normal_force, u.contact_force, u.mu, u.limit, u.slip_increment, u.slip_rate,
        u.dissipation, u.stored_energy, u.work, u.onset, u.snap_back, u.lost, u.jump_onset}) {
    all.push_back(std::bit_cast<std::uint64_t>(x));
  }
  for (const int n :
       {static_cast<int>(u.state.regime), u.jumps, u.multiple_roots ? 1 : 0, u.converged ? 1 : 0}) {
    all.push_back(static_cast<std::uint64_t>(n));
  }
  return all;
}

template <int D>
void compare(const FrictionDefinition& definition, const std::vector<HistoryRow>& rows,
             std::set<std::pair<int, Regime>>* drawn) {
  FrictionState old;
  KnownLimits limits(definition);
  std::array<FrictionUpdate, 2> in_turns;  // the old state must not be that of the result
  for (std::size_t k = 0; k < rows.size(); ++k) {
    INFO("increment " << k);
    const ConnectorIncrement increment = rows[k].increment();
    const FrictionUpdate expected = update(definition, increment, old);
    FrictionUpdate& found = in_turns[k % 2];
    const auto limit_of = [&](double motion) { return limits(increment, old, motion); };
    update_known<D>(definition, increment, old, limit_of, &found);
    REQUIRE(bits(found) == bits(expected));
    old = found.state;
    drawn->insert({D, old.regime});
  }
}

TEST_CASE("an increment with a known limit has the bits of update()") {
  std::set<std::pair<int, Regime>> drawn;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    INFO("seed " << seed);
    Dice dice(seed);
    const FrictionDefinition definition =
        random_definition(&dice, dice.pick(kDefinitionKinds)).build();
    if (!std::holds_alternative<EuclideanPotential>(definition.criterion) ||
        definition.formulation || !has_known_limit(definition)) {
      continue;
    }
    const std::vector<HistoryRow> rows = random_history(&dice, 2 + dice.pick(60));
    if (definition.slip.dimension == 1) compare<1>(definition, rows, &drawn);
    if (definition.slip.dimension == 2) compare<2>(definition, rows, &drawn);
    if (definition.slip.dimension == 3) compare<3>(definition, rows, &drawn);
  }
  // Stick and slip of all dimensions, and no contact of some.
  CHECK(drawn.size() >= 7);
}

}  // namespace
