// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver {

void append_between(Series& to, const Series& curve, std::size_t i, double fraction) {
  const auto append = [&](std::vector<double>& column, const std::vector<double>& from) {
    // Row i itself may be the last.
    column.push_back(fraction == 0.0 ? from[i] : from[i] + fraction * (from[i + 1] - from[i]));
  };
  append(to.abscissa, curve.abscissa);
  append(to.value, curve.value);
  if (!curve.time.empty()) append(to.time, curve.time);
}

BranchInterpolation::BranchInterpolation(const Series& curve, const Branch& branch, double slack)
    : curve_(&curve), branch_(branch), slack_(slack) {
  way_.reserve(branch.last - branch.first + 1);
  double furthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = branch.first; i <= branch.last; ++i) {
    furthest = std::max(furthest, branch.direction * curve.abscissa[i]);
    way_.push_back(furthest);
  }
}

Interpolated BranchInterpolation::row(std::size_t i) const {
  const std::size_t at = branch_.first + i;
  return {curve_->value[at],
          curve_->time.empty() ? std::numeric_limits<double>::quiet_NaN() : curve_->time[at]};
}

void BranchInterpolation::gather_place(std::size_t from, std::size_t to) {
  if (from == place_from_ && to == place_to_) return;
  place_from_ = from;
  place_to_ = to;
  values_.clear();
  traversed_.clear();
  for (std::size_t i = from; i < to; ++i) {
    const Interpolated here = row(i);
    values_.emplace_back(here.value, i);
    if (i == from) continue;
    const Interpolated before = row(i - 1);
    const double passed = here.time - before.time;
    if (!(passed > kSameTime * std::abs(here.time))) continue;
    const auto [low, high] = std::minmax(here.value, before.value);
    if (!traversed_.empty() &&
        std::max(low, traversed_.back().from) <= std::min(high, traversed_.back().to)) {
      traversed_.back() = {std::min(low, traversed_.back().from),
                           std::max(high, traversed_.back().to)};
    } else {
      traversed_.push_back({low, high});
    }
  }
  std::sort(values_.begin(), values_.end());
}

std::optional<Interpolated> BranchInterpolation::at(double abscissa, double wanted) {
  const double way = branch_.direction * abscissa;
  const auto begin = std::lower_bound(way_.begin(), way_.end(), way - slack_);
  const auto end = std::upper_bound(begin, way_.end(), way + slack_);
  const auto from = static_cast<std::size_t>(begin - way_.begin());
  const auto to = static_cast<std::size_t>(end - way_.begin());
  if (from == to) {
    if (from == 0 || from == way_.size()) return std::nullopt;
    const Interpolated left = row(from - 1);
    const Interpolated right = row(from);
    const double fraction = (way - way_[from - 1]) / (way_[from] - way_[from - 1]);
    return Interpolated{left.value + fraction * (right.value - left.value),
                        left.time + fraction * (right.time - left.time)};
  }
  if (to - from == 1) return row(from);
  gather_place(from, to);
  auto nearest =
      std::lower_bound(values_.begin(), values_.end(), std::pair{wanted, std::size_t{0}});
  if (nearest == values_.end() || (nearest != values_.begin() &&
                                   wanted - std::prev(nearest)->first < nearest->first - wanted)) {
    --nearest;
  }
  Interpolated found = row(nearest->second);
  const bool is_traversed =
      std::any_of(traversed_.begin(), traversed_.end(),
                  [&](const Interval& r) { return r.from <= wanted && wanted <= r.to; });
  if (is_traversed) found.value = wanted;
  return found;
}

}  // namespace slipbench::driver
