// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/observation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver::calibrate {
namespace {

constexpr double kPositionNoise = 1e-3;  // of the range: what turns by less does not turn
constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr double kShortestBranch = 2e-2;  // at the ends, of the range

/// Rows [first, last] of the run that the time of the measurement covers.
struct Window {
  std::size_t first = 0;
  std::size_t last = 0;
};

Window window_of(std::span<const double> time, std::span<const double> measured) {
  const double slack = history::kSameTime * std::max(std::abs(time.front()), std::abs(time.back()));
  const auto first = std::upper_bound(time.begin(), time.end(), measured.front() + slack);
  const auto last = std::lower_bound(time.begin(), time.end(), measured.back() - slack);
  Window window;
  window.first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - time.begin() - 1, 0));
  window.last =
      last == time.end() ? time.size() - 1 : static_cast<std::size_t>(last - time.begin());
  return window;
}

/// Divides a curve at the very rows where it turns: what lies behind them is on its way back,
/// however near it still is. Rows before the start of the first branch, or behind the end of the
/// last one, are on none. Rows that stay at a turn, but for `slack`, belong to the branch before
/// it.
std::vector<check::Branch> split_at_extremes(std::span<const double> position, double noise,
                                             double slack) {
  std::vector<check::Branch> parts = check::branches(position, noise);
  for (std::size_t b = 0; b < parts.size(); ++b) {
    check::Branch& part = parts[b];
    const auto way = [&](std::size_t row) { return part.direction * position[row]; };
    std::size_t last = part.first;
    for (std::size_t row = part.first; row <= part.last; ++row) {
      if (way(row) > way(last)) last = row;
    }
    if (b == 0) {
      for (std::size_t row = part.first; row <= last; ++row) {
        if (way(row) < way(part.first) - slack) part.first = row;
      }
    }
    const std::size_t furthest = last;
    while (last < part.last && way(last + 1) >= way(furthest) - slack) ++last;
    part.last = last;
    if (b + 1 < parts.size()) parts[b + 1].first = last;
  }
  return parts;
}

/// Returns how far a curve goes back inside its branches: its noise, 0 if it has none.
double largest_relapse(std::span<const double> position, std::span<const check::Branch> parts) {
  double largest = 0.0;
  for (const check::Branch& part : parts) {
    double furthest = part.direction * position[part.first];
    for (std::size_t row = part.first; row <= part.last; ++row) {
      const double way = part.direction * position[row];
      furthest = std::max(furthest, way);
      largest = std::max(largest, furthest - way);
    }
  }
  return largest;
}

/// Takes short branches off the ends of the curve that has more of them.
void drop_short_ends(std::vector<check::Branch>& parts, std::span<const double> position,
                     std::size_t wanted) {
  const double range = check::extent(position).width();
  const auto is_short = [&](const check::Branch& branch) {
    return std::abs(position[branch.last] - position[branch.first]) <= kShortestBranch * range;
  };
  if (parts.size() > wanted && is_short(parts.back())) parts.pop_back();
  if (parts.size() > wanted && is_short(parts.front())) parts.erase(parts.begin());
}

/// Search for the place where a branch of the run first reaches a position.
class BranchSearch {
 public:
  BranchSearch(std::span<const double> position, const check::Branch& branch, double slack)
      : position_(position), branch_(branch), slack_(slack), row_(branch.first) {}

  /// Positions come about in the direction of the branch.
  /// \return whether it gets there
  bool find(double position, Replay::Point& point) {
    const double wanted = branch_.direction * position;
    if (wanted < way(branch_.first)) {
      point = {branch_.first, 0.0};
      return wanted >= way(branch_.first) - slack_;
    }
    // Noise may have put a measured point before the one that was asked for last.
    while (row_ > branch_.first && way(row_ - 1) >= wanted) --row_;
    while (row_ < branch_.last && way(row_) < wanted) ++row_;
    if (way(row_) < wanted) {
      point = {branch_.last, 0.0};
      return way(row_) >= wanted - slack_;
    }
    if (row_ == branch_.first || way(row_) == wanted) {
      point = {row_, 0.0};
      return true;
    }
    point = {row_ - 1, (wanted - way(row_ - 1)) / (way(row_) - way(row_ - 1))};
    return true;
  }

 private:
  double way(std::size_t row) const { return branch_.direction * position_[row]; }

  std::span<const double> position_;
  check::Branch branch_;
  double slack_;
  std::size_t row_;
};

}  // namespace

