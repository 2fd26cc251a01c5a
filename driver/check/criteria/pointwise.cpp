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

using TakePoint = std::function<void(const CurvePoint&)>;

void row_by_row(const Series& result, const Series& reference, const TakePoint& take) {
  const std::vector<double>& abscissa = reference.abscissa;
  const std::vector<double>& ours = result.value;
  const std::vector<double>& theirs = reference.value;
  const std::vector<double>& times = result.time.empty() ? reference.time : result.time;
  for (std::size_t i = 0; i < abscissa.size(); ++i) {
    take({abscissa[i], ours[i], theirs[i], times.empty() ? kUnknown : times[i]});
  }
}

/// Tells whether no two rows of a curve, one after the other, are in one place.
bool always_moves(const Series& curve, double slack) {
  const std::vector<double>& x = curve.abscissa;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (std::abs(x[i] - x[i - 1]) <= slack) return false;
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

  const cases::SharedNumbers* x_;
  Branch branch_;
  double slack_;
  std::size_t end_;
  double reach_ = 0.0;
};

/// "the reference's rows there go from 0.05 to 0.1, the result from 0 to 0.099".
std::string uncovered(const MatchedBranches& matched, std::size_t b) {
  const auto range = [](const Series& curve, const Branch& branch) {
    return extent(std::span<const double>(curve.abscissa)
                      .subspan(branch.first, branch.last - branch.first + 1));
  };
  const Interval theirs = range(matched.reference, matched.reference_branches[b]);
  const Interval ours = range(matched.result, matched.result_branches[b]);
  return fmt::format(
      "branch {} of {} of the reference has no row that the result covers: it has rows between "
      "{:.9g} and {:.9g}, the result goes from {:.9g} to {:.9g} there",
      b + 1, matched.reference_branches.size(), theirs.from, theirs.to, ours.from, ours.to);
}

/// Returns why too few rows of a reference were met; empty if there are enough.
std::string too_few(std::size_t points, double first, const Series& result, const Series& reference,
                    const Interval& common) {
  const std::string range =
      fmt::format("the common range, {:.9g} to {:.9g}", common.from, common.to);
  if (points == 0) return "no row of the reference lies in " + range;
  if (points > 1 || reference.size() < 2 || result.size() < 2) return {};
  return fmt::format("only 1 of the reference's {} rows, at {:.9g}, lies in {}", reference.size(),
                     first, range);
}

}  // namespace

std::string each_point(const Series& result, const Series& reference, const TakePoint& take) {
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return common.fault;
  if (are_same_rows(result, reference) ||
      (result.abscissa == reference.abscissa && always_moves(result, common.slack))) {
    row_by_row(result, reference, take);
    return {};
  }
  const MatchedBranches matched = match_branches(result, reference);
  if (!matched.fault.empty()) return matched.fault;
  const std::size_t count = matched.reference_branches.size();
  std::size_t points = 0;
  double first = 0.0;
  for (std::size_t b = 0; b < count; ++b) {
    BranchInterpolation ours(matched.result, matched.result_branches[b], common.slack);
    const Branch& theirs = matched.reference_branches[b];
    ours.match_rests(matched.reference, theirs);
    Reach reach(matched.reference, theirs, common.slack);
    const std::size_t before = points;
    const bool skips_first = b > 0 || matched.first_is_interpolated;
    const bool skips_last = b + 1 == count && matched.last_is_interpolated;
    const std::size_t end = theirs.last + (skips_last ? 0 : 1);
    for (std::size_t i = theirs.first + (skips_first ? 1 : 0); i < end; ++i) {
      const double x = matched.reference.abscissa[i];
      const double wanted = matched.reference.value[i];
      const auto found = ours.at(x, wanted, ours.has_rests() ? reach.of(i) : 0.0);
      if (!found) continue;
      if (points++ == 0) first = x;
      take({x, found->value, wanted, known_time(found->time, time_at(matched.reference, i))});
    }
    if (points == before && count > 1) return uncovered(matched, b);
  }
  return too_few(points, first, result, reference, common.interval);
}

PointwiseComparison compare_points(const Series& result, const Series& reference) {
  PointwiseComparison comparison;
  comparison.points.reserve(reference.size());
  comparison.fault = each_point(
      result, reference, [&](const CurvePoint& point) { comparison.points.push_back(point); });
  return comparison;
}

CurveComparison compare_pointwise(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance) {
  PointJudge judge(tolerance);
  const std::string fault =
      each_point(result, reference, [&](const CurvePoint& point) { judge.add(point, -1); });
  if (!fault.empty()) return incomparable(fault);
  const PointJudge::Result found = judge.result();
  const CurvePoint& worst = found.worst.point;
  Measure measure =
      judged("largest deviation", MeasureUnit::kQuantity, worst.value, worst.reference);
  measure.scale = found.scale;
  measure.tolerance = found.tolerance;
  measure.where = worst;
  return compared(static_cast<std::size_t>(judge.count()), {std::move(measure)});
}

}  // namespace slipbench::driver::check
