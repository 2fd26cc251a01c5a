// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "driver/report/piece_extremes.hpp"

namespace slipbench::driver::report {

/// Rows of a case that are all on its page; of a run with more RowChoice chooses.
inline constexpr std::size_t kMostRows = 50000;
/// The same of each of so many cases: together no more than ten long ones.
constexpr std::size_t most_rows(std::size_t cases) {
  constexpr std::size_t kFewest = 2500;
  return std::clamp(10 * kMostRows / std::max<std::size_t>(cases, 1), kFewest, kMostRows);
}
/// Columns up to which a page has all these rows; a row of a belt of 100 rings has 500 numbers.
inline constexpr std::size_t kColumnsOfMostRows = 64;

/// Rows with their numbers, in their order.
struct IndexedRows {
  std::vector<std::int64_t> index;  ///< how many rows of the run came before each
  std::vector<double> numbers;      ///< row after row

  std::size_t size() const { return index.size(); }
};

/// A cycle of a run that is on its page with all its rows.
struct DrawnCycle {
  std::int64_t number = 0;  ///< from 1; 0: the rest behind the last whole one
  std::size_t first = 0;    ///< row of the page
  std::size_t last = 0;
};

/// The rows of a run that a page draws.
struct DrawnRows {
  IndexedRows rows;
  bool thinned = false;
  // Of a thinned run:
  std::int64_t piece = 1;          ///< rows of a piece; the first and the last of each are there
  std::vector<double> low;         ///< piece after piece, the smallest number of every column
  std::vector<double> high;        ///< the largest
  std::vector<DrawnCycle> cycles;  ///< of those that are whole some, in their order
  std::int64_t cycles_total = 0;   ///< whole ones of the run
  std::size_t motion = 0;          ///< the column that they are cycles of
};

/// Divides a motion to and fro into cycles: one ends where the motion, on its way up, is half of
/// its way so far above where it turned, so that ripples do not count.
class CycleFinder {
 public:
  enum class Turn : std::uint8_t { kNone, kDown, kUp };
  /// Takes the next value of the motion and returns the turn found.
  Turn take(double value);
  /// Largest minus smallest of all values.
  double range() const { return high_ - low_; }

 private:
  bool started_ = false;
  bool down_ = false;  ///< it went down last
  bool turned_ = false;
  double low_ = 0.0;  ///< of all values
  double high_ = 0.0;
  double extreme_ = 0.0;  ///< since the last turn
};

/// Chooses the rows of a page while they come, however many there will be.
///
/// All rows stay up to `limit`, which is smaller in the ratio of the columns where they are more
/// than kColumnsOfMostRows. Of more rows: the first and the last row of limit/8 to limit/4 pieces
/// of equal length, and the extremes of all columns in each (PieceExtremes); the wanted rows
/// (before and after an event), the first and the last limit/16 of them; and, where a motion goes
/// to and fro, whole cycles with all their rows, as far as one has at most limit/4: the first, the
/// last, and between them the 2nd, 5th, 10th, 20th and so on, as many as `limit` rows allow. Of
/// several motions the one with the longest cycle counts. The memory does not grow with the run.
class RowChoice {
 public:
  /// \param columns of a row
  /// \param motions columns that may go to and fro
  RowChoice(std::size_t columns, std::size_t limit, std::span<const std::size_t> motions);

  void add(std::span<const double> row, bool wanted);

  std::int64_t count() const { return count_; }
  bool thinned() const { return count_ > static_cast<std::int64_t>(limit_); }
  /// Returns what was chosen, and `more` rows of the same run.
  DrawnRows finish(const IndexedRows& more = {}) const;

 private:
  struct Cycle {
    std::int64_t number = 1;
    IndexedRows rows;
    double low = 0.0;  ///< of the motion
    double high = 0.0;
    bool whole = true;  ///< no row was left out
  };
  struct Motion {
    std::size_t column = 0;
    CycleFinder finder;
    Cycle current;
    std::deque<Cycle> kept;
    std::int64_t longest = 0;  ///< rows of the last whole cycle
  };

  static bool is_small(const Cycle& cycle, const Motion& motion);
  void take(Cycle& cycle, const Motion& motion, std::span<const double> row) const;
  void follow(Motion& motion, std::span<const double> row) const;
  void want(std::span<const double> row);
  const Motion* slowest() const;

  std::size_t columns_;
  std::size_t limit_;
  std::int64_t count_ = 0;
  std::vector<double> all_;  ///< row after row, as long as all stay
  PieceExtremes pieces_;
  std::vector<Motion> motions_;
  IndexedRows first_wanted_;
  IndexedRows last_wanted_;  ///< a ring, once it is full
  std::size_t next_ = 0;     ///< in the ring
};

/// Picks the rows about given instants: that nearest to each, two before and one behind it.
class RowsAtTimes {
 public:
  explicit RowsAtTimes(std::vector<double> times);

  /// Takes the next row, whose first number is its time.
  void add(std::span<const double> row);
  /// Tells whether no later row is wanted.
  bool done() const { return next_ == times_.size() && behind_ == 0; }
  const IndexedRows& rows() const { return rows_; }

 private:
  void keep(std::int64_t index, std::span<const double> row);

  std::vector<double> times_;
  std::size_t next_ = 0;  ///< of the times, that which was not reached yet
  int behind_ = 0;        ///< rows that are still wanted behind the last one
  std::int64_t count_ = 0;
  std::deque<std::vector<double>> before_;  ///< the last two rows
  IndexedRows rows_;
};

}  // namespace slipbench::driver::report
