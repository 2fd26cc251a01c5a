// SPDX-License-Identifier: Apache-2.0
// Exact integration: the continuous solution of the friction law over one straight piece of its
// history, so that a history of straight pieces has the same end however it is divided.
#pragma once

#include <optional>

#include "law/exact/path_segment.hpp"
#include "law/exact/regime_change.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// Reason why a definition has no continuous solution, or none that is defined.
enum class NoContinuousSolution {
  kWeakening,  ///< constant stick stiffness and a coefficient that falls with the rate of the slip
  kWearAtStart,          ///< the accumulated slip of an increment's start: what that is depends on
                         ///< increments
  kShiftWithElasticSlip  ///< a shifted potential, an allowable elastic slip, and a limit that
                         ///< changes with the slip: the elastic slip that is allowed changes with
                         ///< it
};
/// Judged once for a definition, not on the update path.
std::optional<NoContinuousSolution> no_continuous_solution(const FrictionDefinition& definition);

/// Way in which `continuous_update` integrates a definition.
enum class ContinuousMethod {
  kEvents,        ///< stick, slip and open with located changes; closed where the limit is constant
  kExtrapolation  ///< sub-increments of the backward Euler update, extrapolated to the tolerance
};
ContinuousMethod continuous_method(const FrictionDefinition& definition);

/// `update` for a whole straight segment (theory 11.9). Changes between stick, slip and open, and
/// all corners of the limit, are located inside of it. Where the slip radius R (F_lim/kappa, or
/// g_c) is constant the geometry is closed (exact_segment.hpp); where it changes, slip obeys
///   d(psi)/dr = -sin(psi)/R,   dL = cos(psi) dr - dR,
/// which an embedded Runge-Kutta pair follows to `tolerance`; in one dimension that is a quadrature
/// of the energies only. With a constant stick stiffness work = dissipation + d(stored energy).
/// A Potential, and a constant stick stiffness with a coefficient that rises with the slip rate, go
/// by `extrapolated_update`.
///
/// The tangent is that of `update` over the same increment. `dissipation` is the integral of F_lim
/// over the slip, `onset` the fraction at which the last slip began. Snap-back is gone through,
/// with `snap_back`, `jumps` and `lost`.
///
/// Bounds of the method: energies of a limit so small that an increment is more than 1e13 elastic
/// slips long (a coefficient on its floor of 1e-30) are not told, as stick ends within the rounding
/// of its fraction. A constant stick stiffness under a coefficient that sees the slip rate and
/// hardly rises from rest may change between stick and slip many times: errors of up to 1e-6 of the
/// limit were seen there, whatever the tolerance; corners of the coefficient below some 1e-12 of
/// the segment's rate are not met, which is seen in the work. Where changes follow each other so
/// closely that steps have to go over them, by more than 1e-8 of the segment, or that some
/// million evaluations of the limit do not reach its end, it is not `converged`.
///
/// \param tolerance of the force as a part of the limit, > 0; other results alike
/// \param[out] changes of regime inside the segment, if wanted; what was there is forgotten
/// \pre no_continuous_solution(definition) is empty
FrictionUpdate continuous_update(const FrictionDefinition& definition, const PathSegment& segment,
                                 const FrictionState& old, double tolerance,
                                 RegimeChanges* changes = nullptr) noexcept;

}  // namespace slipbench::law
