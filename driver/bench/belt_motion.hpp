// SPDX-License-Identifier: Apache-2.0
// The belt of a SLIPRING on its way through the history: what follows from the prescribed motions,
// nodes and tensions before friction is asked.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::bench {

/// Puts the belt where a row's quantities say: the distance CP1 and the wrap angle from the nodes,
/// reference length and strain from distance and flows, the tension f1 from the strain and its rate
/// where the belt is elastic. Of the row before it takes the strain and the turn that follows the
/// nodes, which come from prescribed motions too: a resumed run, which walks through its history,
/// has the same belt. `problem.belt` must be there.
/// \return what cannot be, in words: no material left, no distance, one beyond a stop or below a
///         hundredth of the first, a negative tension
std::optional<std::string> move_belt(const cases::Case& problem, Row& row);

/// Returns the reference length of segment ab at the flows CP2 and CP3 of a position [L].
/// `problem.belt` must be there.
double reference_length(const cases::Case& problem, const law::RelativePosition& position);

/// Gives the law what a belt adds: the strain as the constitutive motion of component 1, and the
/// wrap angle where nodes make it.
void prepare_belt(const cases::Case& problem, const Row& row, law::ConnectorIncrement& increment,
                  std::span<law::FrictionDefinition> definitions);

/// Puts the segment behind a ring where the ring's update and the flow over it say, if its length
/// is known: strain and reference length from the tension, and from both flows what leaves at its
/// end. \return what cannot be, in words: a tension beyond the elasticity
std::optional<std::string> move_behind(const cases::Case& problem, std::size_t ring, Row& row);

/// Gives the law what the ring after `ring` meets: the tension behind `ring`, and the flow out of
/// the segment between them where that is known; else all rings share CP2.
void meet_next_ring(const cases::Case& problem, std::size_t ring, const Row& row,
                    law::ConnectorIncrement& increment);

}  // namespace slipbench::driver::bench
