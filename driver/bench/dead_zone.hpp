// SPDX-License-Identifier: Apache-2.0
// Backlash in series with the friction of one component: an option of the bench, outside the law.
#pragma once

#include "driver/case/case.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::driver::bench {

/// Effect of an increment on the play, and the motion it leaves for the friction behind it.
struct PlayStep {
  double play = 0.0;    ///< p at the end of the increment
  double travel = 0.0;  ///< p_end - p_begin: passes without force
  double motion = 0.0;  ///< du - travel: what the law gets
};

/// Moves the play in series with an elastic slip by `motion` (docs/theory, section 13.6). The
/// extension s + p takes all of the motion as if nothing slipped; the play takes of it what fits
/// between its ends, so that a reversal first unloads the spring, then crosses the gap, then loads
/// the other way. Exact for a straight increment of any length.
/// \param play p at the begin of the increment
/// \param elastic_slip s at its begin, in the unit of the component
PlayStep move_play(const cases::DeadZone& zone, double play, double elastic_slip,
                   double motion) noexcept;

/// The signed elastic slip of a definition of one component, in the unit of the component: the
/// extension of its spring at the force it has, also where a change of friction altered the
/// stiffness in between.
double elastic_extension(const law::FrictionDefinition& definition,
                         const law::FrictionState& state) noexcept;

/// Takes what rounding of positions left of the force of a spring that ends relaxed: in the gap the
/// force is 0.
void relax(law::FrictionUpdate& update) noexcept;

/// Puts the onset of slip of an update, a fraction of the motion the law saw, into the increment
/// of the connector: the play is crossed before.
void place_onset(const PlayStep& step, law::FrictionUpdate& update) noexcept;

}  // namespace slipbench::driver::bench
