// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// One compared point of a pointwise check.
struct CausePoint {
  CurvePoint point;
  /// Of the definition whose friction force the quantity is: 0 open, 1 stick, 2 slip; -1 if it is
  /// none, or if that is not known.
  int status = -1;
  bool failing = false;
};

/// Scales and units of the deviations.
struct CauseScales {
  double tolerance = 0.0;  ///< of the check, in the quantity's unit
  std::string unit;        ///< of the quantity; may be empty
  bool over_time = true;   ///< whether the points' abscissa is a time
  std::string time_unit;   ///< may be empty
  /// True if the stick stiffness is that of an allowed elastic slip: then a larger coefficient
  /// makes the whole curve larger, in stick and slip alike.
  bool stiffness_follows_limit = false;
};

/// Guesses in one sentence, without a period at the end, why a pointwise check fails; empty if
/// nothing explains it. Tried in this order, f the result and r the reference:
/// - sign: f = -r;
/// - factor: f = q r everywhere (a unit, where q is a power of ten; no load, where q is 0), if some
///   of the failing points stick well below the largest force, where a coefficient changes nothing;
///   of a run that only sticks, the stick stiffness and a factor are one; where the stiffness
///   follows the limit, so are the coefficient and a factor;
/// - coefficient: f = q r in slip, and no stick point is off by more than the slip points are
///   (loops: a stick branch begins where the slip before it ended). Before the first slip only
///   those may be off where the reference has reached its limit and the result has not. From a
///   force alone, the coefficient and the normal force are one;
/// - stick stiffness: f - f0 = q (r - r0) in stick and f = r in slip, with f0, r0 the last slip
///   point before the stick, or 0; the amplitude of the motion is one with it;
/// - factor, if nothing of the friction explains it either;
/// - offset: f = r + c everywhere;
/// - delay: f(t) = r(t - d), over time only.
/// A cause is told only if it explains 95 % of the failing points, and of all points that it speaks
/// of, to within 10 % of the tolerance or 1 % of their deviation, and if it can be told from the
/// others: against a reference of one level a ratio is an offset as well, and nothing is said
/// unless all of it is slip. In loops a fifth of the failing slip points (of the stiffness, two
/// fifths of all) may be on the way between the two curves, where only one of them has reached its
/// limit. Fewer than 3 failing points (of a delay 5) explain nothing.
///
/// \param points in the order of their history; all of a check's or an even selection of them
std::string likely_cause(std::span<const CausePoint> points, const CauseScales& scales);

}  // namespace slipbench::driver::check
