// SPDX-License-Identifier: Apache-2.0
// Wear that takes the limit away faster than the stick spring follows (theory 11.4): met by the
// slip of an increment, not judged beforehand.
#pragma once

#include "law/definition/limit_function.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// Returns true if slip within an increment can meet a fold of the path of roots at all: the limit
/// sees the slip of the increment through wear, and a spring of constant stiffness pulls.
inline bool may_snap_back(const FrictionDefinition& definition) noexcept {
  return definition.stick.mode == StickStiffness::Mode::kStiffness &&
         definition.accumulated_slip == AccumulatedSlipTiming::kEnd &&
         depends_on_accumulated_slip(definition.internal_contact_force);
}

/// Largest beta = -dF_lim/d(dL) / kappa of wear on the way from 0 to `slip`, at least 0. A
/// coefficient that rises with the slip rate helps the spring: its slope counts with kappa; one
/// that falls is another matter (increment_thresholds). From 1 on the first root has jumped.
/// \param kappa > 0 [F/L]
double largest_snap_back(const LimitFunction& limit, double kappa, double slip) noexcept;

/// The way from 0 to `slip` of a force that follows kappa x + F_lim(x) = Q while the trial force Q
/// grows, and jumps at constant Q where that sum falls.
struct SnapBackPath {
  int jumps = 0;
  double at_rest = 0.0;        ///< F_lim without slip [F]
  double first_level = 0.0;    ///< Q at the first of them [F]
  double lost = 0.0;           ///< of the spring's energy, in the jumps [F L]
  double friction_work = 0.0;  ///< integral of F_lim over the slip [F L]
  /// Work that is missing to a force already beyond the limit at rest, `start` > F_lim(0) [F L].
  double fallen = 0.0;
};

/// \param start trial force before the increment's motion [F]
/// \param opens whether the limit is worn away at `slip`: what the spring still holds there is lost
SnapBackPath snap_back_path(const LimitFunction& limit, double kappa, double slip, double start,
                            bool opens) noexcept;

/// Puts the energies of a path with jumps into an update in place of those of one step to its end.
/// \param start, trial as above, and at the end of the motion [F]
/// \param stored energy before the increment [F L]
void book_jumps(const SnapBackPath& path, double start, double trial, double stored,
                FrictionUpdate* update) noexcept;

}  // namespace slipbench::law
