// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/interpolation.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {
namespace {

int direction_at_start(std::span<const double> abscissa, double turn) {
  for (const double x : abscissa) {
    if (std::abs(x - abscissa.front()) > turn) return x > abscissa.front() ? 1 : -1;
  }
  return 1;
}

std::string counted(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "branch" : "branches");
}

/// A turn by less is rounding.
double smallest_turn(double range, double noise) {
  return std::max(kSmallestTurn * range, std::min(noise, kLargestNoise * range));
}

/// The shortest branch that begins and ends with a turn, if such a curve has one that may be noise.
std::string about_noise(const Series& curve, const std::vector<Branch>& parts, double taken) {
  constexpr double kMayBeNoise = 1e-2;  // of the range
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t b = 1; b + 1 < parts.size(); ++b) {
    shortest = std::min(shortest,
                        std::abs(curve.abscissa[parts[b].last] - curve.abscissa[parts[b].first]));
  }
  if (!(shortest < kMayBeNoise * extent(curve.abscissa).width())) return {};
  return fmt::format("; turns by {:.3g} may be noise, only those up to {:.1g} were taken for it",
                     shortest, taken);
}

/// Tells whether the abscissa of a curve is its time.
bool is_over_time(const Series& curve) {
  return !curve.time.empty() && curve.abscissa == curve.time;
}

std::string different_branches(const Series& result, const std::vector<Branch>& ours,
                               const Series& reference, const std::vector<Branch>& theirs) {
  if (is_over_time(result)) {
    const std::size_t turn = theirs.front().direction > 0 ? theirs.front().last : 0;
    return fmt::format("the times of the reference decrease after row {}, from {:.9g}", turn + 1,
                       reference.abscissa[turn]);
  }
  const bool ours_are_more = ours.size() > theirs.size();
  const Series& more = ours_are_more ? result : reference;
  const std::vector<Branch>& more_parts = ours_are_more ? ours : theirs;
  const double taken =
      smallest_turn(extent(more.abscissa).width(), common_noise(result, reference));
  return fmt::format(
      "the abscissa goes back and forth: the result has {}, the reference {}; select what is "
      "compared with step or over, or compare whole loops with arc_length{}",
      counted(ours.size()), counted(theirs.size()), about_noise(more, more_parts, taken));
}

/// Ends of a trimmed curve that lie between its rows.
struct Ends {
  bool enters = false;
  bool leaves = false;
};

/// A curve from `start` in its first branch to `end` in its last one.
Ends trim(Series& curve, std::vector<Branch>& parts, double start, double end, double slack) {
  const std::vector<double>& x = curve.abscissa;
  const Branch& head = parts.front();
  const Branch& tail = parts.back();
  std::size_t from = head.first;
  while (from < head.last && head.direction * (x[from] - start) < -slack) ++from;
  const bool enters = from > head.first && head.direction * (x[from] - start) > slack;
  std::size_t to = tail.last;
  while (to > tail.first && tail.direction * (x[to] - end) > slack) --to;
  const bool leaves = to < tail.last && tail.direction * (x[to] - end) < -slack;
  if (from == head.first && to == tail.last) return {};
  const std::size_t shift = enters ? from - 1 : from;
  Series kept;
  kept.noise = curve.noise;
  if (enters)
    append_between(kept, curve, from - 1, (start - x[from - 1]) / (x[from] - x[from - 1]));
  // Both ends may lie between the same two rows; then there is no row to keep.
  for (std::size_t i = from; i < to + 1; ++i) append_between(kept, curve, i, 0.0);
  if (leaves) append_between(kept, curve, to, (end - x[to]) / (x[to + 1] - x[to]));
  curve = std::move(kept);
  for (Branch& part : parts) {
    part.first = std::max(part.first, shift) - shift;
    part.last -= shift;
  }
  parts.back().last = curve.size() - 1;
  return {enters, leaves};
}

}  // namespace

double common_noise(const Series& result, const Series& reference) {
  return std::max(result.noise, reference.noise);
}

std::vector<Branch> branches(std::span<const double> abscissa, double noise) {
  if (abscissa.empty()) return {};
  const double range = extent(abscissa).width();
  const double turn = smallest_turn(range, noise);
  const double same_place =
      std::max(history::kSameTime * range, std::min(noise, kLargestNoise * range));
  std::vector<Branch> found;
  Branch branch{0, 0, direction_at_start(abscissa, turn)};
  std::size_t furthest = 0;
  for (std::size_t i = 1; i < abscissa.size(); ++i) {
    const double advance = branch.direction * (abscissa[i] - abscissa[furthest]);
    if (advance > 0.0) furthest = i;
    if (advance >= -turn) continue;
    branch.last = furthest;
    while (std::abs(abscissa[branch.last + 1] - abscissa[furthest]) <= same_place) ++branch.last;
    found.push_back(branch);
    branch = {branch.last, branch.last, -branch.direction};
    furthest = i;
  }
  branch.last = abscissa.size() - 1;
  found.push_back(branch);
  return found;
}

MatchedBranches match_branches(const Series& result, const Series& reference) {
  MatchedBranches matched;
  const CommonRange common = common_range(result, reference);
  matched.fault = common.fault;
  if (!matched.fault.empty()) return matched;
  const double noise = common_noise(result, reference);
  std::vector<Branch> ours = branches(result.abscissa, noise);
  std::vector<Branch> theirs = branches(reference.abscissa, noise);
  if (ours.size() != theirs.size() ||
      (is_over_time(result) && theirs.front().direction != ours.front().direction)) {
    matched.fault = different_branches(result, ours, reference, theirs);
    return matched;
  }
  if (ours.front().direction != theirs.front().direction) {
    matched.fault =
        fmt::format("the abscissas begin in opposite directions: the result {}, the reference {}",
                    ours.front().direction > 0 ? "increases" : "decreases",
                    theirs.front().direction > 0 ? "increases" : "decreases");
    return matched;
  }
  matched.result = result;
  matched.reference = reference;
  const int head = ours.front().direction;
  const int tail = ours.back().direction;
  const double start =
      head * std::max(head * result.abscissa.front(), head * reference.abscissa.front());
  const double end =
      tail * std::min(tail * result.abscissa.back(), tail * reference.abscissa.back());
  for (const auto& [curve, parts] : {std::pair{&result, &ours}, std::pair{&reference, &theirs}}) {
    const double first_turn = curve->abscissa[parts->front().last];
    const double last_turn = curve->abscissa[parts->back().first];
    if (head * (start - first_turn) > common.slack) {
      matched.fault = "the first branches have no part in common";
    } else if (tail * (last_turn - end) > common.slack) {
      matched.fault = "the last branches have no part in common";
    }
  }
  if (!matched.fault.empty()) return matched;
  trim(matched.result, ours, start, end, common.slack);
  const Ends ends = trim(matched.reference, theirs, start, end, common.slack);
  matched.first_is_interpolated = ends.enters;
  matched.last_is_interpolated = ends.leaves;
  matched.result_branches = std::move(ours);
  matched.reference_branches = std::move(theirs);
  return matched;
}

}  // namespace slipbench::driver::check
