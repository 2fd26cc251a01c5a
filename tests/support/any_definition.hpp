// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "law/definition/friction_definition.hpp"
#include "law/friction/law_list.hpp"
#include "law/update/penalty_update.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/random_definition.hpp"
#include "tests/support/random_history.hpp"
#include "tests/support/random_law.hpp"

namespace slipbench::test {

/// Returns any law of the list.
inline law::FrictionLaw any_law(Dice& dice) {
  law::FrictionLaw made;
  const int wanted = dice.pick(static_cast<int>(std::variant_size_v<law::LawList>));
  int index = 0;
  [&]<class... Law>(std::type_identity<std::variant<Law...>>) {
    ((index++ == wanted ? static_cast<void>(made = random_law<Law>(dice)) : static_cast<void>(0)),
     ...);
  }(std::type_identity<law::LawList>{});
  return made;
}

inline law::Formulation any_formulation(Dice& dice, const law::FrictionDefinition& definition) {
  law::Formulation formulation;
  if (dice.chance(0.5)) {
    formulation.penalty = law::StiffnessPenalty{dice.between(1.0, 1e3)};
  } else {
    law::ViscousPenalty viscous{
        dice.between(0.1, 2.0), dice.between(1.0, 1e3), dice.between(0.1, 2.0), {}};
    if (dice.chance(0.3)) viscous.coefficient = dice.between(0.0, 2.0);
    formulation.penalty = viscous;
  }
  formulation.filter = {static_cast<law::Filter::Kind>(dice.pick(4)), dice.between(0.1, 0.9),
                        dice.chance(0.5)};
  formulation.convention = static_cast<law::Convention>(dice.pick(2));
  if (definition.slip.dimension == 2 && dice.chance(0.7)) {
    formulation.orthotropy = {
        any_law(dice), {0.6, 0.8}, static_cast<law::Orthotropy::Speed>(dice.pick(2))};
  }
  return formulation;
}

/// Returns any definition that updates can be made of: of all kinds, laws, potentials,
/// formulations.
inline law::FrictionDefinition any_definition(Dice& dice) {
  law::FrictionDefinition definition =
      random_definition(&dice, dice.pick(kDefinitionKinds), {}).build();
  if (dice.chance(0.6)) definition.law = any_law(dice);
  if (dice.chance(0.2)) definition.formulation = any_formulation(dice, definition);
  return definition;
}

/// One increment of any definition.
inline law::FrictionUpdate any_update(const law::FrictionDefinition& definition,
                                      const law::ConnectorIncrement& increment,
                                      const law::FrictionState& old) {
  return definition.formulation ? law::update_penalty(definition, increment, old)
                                : law::update(definition, increment, old);
}

/// Returns the updates of a history from a state at rest, with a formulation or without.
inline std::vector<law::FrictionUpdate> run_any(const law::FrictionDefinition& definition,
                                                const std::vector<HistoryRow>& rows) {
  std::vector<law::FrictionUpdate> updates;
  law::FrictionState state;
  for (const HistoryRow& row : rows) {
    updates.push_back(any_update(definition, row.increment(), state));
    state = updates.back().state;
  }
  return updates;
}

}  // namespace slipbench::test
