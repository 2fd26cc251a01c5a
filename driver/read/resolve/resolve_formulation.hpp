// SPDX-License-Identifier: Apache-2.0
// The contact penalty of a friction definition: its formulation, filter and two directions.
#pragma once

#include <optional>

#include "driver/case/case.hpp"
#include "driver/read/keys/case_text.hpp"
#include "driver/read/resolve/resolve_definition.hpp"
#include "driver/yaml/binding.hpp"

namespace slipbench::driver::read {

/// The coefficient of one direction as a coefficient of its own.
yaml::At<CoefficientText> coefficient_of(const yaml::At<DirectionText>& direction);

/// Tells whether a definition has or implies a formulation: `formulation:`, or an orthotropic
/// coefficient beside `stick: {stiffness: ..}`. Then no default of `stick:` is in force.
bool has_formulation(const FrictionText& text);

/// The formulation of a definition with its filter and second direction; nothing if it has none or
/// one that is faulty, which is reported.
std::optional<law::Formulation> formulation(yaml::Binder& binder,
                                            const yaml::At<FrictionText>& friction,
                                            const LawSurroundings& surroundings);

/// Puts a formulation into a definition. What the connector's own return mapping knows of stick and
/// rate takes the values that mean the same.
void set_formulation(law::FrictionDefinition& definition, const law::Formulation& formulation);

/// The rules between a formulation and what the definition slips in: no potential, two components
/// of one kind for two directions.
/// \return whether they hold; else an error was reported
bool slip_suits_formulation(yaml::Binder& binder, const yaml::At<FrictionText>& friction,
                            const law::FrictionDefinition& definition);

/// The rules between formulations and the rest of the case: dynamics, components driven by force,
/// the increments of a filter's period. Goes after the history and the forces.
void check_formulations(yaml::Binder& binder, const CaseText& text, const cases::Case& problem);

}  // namespace slipbench::driver::read
