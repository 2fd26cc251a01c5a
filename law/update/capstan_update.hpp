// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// `update` for a definition whose criterion is a Capstan: one entry of slip space, the flow Psi_b,
/// with a limit of its own on either side (docs/theory, section 4.1). The
/// predictor's sign picks the side; stick is elastic in the flow, with kappa = limit / g_c of that
/// side or with a constant kappa.
FrictionUpdate update_capstan(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment,
                              const FrictionState& old) noexcept;

/// Both tensions given, no flow integrated: the belt sticks where |ln(f_bc / f_ab)| < A and the
/// force is below the force limit. The result has the force y = f_bc - f_ab, the coefficient at
/// rest, the limit of the side y lies on, and the regime; nothing slips. Open where neither tension
/// is positive, or where there is neither friction nor a force.
/// \param tension_behind f_bc [F]
FrictionUpdate judge_capstan(const FrictionDefinition& definition,
                             const ConnectorIncrement& increment, double tension_behind) noexcept;

/// |ln(f_bc / f_ab)| / A of an update [1], or |y| over a force limit below the band if that is
/// more: below 1 the belt sticks. Infinity where one side carries
/// nothing or there is no friction, 0 where both tensions are equal.
double capstan_utilisation(const FrictionUpdate& update, double wrap_angle) noexcept;

/// The tension f_bc behind the ring after an update [F]; never negative.
double tension_behind(const FrictionUpdate& update) noexcept;

}  // namespace slipbench::law
