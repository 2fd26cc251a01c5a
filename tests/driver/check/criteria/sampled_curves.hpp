// SPDX-License-Identifier: Apache-2.0
// Curves whose truth is known, sampled as one likes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/curves/series.hpp"

namespace slipbench::driver::check {

/// Positions along straight branches between turning points, `rows` increments a branch; ragged
/// ones differ in width by up to half of their mean.
inline std::vector<double> zigzag(const std::vector<double>& turns, int rows, bool ragged = false) {
  std::vector<double> positions{turns.front()};
  for (std::size_t b = 1; b < turns.size(); ++b) {
    for (int i = 1; i <= rows; ++i) {
      const double shift = ragged && i < rows ? 0.25 * std::sin(5.0 * i) : 0.0;
      const double fraction = (i + shift) / rows;
      positions.push_back(i == rows ? turns[b]
                                    : turns[b - 1] + fraction * (turns[b] - turns[b - 1]));
    }
  }
  return positions;
}

/// A value over positions that only increase or decrease.
inline Series sampled(const std::vector<double>& positions,
                      const std::function<double(double)>& value) {
  Series curve;
  curve.abscissa = positions;
  for (const double x : positions) curve.value.push_back(value(x));
  return curve;
}

/// An elastic-frictional slider: stiffness 1000 N/mm, limit 20 N, so that it breaks away after
/// 0.02 mm. Exact at every row.
inline constexpr double kStiffness = 1000.0;
inline constexpr double kLimit = 20.0;

inline Series slider(const std::vector<double>& positions, double start = 0.0) {
  Series curve;
  curve.abscissa = positions;
  double force = start;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i > 0) force += kStiffness * (positions[i] - positions[i - 1]);
    force = std::clamp(force, -kLimit, kLimit);
    curve.value.push_back(force);
    curve.time.push_back(static_cast<double>(i));
  }
  return curve;
}

/// In other units, or mirrored.
inline Series scaled(Series curve, double abscissa, double value) {
  for (double& x : curve.abscissa.change()) x *= abscissa;
  for (double& q : curve.value.change()) q *= value;
  return curve;
}

inline cases::Tolerance relative(double part) {
  return {.absolute = {}, .relative = part, .why = {}};
}
inline cases::Tolerance absolute(double size) {
  return {.absolute = size, .relative = {}, .why = {}};
}

inline const Measure& measure(const CurveComparison& comparison, std::string_view name) {
  return *std::find_if(comparison.measures.begin(), comparison.measures.end(),
                       [name](const Measure& m) { return m.name == name; });
}

inline bool passed(const CurveComparison& comparison) {
  return comparison.fault.empty() && !comparison.measures.empty() &&
         std::all_of(comparison.measures.begin(), comparison.measures.end(),
                     [](const Measure& m) { return m.passed(); });
}

}  // namespace slipbench::driver::check
