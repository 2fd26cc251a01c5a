// SPDX-License-Identifier: Apache-2.0
#include "driver/report/row_choice.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace slipbench::driver {
namespace {

std::span<const double> row_of(const IndexedRows& rows, std::size_t i, std::size_t columns) {
  return {rows.numbers.data() + i * columns, columns};
}

void append(IndexedRows& rows, std::int64_t index, std::span<const double> row) {
  rows.index.push_back(index);
  rows.numbers.insert(rows.numbers.end(), row.begin(), row.end());
}

/// Which of the rows has this place; it is one of them.
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
  const double half = 0.5 * (high_ - low_);
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

RowChoice::RowChoice(std::size_t columns, std::size_t limit, std::span<const std::size_t> watched,
                     std::span<const std::size_t> motions)
    : columns_(columns),
      limit_(limit),
      watched_(watched.begin(), watched.end()),
      base_(columns, limit, watched) {
  for (const std::size_t column : motions) {
    motions_.push_back(
        {column, {}, RowThinner(columns, limit / 8, watched), false, std::nullopt, std::nullopt});
  }
}

void RowChoice::want(std::span<const double> row) {
  const std::size_t most = limit_ / 8;
  if (first_wanted_.size() < most) {
    append(first_wanted_, count(), row);
  } else if (last_wanted_.size() < most) {
    append(last_wanted_, count(), row);
  } else {
    last_wanted_.index[next_] = count();
    std::copy(row.begin(), row.end(),
              last_wanted_.numbers.begin() + static_cast<std::ptrdiff_t>(next_ * columns_));
    next_ = (next_ + 1) % most;
  }
}

void RowChoice::follow(Motion& motion, std::span<const double> row, bool wanted) {
  const CycleFinder::Turn turn = motion.finder.take(row[motion.column]);
  if (!motion.began) motion.beginning.add(row, wanted);
  if (turn == CycleFinder::Turn::kNone) {
    if (motion.current) motion.current->rows.add(row, wanted);
    return;
  }
  motion.began = true;
  if (motion.current) motion.current->rows.add(row, wanted);
  if (turn == CycleFinder::Turn::kDown) return;
  // The row at the end of a cycle also begins the next one.
  if (motion.current) motion.last = std::move(motion.current);
  motion.current = Cycle{count(), cycle_thinner()};
  motion.current->rows.add(row, wanted);
}

void RowChoice::add(std::span<const double> row, bool wanted) {
  if (wanted) want(row);
  for (Motion& motion : motions_) follow(motion, row, wanted);
  base_.add(row);
}

bool RowChoice::has_cycle(const Motion& motion) const {
  if (!motion.last) return false;
  // Extremes survive any thinning.
  const IndexedRows rows = motion.last->rows.indexed_rows(limit_ / 2);
  CycleFinder way;
  for (std::size_t i = motion.column; i < rows.numbers.size(); i += columns_) {
    way.take(rows.numbers[i]);
  }
  return way.range() >= 0.5 * motion.finder.range();
}

DrawnRows RowChoice::finish(const IndexedRows& more) const {
  DrawnRows drawn;
  drawn.thinned = thinned();
  if (!drawn.thinned) {
    drawn.rows = base_.indexed_rows(limit_);
    return drawn;
  }
  const Motion* slowest = nullptr;
  for (const Motion& motion : motions_) {
    if (!has_cycle(motion)) continue;
    if (slowest == nullptr || motion.last->rows.count() > slowest->last->rows.count()) {
      slowest = &motion;
    }
  }
  std::map<std::int64_t, std::span<const double>> all;
  const auto take = [&](const IndexedRows& rows, std::int64_t begin) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      all.emplace(begin + rows.index[i], row_of(rows, i, columns_));
    }
  };
  const IndexedRows base = base_.indexed_rows(slowest == nullptr ? limit_ : limit_ * 2 / 3);
  take(base, 0);
  take(first_wanted_, 0);
  take(last_wanted_, 0);
  take(more, 0);
  IndexedRows beginning;
  IndexedRows cycle;
  if (slowest != nullptr) {
    beginning = slowest->beginning.indexed_rows(limit_ / 8);
    cycle = slowest->last->rows.indexed_rows(limit_ / 2);
    take(beginning, 0);
    take(cycle, slowest->last->begin);
  }
  for (const auto& [index, row] : all) append(drawn.rows, index, row);
  if (slowest != nullptr) {
    const auto stretch = [&](std::int64_t begin, std::int64_t rows) {
      return DrawnStretch{find(drawn.rows, begin), find(drawn.rows, begin + rows - 1), rows};
    };
    drawn.beginning = stretch(0, slowest->beginning.count());
    drawn.cycle = stretch(slowest->last->begin, slowest->last->rows.count());
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

}  // namespace slipbench::driver
