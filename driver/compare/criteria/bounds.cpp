// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/criteria/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/compare/common_range.hpp"

namespace slipbench::driver {
namespace {

/// Below this part of its magnitude, the range of values is their rounding.
constexpr double kNearlyConstant = 1e-9;

}  // namespace

double scale_of(std::span<const double> values) {
  if (values.empty()) return 0.0;
  const Interval range = extent(values);
  const double magnitude = std::max(std::abs(range.from), std::abs(range.to));
  return range.width() < kNearlyConstant * magnitude ? magnitude : range.width();
}

double value_bound(const Tolerance& tolerance, double scale) {
  if (!tolerance.absolute && !tolerance.relative && tolerance.abscissa) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(tolerance.absolute.value_or(0.0), tolerance.relative.value_or(0.0) * scale);
}

double position_bound(const Tolerance& tolerance, double scale) {
  if (!tolerance.abscissa && !tolerance.relative) return std::numeric_limits<double>::infinity();
  return std::max(tolerance.abscissa.value_or(0.0), tolerance.relative.value_or(0.0) * scale);
}

CurveComparison incomparable(std::string fault) {
  CurveComparison comparison;
  comparison.fault = std::move(fault);
  return comparison;
}

CurveComparison compared(std::size_t points, std::vector<Measure> measures) {
  CurveComparison comparison;
  comparison.compared = static_cast<std::int64_t>(points);
  comparison.measures = std::move(measures);
  return comparison;
}

Measure judged(std::string name, MeasureUnit unit, double value, double reference) {
  Measure measure;
  measure.name = std::move(name);
  measure.unit = unit;
  measure.value = value;
  measure.reference = reference;
  measure.deviation = std::abs(value - reference);
  return measure;
}

}  // namespace slipbench::driver
