// SPDX-License-Identifier: Apache-2.0
#include "driver/report/row_choice.hpp"

#include <algorithm>
#include <utility>

namespace slipbench::driver::report {
namespace {

std::span<const double> row_of(const IndexedRows& rows, std::size_t i, std::size_t columns) {
  return {rows.numbers.data() + i * columns, columns};
}

void append(IndexedRows& rows, std::int64_t index, std::span<const double> row) {
  rows.index.push_back(index);
  rows.numbers.insert(rows.numbers.end(), row.begin(), row.end());
}

/// Finds the row that has this place; it is one of them.
std::size_t find(const IndexedRows& rows, std::int64_t index) {
  return static_cast<std::size_t>(std::lower_bound(rows.index.begin(), rows.index.end(), index) -
                                  rows.index.begin());
}

}  // namespace

CycleFinder::Turn CycleFinder::take(double value) {
  // What compares with nothing is no place.
  if (!(value == value)) return Turn::kNone;
  if (!started_) {
    low_ = high_ = extreme_ = value;
    started_ = true;
    return Turn::kNone;
  }
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
  // A wave that ends where it began has come half of its way, but for rounding.
  constexpr double kRounding = 1e-9;
  const double half = (0.5 - kRounding) * (high_ - low_);
  if (!turned_ && value != extreme_) {
    // The first way is a way, not a turn.
    down_ = value < extreme_;
    turned_ = true;
  }
  if (down_ ? value < extreme_ : value > extreme_) extreme_ = value;
  if (!(half > 0.0) || (down_ ? value - extreme_ : extreme_ - value) < half) return Turn::kNone;
  down_ = !down_;
  extreme_ = value;
  return down_ ? Turn::kDown : Turn::kUp;
}

RowChoice::RowChoice(std::size_t columns, std::size_t limit, std::span<const std::size_t> motions)
    : columns_(columns),
      limit_(limit * kColumnsOfMostRows / std::max(columns, kColumnsOfMostRows)),
      pieces_(columns, std::max<std::size_t>(limit_ / 8, 1) * 2) {
  for (const std::size_t column : motions) motions_.push_back({column, {}, {}, {}, 0});
}

void RowChoice::want(std::span<const double> row) {
  const std::size_t most = std::max<std::size_t>(limit_ / 16, 1);
  if (first_wanted_.size() < most) {
    append(first_wanted_, count_, row);
  } else if (last_wanted_.size() < most) {
    append(last_wanted_, count_, row);
  } else {
    last_wanted_.index[next_] = count_;
    std::copy(row.begin(), row.end(),
              last_wanted_.numbers.begin() + static_cast<std::ptrdiff_t>(next_ * columns_));
    next_ = (next_ + 1) % most;
  }
}

void RowChoice::take(Cycle& cycle, const Motion& motion, std::span<const double> row) const {
  const double value = row[motion.column];
  if (cycle.rows.size() == 0) cycle.low = cycle.high = value;
  cycle.low = std::min(cycle.low, value);
  cycle.high = std::max(cycle.high, value);
  if (cycle.whole) append(cycle.rows, count_, row);
  if (cycle.rows.size() <= std::max<std::size_t>(limit_ / 4, 2)) return;
  cycle.whole = false;
  // The first row still tells where it begins.
  cycle.rows.index.resize(1);
  cycle.rows.numbers.resize(columns_);
}

bool RowChoice::is_small(const Cycle& cycle, const Motion& motion) {
  return cycle.high - cycle.low < 0.5 * motion.finder.range();
}

void RowChoice::follow(Motion& motion, std::span<const double> row) const {
  const CycleFinder::Turn turn = motion.finder.take(row[motion.column]);
  take(motion.current, motion, row);
  if (turn != CycleFinder::Turn::kUp) return;
  // The row at the end of a cycle also begins the next one.
  Cycle next{motion.current.number + 1, {}, 0.0, 0.0, true};
  take(next, motion, row);
  // What comes before the motion proper is no cycle of it.
  if (!motion.kept.empty() && is_small(motion.kept.front(), motion)) {
    motion.kept.clear();
    motion.current.number = 1;
    next.number = 2;
  }
  motion.longest = count_ - motion.current.rows.index.front() + 1;
  // The last one stays until there is another, the others by their numbers.
  const auto picked = [](std::int64_t number) {
    while (number % 10 == 0) number /= 10;
    return number == 1 || number == 2 || number == 5;
  };
  if (!motion.kept.empty() && !picked(motion.kept.back().number)) motion.kept.pop_back();
  motion.kept.push_back(std::exchange(motion.current, std::move(next)));
  if (!motion.kept.back().whole) motion.kept.pop_back();
  std::size_t rows = 0;
  for (const Cycle& cycle : motion.kept) rows += cycle.rows.size();
  while (rows > limit_ && motion.kept.size() > 2) {
    rows -= motion.kept[1].rows.size();
    motion.kept.erase(motion.kept.begin() + 1);
  }
}

void RowChoice::add(std::span<const double> row, bool wanted) {
  if (wanted) want(row);
  for (Motion& motion : motions_) follow(motion, row);
  pieces_.add(row);
  ++count_;
  if (!thinned()) {
    all_.insert(all_.end(), row.begin(), row.end());
  } else if (!all_.empty()) {
    all_ = {};
  }
}

/// The motion whose cycles count: one that goes at least half of its whole way in the last of them.
const RowChoice::Motion* RowChoice::slowest() const {
  const Motion* slowest = nullptr;
  for (const Motion& motion : motions_) {
    if (motion.kept.empty()) continue;
    const Cycle& last = motion.kept.back();
    if (is_small(last, motion)) continue;
    if (slowest == nullptr || motion.longest > slowest->longest) slowest = &motion;
  }
  return slowest;
}

DrawnRows RowChoice::finish(const IndexedRows& more) const {
  DrawnRows drawn;
  drawn.thinned = thinned();
  if (!drawn.thinned) {
    for (std::int64_t i = 0; i < count_; ++i) drawn.rows.index.push_back(i);
    drawn.rows.numbers = all_;
    return drawn;
  }
  drawn.piece = pieces_.length();
  drawn.low = pieces_.low();
  drawn.high = pieces_.high();
  std::vector<std::pair<std::int64_t, std::span<const double>>> all;
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const std::int64_t begin = static_cast<std::int64_t>(piece) * drawn.piece;
    all.emplace_back(begin, pieces_.first(piece));
    all.emplace_back(std::min(begin + drawn.piece, count_) - 1, pieces_.last(piece));
  }
  const auto take_rows = [&](const IndexedRows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      all.emplace_back(rows.index[i], row_of(rows, i, columns_));
    }
  };
  take_rows(first_wanted_);
  take_rows(last_wanted_);
  take_rows(more);
  std::vector<const Cycle*> cycles;
  if (const Motion* motion = slowest()) {
    for (const Cycle& cycle : motion->kept) cycles.push_back(&cycle);
    if (motion->current.whole && motion->current.rows.size() > 1) {
      cycles.push_back(&motion->current);
    }
    drawn.cycles_total = motion->current.number - 1;
    drawn.motion = motion->column;
  }
  for (const Cycle* cycle : cycles) take_rows(cycle->rows);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [index, row] : all) {
    if (drawn.rows.index.empty() || drawn.rows.index.back() < index) {
      append(drawn.rows, index, row);
    }
  }
  for (const Cycle* cycle : cycles) {
    const std::int64_t number = cycle->number > drawn.cycles_total ? 0 : cycle->number;
    drawn.cycles.push_back({number, find(drawn.rows, cycle->rows.index.front()),
                            find(drawn.rows, cycle->rows.index.back())});
  }
  return drawn;
}

RowsAtTimes::RowsAtTimes(std::vector<double> times) : times_(std::move(times)) {
  std::sort(times_.begin(), times_.end());
}

void RowsAtTimes::keep(std::int64_t index, std::span<const double> row) {
  if (rows_.index.empty() || rows_.index.back() < index) append(rows_, index, row);
}

void RowsAtTimes::add(std::span<const double> row) {
  if (done()) return;
  bool reached = false;
  while (next_ < times_.size() && row[0] >= times_[next_]) {
    ++next_;
    reached = true;
  }
  if (reached) {
    for (std::size_t back = before_.size(); back > 0; --back) {
      keep(count_ - static_cast<std::int64_t>(back), before_[before_.size() - back]);
    }
    behind_ = 2;
  }
  if (behind_ > 0) {
    keep(count_, row);
    --behind_;
  }
  if (before_.size() == 2) before_.pop_front();
  before_.emplace_back(row.begin(), row.end());
  ++count_;
}

}  // namespace slipbench::driver::report
