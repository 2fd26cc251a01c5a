// SPDX-License-Identifier: Apache-2.0
// When the return mapping with a constant stick stiffness has one solution (theory 11.4): judged
// for a definition or behind an increment, not on the update path.
#pragma once

#include <optional>

#include "law/definition/friction_definition.hpp"

namespace slipbench::law {

/// kappa [F/L] of a definition at the limit F_lim [F] of one increment.
double stick_stiffness(const FrictionDefinition& definition, double limit);

/// The ends of one cell of a table along one independent.
struct CellRange {
  double begin = 0.0;
  double end = 0.0;
};
/// Wear against stick stiffness: beta = growth fall / (along kappa), the beta = mu c / k of
/// reference case W1 with the worst of the tables. At beta >= 1 the force drops at constant motion
/// (snap-back), if a run gets there: FrictionUpdate::snap_back tells of that. Where the coefficient
/// grows with the contact force without bound there is no worst, and `ratio` is 0.
struct SnapBack {
  double growth = 0.0;               ///< largest d(mu F_N)/dF_N [1]
  double fall = 0.0;                 ///< steepest -dF_int/d(accumulated slip) [F/L]
  double along = 1.0;                ///< least |m|^2 of a potential's normals m = dP/dy [1]
  double ratio = 0.0;                ///< beta; 0 where none can be met (may_snap_back)
  CellRange slip;                    ///< where it falls so [L]
  std::optional<CellRange> contact;  ///< where it grows so [F], of a table over the contact force
};
SnapBack snap_back(const FrictionDefinition& definition);
/// The same after a change of law and stick stiffness, which leaves `fall` as it is: the table of
/// wear, which may be long, is not walked through again.
SnapBack changed_snap_back(const SnapBack& before, const FrictionLaw& law, double stiffness);

/// The increments that decide what backward Euler makes of a coefficient that falls with the slip
/// rate (theory 11.4, 14.9). Both are 0 where they decide nothing: where the
/// coefficient does not fall or sees the rate of the relative motion, where the cap holds, and
/// where the stick stiffness follows the limit, which makes dL independent of it.
struct IncrementThresholds {
  double normal_force = 0.0;  ///< F_N they were taken at [F]
  double weakening = 0.0;     ///< -dmu/d(slip rate) at the rate of the motion [T/L]
  /// Shorter increments do not settle on the smooth answer F_lim(v): 2 |dF_lim/dv| / kappa [T].
  double smooth = 0.0;
  /// Longer increments have one solution: the steepest |dF_lim/dv| of the law / kappa [T]; of a
  /// belt a bound, exp(A) at the largest coefficient.
  double unique = 0.0;
};
/// Bounds of a coefficient: its largest value [1] and its steepest fall with the slip rate
/// [T/L]. Of a table both take a walk over all cells, so they are kept between increments. Infinity
/// where the law has no bound over all rates and contact forces.
struct CoefficientBounds {
  double largest = 0.0;
  double steepest_weakening = 0.0;
};
CoefficientBounds coefficient_bounds(const FrictionLaw& law);
/// The same over the slip rates from 0 to `rate` [L/T] at one contact force [F], which have one:
/// for a law without a bound over all. A rate beyond overflow counts as far as that.
CoefficientBounds coefficient_bounds(const FrictionLaw& law, const Ambient& ambient,
                                     double contact_force, double rate);

/// Returns the thresholds; where the law has no bounds over all rates, `unique` is taken over those
/// up to `rate`: it is always finite.
/// \param bounds of the definition's law
/// \param rate |ds|/dt of the relative motion [L/T]
IncrementThresholds increment_thresholds(const FrictionDefinition& definition,
                                         const CoefficientBounds& bounds, const Ambient& end,
                                         double normal_force, double rate);
inline IncrementThresholds increment_thresholds(const FrictionDefinition& definition,
                                                const Ambient& end, double normal_force,
                                                double rate) {
  return increment_thresholds(definition, coefficient_bounds(definition.law), end, normal_force,
                              rate);
}
/// Tells whether a definition may have such thresholds at all while its coefficient follows `law`,
/// its own or that of the other sense.
bool has_increment_thresholds(const FrictionDefinition& definition, const FrictionLaw& law);

}  // namespace slipbench::law
