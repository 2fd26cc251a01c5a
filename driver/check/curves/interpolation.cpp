// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {

void append_between(Series& to, const Series& curve, std::size_t i, double fraction) {
  const auto append = [&](cases::SharedNumbers& column, const cases::SharedNumbers& from) {
    // Row i itself may be the last.
    column.push_back(fraction == 0.0 ? from[i] : from[i] + fraction * (from[i + 1] - from[i]));
  };
  append(to.abscissa, curve.abscissa);
  append(to.value, curve.value);
  if (!curve.time.empty()) append(to.time, curve.time);
}

namespace {

Interval between(const Interpolated& a, const Interpolated& b) {
  return {std::min(a.value, b.value), std::max(a.value, b.value)};
}

/// Adds a range to a list, to the last of them if the two meet.
void join(std::vector<Interval>& ranges, const Interval& next) {
  if (!ranges.empty() &&
      std::max(next.from, ranges.back().from) <= std::min(next.to, ranges.back().to)) {
    ranges.back() = {std::min(next.from, ranges.back().from), std::max(next.to, ranges.back().to)};
  } else {
    ranges.push_back(next);
  }
}

}  // namespace

/// Keeps the value nearest to a wanted one of all that are offered.
class BranchInterpolation::Nearest {
 public:
  explicit Nearest(double wanted) : wanted_(wanted) {}

  void offer(const Interpolated& point) {
    if (found_ && std::abs(found_->value - wanted_) <= std::abs(point.value - wanted_)) return;
    found_ = point;
  }
  /// All values from `range.from` to `range.to`, at about the time of `point`.
  void offer(const Interval& range, const Interpolated& point) {
    offer({std::clamp(wanted_, range.from, range.to), point.time});
  }
  double wanted() const { return wanted_; }
  bool is_met() const { return found_ && found_->value == wanted_; }
  const std::optional<Interpolated>& found() const { return found_; }

 private:
  double wanted_;
  std::optional<Interpolated> found_;
};

BranchInterpolation::BranchInterpolation(const Series& curve, const Branch& branch, double slack)
    : curve_(&curve), branch_(branch), slack_(slack) {
  way_.reserve(branch.last - branch.first + 1);
  double furthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = branch.first; i <= branch.last; ++i) {
    furthest = std::max(furthest, branch.direction * curve.abscissa[i]);
    way_.push_back(furthest);
  }
  find_places();
}

void BranchInterpolation::find_places() {
  for (std::size_t from = 0, to = 0; from < way_.size(); from = to) {
    while (to < way_.size() && way_[to] - way_[from] <= slack_) ++to;
    if (to - from > 1) places_.push_back({from, to});
  }
  // Time itself does not rest.
  rests_possible_ = !places_.empty() && curve_->abscissa != curve_->time;
  if (!rests_possible_) return;
  for (const Place& place : places_) {
    if (is_rest(place)) rests_.push_back(place);
  }
}

void BranchInterpolation::match_rests(const Series& other, const Branch& branch) {
  if (rests_.empty()) return;
  std::vector<double> ways;
  ways.reserve(branch.last - branch.first + 1);
  for (std::size_t i = branch.first; i <= branch.last; ++i) {
    ways.push_back(branch_.direction * other.abscissa[i]);
  }
  // Turns by no more than noise put a row or two out of order.
  std::sort(ways.begin(), ways.end());
  std::erase_if(rests_, [&](const Place& rest) {
    const auto first = std::lower_bound(ways.begin(), ways.end(), way_[rest.from] - slack_);
    const auto end = std::upper_bound(first, ways.end(), way_[rest.to - 1] + slack_);
    return end - first > 1;
  });
}

bool BranchInterpolation::is_rest(const Place& place) const {
  return time_passes(place.from, place.to - 1);
}

bool BranchInterpolation::time_passes(std::size_t from, std::size_t to) const {
  const double time = row(to).time;
  return time - row(from).time > history::kSameTime * std::abs(time);
}

Interpolated BranchInterpolation::row(std::size_t i) const {
  const std::size_t at = branch_.first + i;
  return {curve_->value[at],
          curve_->time.empty() ? std::numeric_limits<double>::quiet_NaN() : curve_->time[at]};
}

