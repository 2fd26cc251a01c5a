// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "driver/results/thinning.hpp"

namespace slipbench::driver {

using IndexedRows = RowThinner::Rows;

/// A stretch of a run within the rows of a page.
struct DrawnStretch {
  std::size_t first = 0;  ///< row of the page
  std::size_t last = 0;
  std::int64_t rows = 0;  ///< of the run, in this stretch
};

/// The rows of a run that a page draws.
struct DrawnRows {
  IndexedRows rows;
  bool thinned = false;
  std::optional<DrawnStretch> beginning;  ///< up to the first turn; of thinned runs with cycles
  std::optional<DrawnStretch> cycle;      ///< the last whole one
};

/// Divides a motion to and fro into cycles: one ends where the motion, on its way up, is half of
/// its way so far above where it turned, so that ripples do not count.
class CycleFinder {
 public:
  enum class Turn : std::uint8_t { kNone, kDown, kUp };
  /// What the motion is found to do at its next value.
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
/// Of up to `limit` rows all stay. Of more: as many as RowThinner chooses, or two thirds of them
/// where there are cycles; the
/// wanted rows (before and after an event), as long as there are few, else the first and the last
/// limit/8 of them; and, where a motion goes to and fro, its beginning up to the first turn (at
/// most limit/8 rows) and its last whole cycle with all its rows, or limit/2 of them. Of several
/// motions the one with the longest cycle counts. The memory does not grow with the run.
class RowChoice {
 public:
  /// \param columns of a row
  /// \param watched as in RowThinner
  /// \param motions columns that may go to and fro
  RowChoice(std::size_t columns, std::size_t limit, std::span<const std::size_t> watched,
            std::span<const std::size_t> motions);

  void add(std::span<const double> row, bool wanted);

  std::int64_t count() const { return base_.count(); }
  bool thinned() const { return base_.thinned(); }
  /// What was chosen, and `more` rows of the same run.
  DrawnRows finish(const IndexedRows& more = {}) const;

 private:
  struct Cycle {
    std::int64_t begin = 0;  ///< place of its first row
    RowThinner rows;
  };
  struct Motion {
    std::size_t column = 0;
    CycleFinder finder;
    RowThinner beginning;
    bool began = false;  ///< the beginning is over
    std::optional<Cycle> current;
    std::optional<Cycle> last;
  };

  bool has_cycle(const Motion& motion) const;
  void follow(Motion& motion, std::span<const double> row, bool wanted);
  void want(std::span<const double> row);
  RowThinner cycle_thinner() const { return {columns_, limit_ / 2, watched_}; }

  std::size_t columns_;
  std::size_t limit_;
  std::vector<std::size_t> watched_;
  RowThinner base_;
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
  /// Whether no later row is wanted.
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

}  // namespace slipbench::driver
