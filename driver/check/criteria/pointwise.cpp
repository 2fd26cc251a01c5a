// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/pointwise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/criteria/point_judge.hpp"
#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/interpolation.hpp"

namespace slipbench::driver::check {
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

/// Tells whether no two rows of a curve, one after the other, are in one place.
bool always_moves(const Series& curve, double slack) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (std::abs(curve.abscissa[i] - curve.abscissa[i - 1]) <= slack) return false;
  }
  return true;
}

/// Goes along a branch of the reference and tells how far a row that rests reaches.
class Reach {
 public:
  Reach(const Series& reference, const Branch& branch, double slack)
      : x_(&reference.abscissa), branch_(branch), slack_(slack), end_(branch.first) {}

  /// The wider one of the increments beside the place that row `i` shares with others; 0 if it has
  /// the place for itself. Rows are asked for in their order.
  double of(std::size_t i) {
    if (i >= end_) find_place(i);
    return reach_;
  }

 private:
  double distance(std::size_t a, std::size_t b) const { return std::abs((*x_)[a] - (*x_)[b]); }

  void find_place(std::size_t i) {
    // The first row asked for may not be the first one of its place.
    std::size_t begin = i;
    while (begin > branch_.first && distance(begin - 1, i) <= slack_) --begin;
    end_ = i + 1;
    while (end_ <= branch_.last && distance(end_, i) <= slack_) ++end_;
    reach_ = 0.0;
    if (end_ - begin < 2) return;
    if (begin > branch_.first) reach_ = distance(begin, begin - 1);
    if (end_ <= branch_.last) reach_ = std::max(reach_, distance(end_, end_ - 1));
  }

  const std::vector<double>* x_;
  Branch branch_;
  double slack_;
  std::size_t end_;
  double reach_ = 0.0;
};

/// "the reference's rows there go from 0.05 to 0.1, the result from 0 to 0.099".
std::string uncovered(const MatchedBranches& matched, std::size_t b) {
  const auto range = [](const Series& curve, const Branch& branch) {
    return extent(std::span(curve.abscissa).subspan(branch.first, branch.last - branch.first + 1));
  };
  const Interval theirs = range(matched.reference, matched.reference_branches[b]);
  const Interval ours = range(matched.result, matched.result_branches[b]);
  return fmt::format(
      "branch {} of {} of the reference has no row that the result covers: it has rows between "
      "{:.9g} and {:.9g}, the result goes from {:.9g} to {:.9g} there",
      b + 1, matched.reference_branches.size(), theirs.from, theirs.to, ours.from, ours.to);
}

/// Returns why too few rows of a reference were met; empty if there are enough.
std::string too_few(const std::vector<CurvePoint>& points, const Series& result,
                    const Series& reference, const Interval& common) {
  const std::string range =
      fmt::format("the common range, {:.9g} to {:.9g}", common.from, common.to);
  if (points.empty()) return "no row of the reference lies in " + range;
  if (points.size() > 1 || reference.size() < 2 || result.size() < 2) return {};
  return fmt::format("only 1 of the reference's {} rows, at {:.9g}, lies in {}", reference.size(),
                     points.front().abscissa, range);
}

}  // namespace

PointwiseComparison compare_points(const Series& result, const Series& reference) {
  PointwiseComparison comparison;
  const CommonRange common = common_range(result, reference);
  comparison.fault = common.fault;
  if (!comparison.fault.empty()) return comparison;
  if (are_same_rows(result, reference) ||
      (result.abscissa == reference.abscissa && always_moves(result, common.slack))) {
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
    ours.match_rests(matched.reference, theirs);
    Reach reach(matched.reference, theirs, common.slack);
    const std::size_t before = comparison.points.size();
    const bool skips_first = b > 0 || matched.first_is_interpolated;
    const bool skips_last = b + 1 == count && matched.last_is_interpolated;
    const std::size_t end = theirs.last + (skips_last ? 0 : 1);
    for (std::size_t i = theirs.first + (skips_first ? 1 : 0); i < end; ++i) {
      const double x = matched.reference.abscissa[i];
      const double wanted = matched.reference.value[i];
      const auto found = ours.at(x, wanted, ours.has_rests() ? reach.of(i) : 0.0);
      if (!found) continue;
      comparison.points.push_back(
          {x, found->value, wanted, known_time(found->time, time_at(matched.reference, i))});
    }
    if (comparison.points.size() == before && count > 1) {
      comparison.fault = uncovered(matched, b);
      return comparison;
    }
  }
  comparison.fault = too_few(comparison.points, result, reference, common.interval);
  return comparison;
}

CurveComparison compare_pointwise(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance) {
  const PointwiseComparison comparison = compare_points(result, reference);
  if (!comparison.fault.empty()) return incomparable(comparison.fault);
  PointJudge judge(tolerance);
  for (const CurvePoint& point : comparison.points) judge.add(point, -1);
  const PointJudge::Result found = judge.result();
  const CurvePoint& worst = found.worst.point;
  Measure measure =
      judged("largest deviation", MeasureUnit::kQuantity, worst.value, worst.reference);
  measure.scale = found.scale;
  measure.tolerance = found.tolerance;
  measure.where = worst;
  return compared(comparison.points.size(), {std::move(measure)});
}

}  // namespace slipbench::driver::check