Observations observe_times(std::span<const double> run, std::span<const double> measured) {
  Observations found;
  found.kept.reserve(measured.size());
  found.points.reserve(measured.size());
  const double slack = history::kSameTime * std::max(std::abs(run.front()), std::abs(run.back()));
  std::size_t row = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double time = measured[i];
    if (time < run.front() - slack || time > run.back() + slack) continue;
    while (row + 1 < run.size() && run[row + 1] <= time + slack) ++row;
    Replay::Point point{row, 0.0};
    if (time > run[row] + slack && row + 1 < run.size()) {
      point.fraction = (time - run[row]) / (run[row + 1] - run[row]);
    }
    found.kept.push_back(i);
    found.points.push_back(point);
  }
  if (found.points.empty() && !measured.empty()) {
    found.fault = fmt::format(
        "the run goes from time {:.6g} to {:.6g}, the measured times from {:.6g} to "
        "{:.6g}: they have nothing in common; see offset and factor of `time`",
        run.front(), run.back(), measured.front(), measured.back());
  }
  return found;
}

Observations observe_positions(std::span<const double> time, std::span<const double> position,
                               const MeasuredSeries& measured) {
  Observations found = observe_times(time, measured.time);
  if (!found.fault.empty() || measured.time.empty()) return found;
  const Observations by_time = std::move(found);
  found = {};
  const Window window = window_of(time, measured.time);
  const auto path = position.subspan(window.first, window.last - window.first + 1);
  const double range = check::extent(measured.over).width();
  const double slack = history::kSameTime * range;
  std::vector<check::Branch> theirs =
      split_at_extremes(measured.over, kPositionNoise * range, slack);
  std::vector<check::Branch> ours = split_at_extremes(path, kPositionNoise * range, slack);
  const double noise = std::max(slack, largest_relapse(measured.over, theirs));
  const std::size_t count = theirs.size();
  drop_short_ends(theirs, measured.over, ours.size());
  drop_short_ends(ours, path, theirs.size());
  if (ours.size() != theirs.size()) {
    found.fault = fmt::format(
        "the measured positions go back and forth in {} branches, those of the run in {}: they "
        "cannot be matched; compare over time, or choose a part with from and to",
        count, ours.size());
    return found;
  }
  if (ours.front().direction != theirs.front().direction) {
    found.fault =
        "the measured positions begin in the opposite direction to those of the run; see the "
        "factor of the column, or compare over time";
    return found;
  }
  for (std::size_t b = 0; b < theirs.size(); ++b) {
    BranchSearch search(path, ours[b], slack);
    const std::size_t first = b == 0 ? theirs[b].first : theirs[b].first + 1;
    // A row where the measured positions turn belongs to the branch before it if there is no noise
    // and the run turns at that very position. Else nothing tells on which side of the turn it was
    // measured.
    const double from = b > 0 ? measured.over[theirs[b].first] : kNowhere;
    const bool last = b + 1 == theirs.size();
    const double turn = last ? kNowhere : measured.over[theirs[b].last];
    const bool same = noise == slack && !last && std::abs(turn - path[ours[b].last]) <= slack;
    for (std::size_t i = first; i <= theirs[b].last; ++i) {
      const double here = measured.over[i];
      Replay::Point point;
      if (std::abs(here - from) <= noise || (!same && std::abs(here - turn) <= noise)) {
        // Time tells, where the run is at this very position then.
        const auto then = std::lower_bound(by_time.kept.begin(), by_time.kept.end(), i);
        if (then == by_time.kept.end() || *then != i) continue;
        point = by_time.points[static_cast<std::size_t>(then - by_time.kept.begin())];
        double there = 0.0;
        read_points(position, std::span(&point, 1), std::span(&there, 1));
        if (std::abs(there - here) > slack) continue;
        found.kept.push_back(i);
        found.points.push_back(point);
        continue;
      }
      if (!search.find(here, point)) continue;
      point.row += window.first;
      found.kept.push_back(i);
      found.points.push_back(point);
    }
  }
  if (found.points.empty()) {
    found.fault = "the measured positions and those of the run have nothing in common";
  }
  return found;
}

void read_points(std::span<const double> column, std::span<const Replay::Point> points,
                 std::span<double> values) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [row, fraction] = points[i];
    const double here = column[row];
    values[i] = fraction == 0.0 ? here : here + fraction * (column[row + 1] - here);
  }
}

}  // namespace slipbench::driver::calibrate
