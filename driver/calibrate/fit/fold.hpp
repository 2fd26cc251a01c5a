// SPDX-License-Identifier: Apache-2.0
// A number between limits as a smooth function of a coordinate without limits.
#pragma once

#include <cmath>

namespace slipbench::driver::fit {

/// The limits of a number and the unit in which it leaves a single one.
struct Limits {
  double lower;  ///< or -infinity
  double upper;  ///< or infinity
  double unit;   ///< > 0, used where only one limit is finite
  bool both() const { return std::isfinite(lower) && std::isfinite(upper); }
  bool any() const { return std::isfinite(lower) || std::isfinite(upper); }
};

/// y(z) and what it changes by, dy = by_lower dlower + by_upper dupper + by_coordinate dz.
///
/// Two limits: y = lower + (upper - lower)(1 + sin z)/2. One limit: y = lower + unit (sqrt(1 + z^2)
/// - 1), or upper minus that. None: y = z. Where y meets a limit the map folds back, dy/dz = 0:
/// `inward` is what y changes by per unit of (1 -+ sin z)/2 or of sqrt(1 + z^2) there.
/// Source: the transformations of MINUIT (James and Roos 1975).
struct Folded {
  double value;
  double by_lower;
  double by_upper;
  double by_coordinate;
};
Folded fold(const Limits& limits, double coordinate);

/// The coordinate of y, moved inside by `inset` (of the coordinate, in radians or units) if y is on
/// or beyond a limit or closer to it.
double unfold(const Limits& limits, double value, double inset);

/// The same y with the coordinate of smallest magnitude: in [-pi/2, pi/2], or >= 0.
double principal_coordinate(const Limits& limits, double coordinate);

/// The nearest fold of a principal coordinate: where it is, and the sense that leads inside.
struct FoldPoint {
  double coordinate;
  double distance;  ///< from the coordinate, >= 0; infinite without limits
  double inward;    ///< +1: y rises to the inside with z, -1: with falling z
  double slope;     ///< dy per unit of the way inside (see Folded); sign included
};
FoldPoint nearest_fold(const Limits& limits, double coordinate);

}  // namespace slipbench::driver::fit
