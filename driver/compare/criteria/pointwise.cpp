// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/criteria/pointwise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "driver/compare/branches.hpp"
#include "driver/compare/common_range.hpp"
#include "driver/compare/criteria/bounds.hpp"
#include "driver/compare/interpolation.hpp"

namespace slipbench::driver {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double time_at(const Series& curve, std::size_t row) {
  return curve.time.empty() ? kUnknown : curve.time[row];
}

/// The time of the result, or failing that of the reference.
double known_time(double ours, double theirs) { return std::isnan(ours) ? theirs : ours; }

std::vector<CurvePoint> row_by_row(const Series& result, const Series& reference) {
  std::vector<CurvePoint> points;
  points.reserve(reference.size());
  for (std::size_t i = 0; i < reference.size(); ++i) {
    points.push_back({reference.abscissa[i], result.value[i], reference.value[i],
                      known_time(time_at(result, i), time_at(reference, i))});
  }
  return points;
}

}  // namespace

PointwiseComparison compare_points(const Series& result, const Series& reference) {
  PointwiseComparison comparison;
  const CommonRange common = common_range(result, reference);
  comparison.fault = common.fault;
  if (!comparison.fault.empty()) return comparison;
  if (result.abscissa == reference.abscissa) {
    comparison.points = row_by_row(result, reference);
    return comparison;
  }
  const MatchedBranches matched = match_branches(result, reference);
  comparison.fault = matched.fault;
  if (!comparison.fault.empty()) return comparison;
  const std::size_t count = matched.reference_branches.size();
  comparison.points.reserve(matched.reference.size());
  for (std::size_t b = 0; b < count; ++b) {
    BranchInterpolation ours(matched.result, matched.result_branches[b], common.slack);
    const Branch& theirs = matched.reference_branches[b];
    const std::size_t before = comparison.points.size();
    const bool skips_first = b > 0 || matched.first_is_interpolated;
    const bool skips_last = b + 1 == count && matched.last_is_interpolated;
    const std::size_t end = theirs.last + (skips_last ? 0 : 1);
    for (std::size_t i = theirs.first + (skips_first ? 1 : 0); i < end; ++i) {
      const double x = matched.reference.abscissa[i];
      const double wanted = matched.reference.value[i];
      const auto found = ours.at(x, wanted);
      if (!found) continue;
      comparison.points.push_back(
          {x, found->value, wanted, known_time(found->time, time_at(matched.reference, i))});
    }
    if (comparison.points.size() == before && count > 1) {
      comparison.fault = fmt::format(
          "branch {} of {} of the reference has no row that the result covers", b + 1, count);
      return comparison;
    }
  }
  if (comparison.points.empty()) {
    comparison.fault =
        fmt::format("no row of the reference lies in the common range, {:.9g} to {:.9g}",
                    common.interval.from, common.interval.to);
  }
  return comparison;
}

double scale_of(const std::vector<CurvePoint>& points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const CurvePoint& point : points) values.push_back(point.reference);
  return scale_of(values);
}

CurveComparison compare_pointwise(const Series& result, const Series& reference,
                                  const Tolerance& tolerance) {
  const PointwiseComparison comparison = compare_points(result, reference);
  if (!comparison.fault.empty()) return incomparable(comparison.fault);
  const auto deviation = [](const CurvePoint& p) { return std::abs(p.value - p.reference); };
  const CurvePoint& worst = *std::max_element(
      comparison.points.begin(), comparison.points.end(),
      [&](const CurvePoint& a, const CurvePoint& b) { return deviation(a) < deviation(b); });
  Measure measure =
      judged("largest deviation", MeasureUnit::kQuantity, worst.value, worst.reference);
  measure.scale = scale_of(comparison.points);
  measure.tolerance = value_bound(tolerance, measure.scale);
  measure.where = worst;
  return compared(comparison.points.size(), {std::move(measure)});
}

}  // namespace slipbench::driver
