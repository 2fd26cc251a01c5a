// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slipbench::driver::check {
namespace {

/// Below this part of its magnitude, the range of values is their rounding.
constexpr double kNearlyConstant = 1e-9;

}  // namespace

double magnitude(const Interval& values) {
  return std::max(std::abs(values.from), std::abs(values.to));
}

double scale_of(std::span<const double> values) {
  return values.empty() ? 0.0 : scale_of(extent(values));
}

double scale_of(const Interval& values) {
  const double size = magnitude(values);
  return values.width() < kNearlyConstant * size ? size : values.width();
}

double least_scale(const Interval& values) {
  return std::max(values.width(), kNearlyConstant * magnitude(values));
}

double value_bound(const cases::Tolerance& tolerance, double scale) {
  if (!tolerance.absolute && !tolerance.relative && tolerance.abscissa) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(tolerance.absolute.value_or(0.0), tolerance.relative.value_or(0.0) * scale);
}

double position_bound(const cases::Tolerance& tolerance, double scale) {
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

}  // namespace slipbench::driver::check
