// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace slipbench::driver::plot {

/// Rows of a path, such as a loop of force over motion, without those that a picture cannot tell
/// from the one before. A row stays where a number has moved by more than kStep of its range since
/// the last that stayed, together with the row just before: what is drawn between two that stay is
/// shorter than that, or joins neighbours. Once `most` rows stay, it takes no more.
class PathRows {
 public:
  static constexpr double kStep = 1.0 / 1500.0;

  /// Column that a path is drawn over or up, and its range.
  struct Column {
    std::size_t number = 0;
    double range = 0.0;
  };

  PathRows(std::vector<Column> columns, std::size_t most)
      : columns_(std::move(columns)), most_(most) {}

  void add(std::span<const double> row) {
    if (kept_ >= most_) return;
    ++taken_;
    if (kept_ > 0 && !moved(row)) {
      waiting_.assign(row.begin(), row.end());
      return;
    }
    keep_waiting();
    keep(row);
  }
  /// The rows that stay, one after the other; nothing may be added later.
  std::vector<double> finish() {
    keep_waiting();
    return std::move(rows_);
  }
  /// Returns how many rows came before it took no more.
  std::int64_t taken() const { return taken_; }

 private:
  bool moved(std::span<const double> row) const {
    const double* const last = rows_.data() + (rows_.size() - row.size());
    for (const Column& column : columns_) {
      if (!(std::abs(row[column.number] - last[column.number]) <= kStep * column.range))
        return true;
    }
    return false;
  }
  void keep(std::span<const double> row) {
    rows_.insert(rows_.end(), row.begin(), row.end());
    ++kept_;
  }
  void keep_waiting() {
    if (!waiting_.empty()) keep(waiting_);
    waiting_.clear();
  }

  std::vector<Column> columns_;
  std::size_t most_;
  std::size_t kept_ = 0;
  std::int64_t taken_ = 0;
  std::vector<double> waiting_;  ///< the last row, if it did not move
  std::vector<double> rows_;
};

}  // namespace slipbench::driver::plot