const BranchInterpolation::PlaceValues& BranchInterpolation::gathered(const Place& place) {
  for (const PlaceValues& known : kept_) {
    if (known.from == place.from && known.to == place.to) return known;
  }
  PlaceValues& here = kept_[next_kept_];
  next_kept_ = (next_kept_ + 1) % kept_.size();
  here.from = place.from;
  here.to = place.to;
  here.values.clear();
  here.traversed.clear();
  std::vector<Interval> ranges;
  for (std::size_t i = place.from; i < place.to; ++i) {
    here.values.emplace_back(row(i).value, i);
    if (i > place.from && time_passes(i - 1, i)) join(ranges, between(row(i - 1), row(i)));
  }
  std::sort(ranges.begin(), ranges.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  for (const Interval& range : ranges) join(here.traversed, range);
  std::sort(here.values.begin(), here.values.end());
  return here;
}

void BranchInterpolation::offer_place(const Place& place, Nearest& nearest) {
  const PlaceValues& here = gathered(place);
  const double wanted = nearest.wanted();
  const auto above =
      std::lower_bound(here.values.begin(), here.values.end(), std::pair{wanted, std::size_t{0}});
  if (above != here.values.begin()) nearest.offer(row(std::prev(above)->second));
  if (above != here.values.end()) nearest.offer(row(above->second));
  if (nearest.is_met()) return;
  // Their ends are values of rows: only the one that holds the wanted value can be nearer.
  const auto beyond =
      std::upper_bound(here.traversed.begin(), here.traversed.end(), wanted,
                       [](double value, const Interval& range) { return value < range.from; });
  if (beyond != here.traversed.begin()) nearest.offer(*std::prev(beyond), *nearest.found());
}

/// A rest with the increments that lead to it and away from it: one of them may be at rest in part.
void BranchInterpolation::offer_rest(const Place& rest, Nearest& nearest) {
  offer_place(rest, nearest);
  if (nearest.is_met()) return;
  const Interpolated here = *nearest.found();
  if (rest.from > 0) nearest.offer(between(row(rest.from - 1), row(rest.from)), here);
  if (rest.to < way_.size()) nearest.offer(between(row(rest.to - 1), row(rest.to)), here);
}

/// All that lies in rows [from, to) and in the places these belong to. Returns whether the curve
/// rests there.
bool BranchInterpolation::offer_window(std::size_t from, std::size_t to, double reach,
                                       Nearest& nearest) {
  bool rests = false;
  auto place = std::upper_bound(places_.begin(), places_.end(), from,
                                [](std::size_t i, const Place& p) { return i < p.to; });
  for (std::size_t i = from; i < to;) {
    if (i > from && time_passes(i - 1, i)) {
      nearest.offer(between(row(i - 1), row(i)), row(i));
    }
    if (place != places_.end() && place->from <= i) {
      const bool rest = rests_possible_ && is_rest(*place);
      if (rest && reach > 0.0) {
        offer_rest(*place, nearest);
      } else {
        offer_place(*place, nearest);
      }
      rests = rests || rest;
      i = place->to;
      ++place;
    } else {
      nearest.offer(row(i++));
    }
  }
  return rests;
}

/// The values of rows from..to, both included.
Interval BranchInterpolation::passed(std::size_t from, std::size_t to) {
  for (const Passage& known : kept_passages_) {
    if (known.from == from && known.to == to + 1) return known.values;
  }
  Interval values{row(from).value, row(from).value};
  for (std::size_t i = from + 1; i <= to; ++i) {
    values.from = std::min(values.from, row(i).value);
    values.to = std::max(values.to, row(i).value);
  }
  kept_passages_[next_passage_] = {from, to + 1, values};
  next_passage_ = (next_passage_ + 1) % kept_passages_.size();
  return values;
}

/// The rests before and after a place between rests, whose rows are [from, to).
void BranchInterpolation::offer_rests(double way, std::size_t from, std::size_t to, double reach,
                                      Nearest& nearest) {
  const Interpolated here = *nearest.found();
  const auto next =
      std::lower_bound(rests_.begin(), rests_.end(), to,
                       [](const Place& rest, std::size_t i) { return rest.from < i; });
  const auto approach = [&](const Place& rest) {
    return rest.from > 0 ? way_[rest.from] - way_[rest.from - 1] : 0.0;
  };
  const auto departure = [&](const Place& rest) {
    return rest.to < way_.size() ? way_[rest.to] - way_[rest.to - 1] : 0.0;
  };
  const auto offer = [&](const Place& rest, double distance, double step, std::size_t first,
                         std::size_t last) {
    if (reach > 0.0) step = std::max({reach, approach(rest), departure(rest)});
    if (distance > step + slack_) return;
    const Interval way_there = passed(first, last);
    nearest.offer({std::min(way_there.from, here.value), std::max(way_there.to, here.value)}, here);
    if (!nearest.is_met()) offer_rest(rest, nearest);
  };
  if (next != rests_.end()) {
    offer(*next, way_[next->from] - way, approach(*next), to, next->from);
  }
  if (next != rests_.begin() && !nearest.is_met()) {
    const Place& before = *std::prev(next);
    offer(before, way - way_[before.to - 1], departure(before), before.to - 1,
          std::max(before.to, from) - 1);
  }
}

std::optional<Interpolated> BranchInterpolation::at(double abscissa, double wanted, double reach) {
  const double way = branch_.direction * abscissa;
  const auto begin = std::lower_bound(way_.begin(), way_.end(), way - slack_);
  const auto end = std::upper_bound(begin, way_.end(), way + slack_);
  const auto from = static_cast<std::size_t>(begin - way_.begin());
  const auto to = static_cast<std::size_t>(end - way_.begin());
  Nearest nearest(wanted);
  bool rests = false;
  if (from == to) {
    if (from == 0 || from == way_.size()) return std::nullopt;
    const Interpolated left = row(from - 1);
    const Interpolated right = row(from);
    const double fraction = (way - way_[from - 1]) / (way_[from] - way_[from - 1]);
    nearest.offer({left.value + fraction * (right.value - left.value),
                   left.time + fraction * (right.time - left.time)});
  } else {
    rests = offer_window(from, to, reach, nearest);
  }
  if (!rests && !nearest.is_met() && has_rests()) offer_rests(way, from, to, reach, nearest);
  return nearest.found();
}

}  // namespace slipbench::driver::check
