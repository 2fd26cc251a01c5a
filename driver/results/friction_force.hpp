// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::results {

/// The friction force a definition is known by [F], [F L]: that of its component, signed, or P of a
/// coupled definition.
inline double representative_force(const cases::CaseDefinition& definition,
                                   const law::FrictionState& state) {
  const law::SlipSpace& slip = definition.law.slip;
  if (!definition.coupled && slip.dimension == 1) return slip.scale[0] * state.force[0];
  return law::equivalent_force(definition.law, state);
}
inline double representative_force(const cases::CaseDefinition& definition,
                                   const bench::DefinitionRow& row) {
  return representative_force(definition, row.update.state);
}

/// The state of a row with the force that the limit bounds: with a filter, that before it.
inline law::FrictionState limited_state(const law::FrictionDefinition& definition,
                                        const bench::DefinitionRow& row) {
  law::FrictionState state = row.update.state;
  if (definition.formulation && law::smooths(*definition.formulation)) {
    state.force = row.penalty.raw;
  }
  return state;
}

/// The representative force of that state.
inline double limited_force(const cases::CaseDefinition& definition,
                            const bench::DefinitionRow& row) {
  if (!definition.law.formulation) return representative_force(definition, row);
  return representative_force(definition, limited_state(definition.law, row));
}

}  // namespace slipbench::driver::results
