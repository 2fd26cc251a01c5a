// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "driver/compare/common_range.hpp"
#include "driver/compare/interpolation.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver {
namespace {

int direction_at_start(std::span<const double> abscissa, double smallest_turn) {
  for (const double x : abscissa) {
    if (std::abs(x - abscissa.front()) > smallest_turn) return x > abscissa.front() ? 1 : -1;
  }
  return 1;
}

std::string counted(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "branch" : "branches");
}

/// Whether the abscissa of a curve is its time.
bool is_over_time(const Series& curve) {
  return !curve.time.empty() && curve.abscissa == curve.time;
}

std::string different_branches(const Series& result, std::size_t ours, const Series& reference,
                               const std::vector<Branch>& theirs) {
  if (is_over_time(result)) {
    const std::size_t turn = theirs.front().direction > 0 ? theirs.front().last : 0;
    return fmt::format("the times of the reference decrease after row {}, from {:.9g}", turn + 1,
                       reference.abscissa[turn]);
  }
  return fmt::format(
      "the abscissa goes back and forth: the result has {}, the reference {}; select what is "
      "compared with step or over, or compare whole loops with arc_length",
      counted(ours), counted(theirs.size()));
}

/// Which ends of a trimmed curve lie between its rows.
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

std::vector<Branch> branches(std::span<const double> abscissa) {
  if (abscissa.empty()) return {};
  const double range = extent(abscissa).width();
  const double smallest_turn = kSmallestTurn * range;
  const double same_place = kSameTime * range;
  std::vector<Branch> found;
  Branch branch{0, 0, direction_at_start(abscissa, smallest_turn)};
  std::size_t furthest = 0;
  for (std::size_t i = 1; i < abscissa.size(); ++i) {
    const double advance = branch.direction * (abscissa[i] - abscissa[furthest]);
    if (advance > 0.0) furthest = i;
    if (advance >= -smallest_turn) continue;
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
  std::vector<Branch> ours = branches(result.abscissa);
  std::vector<Branch> theirs = branches(reference.abscissa);
  // A single point has no direction of its own.
  const bool is_point = extent(reference.abscissa).width() <= common.slack;
  if (is_point) theirs.front().direction = ours.front().direction;
  if (ours.size() != theirs.size() ||
      (is_over_time(result) && theirs.front().direction != ours.front().direction)) {
    matched.fault = different_branches(result, ours.size(), reference, theirs);
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

}  // namespace slipbench::driver
