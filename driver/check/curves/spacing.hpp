// SPDX-License-Identifier: Apache-2.0
// Distances of rows from their neighbours, so that a message can tell them apart.
#pragma once

#include <limits>
#include <string>

#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// The distances of a row to the nearer of its neighbours; infinite where there is none. Neighbours
/// in the same place but for rounding (kSameTime) are not told apart.
struct Spacing {
  double abscissa = std::numeric_limits<double>::infinity();
  double time = std::numeric_limits<double>::infinity();
};

Spacing spacing(const CurvePoint& a, const CurvePoint& b);

/// The smaller distances of two.
Spacing narrower(const Spacing& a, const Spacing& b);

/// A point that a message names.
struct ToldPoint {
  CurvePoint point;
  Spacing spacing;
};

/// A point of a curve with the distances of the rows around it; found by its time, so without a
/// time, or of a curve without times, nothing is known of its neighbours.
ToldPoint told_point(const CurvePoint& point, const Series& curve);

/// A time or a position with as many digits as tell it from a neighbour at this distance: at least
/// 4, at most 17.
std::string place_text(double value, double distance);

}  // namespace slipbench::driver::check
