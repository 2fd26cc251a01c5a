// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "law/definition/friction_definition.hpp"
#include "law/definition/friction_state.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::law {

/// Consistent tangent of the slip-space force y, in the form it has for every regime:
///   dy/ds    = transverse (I - n n^T) + radial n n^T + rate n m^T     [F/L], unsymmetric by `rate`
///   dy/dF_C  = contact n                                             [1]
/// with n the direction of y, m that of ds. In stick transverse = radial.
/// F_C stands for all that changes the contact force F_C + F_int from outside; docs/theory,
/// section 12. With a Potential the four are what its tangent is made of: kappa, dF_lim/d(dL),
/// dF_lim/d|ds| and dF_lim/dF_C (potential_tangent). With a formulation n is the direction before
/// the filter, and penalty_tangent has the whole.
struct SlipTangent {
  double transverse = 0.0;
  double radial = 0.0;
  double rate = 0.0;
  double contact = 0.0;
  double clip = 1.0;  ///< of a formulation: what clipping behind the filter left of the force
};

/// Result of one increment of one definition.
struct FrictionUpdate {
  FrictionState state;
  /// n = y/|y|, or 0 where there is no force; with a Potential m/|m|^2 with m = dP/dy, so that
  /// n . ds is the equivalent slip of steady sliding.
  std::array<double, kComponents> direction{};
  std::array<double, kComponents> motion_direction{};  ///< m = ds/|ds|, or 0
  SlipTangent tangent;
  double phi = 0.0;             ///< P - F_lim [F]; in slip the residual of the return mapping
  double normal_force = 0.0;    ///< F_N [F]
  double contact_force = 0.0;   ///< F_C + F_int with its sign [F]
  double mu = 0.0;              ///< coefficient used
  double limit = 0.0;           ///< F_lim [F]
  double slip_increment = 0.0;  ///< dL [L]
  double slip_rate = 0.0;       ///< the rate the coefficient saw [L/T]
  double wear = 0.0;            ///< dF_int/d(accumulated slip) [F/L]; 0 of a belt
  double dissipation = 0.0;     ///< F_lim dL of this increment [F L], never negative
  double stored_energy = 0.0;   ///< y . s_el / 2 at the end [F L]
  double work = 0.0;            ///< of y over ds, split at the stick-slip point [F L]
  /// Of an increment that ends in slip: the part of it that is over when the trial force meets the
  /// limit of its end, 0 where it slips from the start; exact in one dimension at a constant limit.
  /// Of one whose slip wears the limit away, or makes the force jump: the limit without slip.
  double onset = 0.0;
  /// Of an orthotropic law: the predictor along its axes [F], which its tangent is made of.
  std::array<double, 2> trial{};
  /// Largest beta = |dF_lim/d(slip)| / kappa of wear on the way of the increment's slip (theory
  /// 11.4); from 1 on the force has jumped at constant motion (snap-back). 0 where nothing wears,
  /// with an elastic slip, and where the limit sees the accumulated slip of the start.
  double snap_back = 0.0;
  /// Spring energy that such jumps lost: neither friction work nor stored [F L]; of
  /// continuous_update also what a term without pull has held when the limit is gone. With a jump,
  /// `dissipation` is the integral of F_lim over the slip, and `work` all three together.
  double lost = 0.0;
  double jump_onset = 0.0;      ///< the part of the increment that is over at the first jump
  int jumps = 0;                ///< of the force in this increment
  bool multiple_roots = false;  ///< the limit falls too fast for one certain solution
  bool converged = true;        ///< false: a return to a potential found no solution
};

/// Tells whether the numbers of an update are finite.
inline bool all_finite(const FrictionUpdate& update) {
  // A force or an elastic slip that is not finite spoils work and stored energy too. Two short sums
  // run side by side where one long one would wait for itself. One infinity or NaN spoils the sum.
  return std::isfinite(
      (update.limit + update.normal_force + update.mu + update.phi) +
      (update.stored_energy + update.work + update.dissipation + update.state.accumulated_slip));
}

/// Friction force per connector component: f_i = R_i y_i [F], [F L].
ConnectorForce friction_force(const FrictionDefinition& definition, const FrictionState& state);

/// P [F], the magnitude of the tangential force: the norm of y, or what a Potential makes of it.
double equivalent_force(const FrictionDefinition& definition, const FrictionState& state) noexcept;
/// The equivalent elastic slip [L]: |s_el|, or P(s_el) of a Potential with its shifts left out.
double equivalent_elastic_slip(const FrictionDefinition& definition,
                               const FrictionState& state) noexcept;

/// One increment of one definition: predictor, admissibility, return mapping, tangent
/// (docs/theory, section 11). Pure: the old state is not touched, nothing is allocated, nothing is
/// thrown. Preconditions (checked where a definition is built): stick.value > 0, scales > 0,
/// ordinates of mu and of F_int not negative, increment.end.fields as long as the tables need.
FrictionUpdate update(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                      const FrictionState& old) noexcept;

/// The same without what only tells of the increment: energies, work, onset, phi, direction of the
/// motion, jumps and further roots stay as they are by default where a definition has the Euclidean
/// norm.
/// For running a history many times over; state and `tangent` are those of update(), bit by
/// bit. Not for connector_tangent(), which needs the direction of the motion.
FrictionUpdate update_force(const FrictionDefinition& definition,
                            const ConnectorIncrement& increment, const FrictionState& old) noexcept;

}  // namespace slipbench::law
