// SPDX-License-Identifier: Apache-2.0
// A coefficient that depends on the direction of the slip: an option of the bench, outside the law.
#pragma once

#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::bench {

/// Tells whether an increment loads a definition of one component backward: its elastic slip at the
/// end is negative if nothing slips. A spring that ends relaxed takes the direction of the motion,
/// and is loaded forward where nothing moves.
/// \param elastic_slip at the begin of the increment
/// \param left of the motion of the increment for the friction, behind a dead zone
/// \param motion of the connector
bool loads_backward(double elastic_slip, double left, double motion) noexcept;

/// Corrects the work and the onset of an increment in which the force turned to the other direction
/// and so to the other coefficient: what the law sees as one straight line from force to force has
/// a corner where the force is 0. The force falls to 0 along the old stiffness and gives its energy
/// back. Then it rises along the new one, which is another where the stick stiffness follows the
/// limit, or stays 0 where the coefficient of the new direction is 0.
/// \param old the state at the begin of the increment
/// \param left motion that the law saw, in the unit of its slip space [L]
void split_at_zero_force(const law::FrictionDefinition& definition, const law::FrictionState& old,
                         double left, law::FrictionUpdate& update) noexcept;

}  // namespace slipbench::driver::bench
