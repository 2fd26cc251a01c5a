// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/cycle_finder.hpp"

#include <cmath>

#include "driver/history/step_grid.hpp"

namespace slipbench::driver::plot {
namespace {

/// Turning points that differ by less, as a part of the motion's range, are one place.
constexpr double kSamePlace = 1e-3;
constexpr double kSmallestTurn = 0.02;

}  // namespace

bool CycleFinder::full(const Turn& first, const Turn& end) const {
  return std::abs(end.position - first.position) <= kSamePlace * range_;
}

void CycleFinder::add(double position) {
  const double smallest_turn = kSmallestTurn * range_;
  const std::int64_t row = count_++;
  position_ = position;
  if (row == 0) start_ = position;
  if (direction_ == 0.0) {
    if (!(std::abs(position - start_) > smallest_turn)) return;
    direction_ = position > start_ ? 1.0 : -1.0;
    furthest_ = position;
    dwells_ = row;
    return;
  }
  const double advance = direction_ * (position - furthest_);
  if (advance > 0.0) {
    furthest_ = position;
    dwells_ = row;
  } else if (dwells_ == row - 1 && -advance <= history::kSameTime * range_) {
    dwells_ = row;
  }
  if (advance >= -smallest_turn) return;
  const Turn turn{dwells_, furthest_};
  if (turns_ >= 2 && full(before_[0], turn)) found_.full = {before_[0].row, turn.row};
  before_ = {before_[1], turn};
  if (++turns_ % 2 == 0) found_.ends.push_back(turn.row);
  direction_ = -direction_;
  furthest_ = position;
  dwells_ = row;
}

MotionCycles CycleFinder::cycles() const {
  MotionCycles found = found_;
  const Turn end{count_ - 1, position_};
  const bool way_back = direction_ * (position_ - before_[1].position) > kSmallestTurn * range_;
  if (turns_ >= 2 && way_back && full(before_[0], end)) found.full = {before_[0].row, end.row};
  if (count_ == 0) return found;
  // What is left without a turn belongs to the last cycle.
  if (turns_ % 2 == 1 || found.ends.empty()) {
    found.ends.push_back(end.row);
  } else {
    found.ends.back() = end.row;
  }
  return found;
}

std::vector<std::int64_t> drawn_cycles(std::int64_t count) {
  constexpr std::int64_t kFew = 5;
  constexpr std::int64_t kMany = 10000;
  std::vector<std::int64_t> numbers;
  if (count <= kFew) {
    for (std::int64_t n = 1; n <= count; ++n) numbers.push_back(n);
    return numbers;
  }
  for (std::int64_t ten = 1; ten < count; ten *= 10) {
    numbers.push_back(ten);
    for (const std::int64_t more : {2 * ten, 5 * ten}) {
      if (count <= kMany && more < count) numbers.push_back(more);
    }
    if (ten > count / 10) break;
  }
  numbers.push_back(count);
  return numbers;
}

}  // namespace slipbench::driver::plot
