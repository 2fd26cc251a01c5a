// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "law/definition/packed_definition.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/penalty_update.hpp"
#include "tests/support/random_definition.hpp"
#include "tests/support/random_history.hpp"
#include "tests/support/random_law.hpp"

namespace {

using namespace slipbench::law;
using namespace slipbench::test;

/// Any law of the list.
FrictionLaw any_law(Dice& dice) {
  FrictionLaw law;
  const int wanted = dice.pick(static_cast<int>(std::variant_size_v<LawList>));
  int index = 0;
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    ((index++ == wanted ? static_cast<void>(law = random_law<Law>(dice)) : static_cast<void>(0)),
     ...);
  }(std::type_identity<LawList>{});
  return law;
}

Formulation any_formulation(Dice& dice, const FrictionDefinition& definition) {
  Formulation formulation;
  if (dice.chance(0.5)) {
    formulation.penalty = StiffnessPenalty{dice.between(1.0, 1e3)};
  } else {
    ViscousPenalty viscous{
        dice.between(0.1, 2.0), dice.between(1.0, 1e3), dice.between(0.1, 2.0), {}};
    if (dice.chance(0.3)) viscous.coefficient = dice.between(0.0, 2.0);
    formulation.penalty = viscous;
  }
  formulation.filter = {static_cast<Filter::Kind>(dice.pick(4)), dice.between(0.1, 0.9),
                        dice.chance(0.5)};
  formulation.convention = static_cast<Convention>(dice.pick(2));
  if (definition.slip.dimension == 2 && dice.chance(0.7)) {
    formulation.orthotropy = {
        any_law(dice), {0.6, 0.8}, static_cast<Orthotropy::Speed>(dice.pick(2))};
  }
  return formulation;
}

FrictionDefinition any_definition(Dice& dice) {
  FrictionDefinition definition = random_definition(&dice, dice.pick(kDefinitionKinds), {}).build();
  if (dice.chance(0.6)) definition.law = any_law(dice);
  if (dice.chance(0.1)) definition.criterion = Capstan{dice.between(0.0, 7.0)};
  if (dice.chance(0.2)) definition.formulation = any_formulation(dice, definition);
  return definition;
}

std::vector<FrictionUpdate> run(const FrictionDefinition& definition,
                                const std::vector<HistoryRow>& rows) {
  std::vector<FrictionUpdate> updates;
  FrictionState state;
  for (const HistoryRow& row : rows) {
    const ConnectorIncrement increment = row.increment();
    updates.push_back(definition.formulation ? update_penalty(definition, increment, state)
                                             : update(definition, increment, state));
    state = updates.back().state;
  }
  return updates;
}

/// Compares by value, but for NaN: a filter with no clip may leave one.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

TEST_CASE("a definition that comes back from its numbers gives the same updates") {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    Dice dice(seed);
    const FrictionDefinition definition = any_definition(dice);
    const std::vector<double> packed = pack(definition);
    std::span<const double> rest(packed);
    const auto unpacked = unpack(rest);
    INFO("seed " << seed << ", law " << name_of(definition.law));
    REQUIRE(unpacked);
    CHECK(rest.empty());
    CHECK(pack(*unpacked) == packed);
    if (std::holds_alternative<Capstan>(definition.criterion))
      continue;  // their updates want a tension
    const std::vector<HistoryRow> rows = random_history(&dice, 20);
    const auto before = run(definition, rows);
    const auto after = run(*unpacked, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      REQUIRE(same(numbers(before[i]), numbers(after[i])));
    }
  }
}

TEST_CASE("definitions follow each other in one list of numbers") {
  Dice dice(7);
  std::vector<double> all;
  std::vector<std::vector<double>> each;
  for (int i = 0; i < 10; ++i) {
    each.push_back(pack(any_definition(dice)));
    all.insert(all.end(), each.back().begin(), each.back().end());
  }
  std::span<const double> rest(all);
  for (const std::vector<double>& one : each) {
    const auto unpacked = unpack(rest);
    REQUIRE(unpacked);
    CHECK(pack(*unpacked) == one);
  }
  CHECK(rest.empty());
}

TEST_CASE("numbers that are no definition are refused, and damaged ones do no harm") {
  int refused = 0;
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    Dice dice(seed);
    std::vector<double> packed = pack(any_definition(dice));
    const std::span<const double> whole(packed);
    std::span<const double> cut =
        whole.first(static_cast<std::size_t>(dice.pick(static_cast<int>(whole.size()))));
    const std::size_t left = cut.size();
    CHECK_FALSE(unpack(cut));
    CHECK(cut.size() == left);
    for (int times = 0; times < 20; ++times) {
      std::vector<double> damaged = packed;
      const std::vector<double> bad{std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::infinity(),
                                    -1.0,
                                    1e300,
                                    0.5,
                                    7.0,
                                    1e9};
      damaged[static_cast<std::size_t>(dice.pick(static_cast<int>(damaged.size())))] =
          dice.one_of(bad);
      std::span<const double> rest(damaged);
      const auto read = unpack(rest);
      if (!read) ++refused;
      // What is read can be written: all of its indices lie within.
      if (read) CHECK(pack(*read).size() <= damaged.size());
    }
  }
  CHECK(refused > 3000);
}

}  // namespace
