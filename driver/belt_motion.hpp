// SPDX-License-Identifier: Apache-2.0
// The belt of a SLIPRING on its way through the history: what follows from the prescribed motions,
// nodes and tensions before friction is asked.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "driver/case/case.hpp"
#include "driver/simulation.hpp"
#include "law/return_mapping.hpp"

namespace slipbench::driver {

/// Puts the belt where a row's quantities say: the distance CP1 and the wrap angle from the nodes,
/// reference length and strain from distance and flows, the tension f1 from the strain where the
/// belt is elastic. A function of the row alone, so that a
/// resumed run has the same belt. `problem.belt` must be there.
/// \return what cannot be, in words: no material left, no distance, a negative tension
std::optional<std::string> move_belt(const Case& problem, Row& row);

/// Gives the law what a belt adds: the strain as the constitutive motion of component 1, and the
/// wrap angle where nodes make it.
void prepare_belt(const Case& problem, const Row& row, law::ConnectorIncrement& increment,
                  std::span<law::FrictionDefinition> definitions);

}  // namespace slipbench::driver
