// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::driver::results {

/// Thins the rows of a table for drawing while they come, however many there will be.
///
/// As long as there are at most `limit` rows, all of them stay. Of more, these do, in their order:
/// the first and the last row; for each column the first row in which it is lowest and in which it
/// is highest; the rows that the caller wants kept, up to a quarter of `limit` (of more of them
/// every second one, and so on); and, of as many pieces of equal numbers of rows as `limit` allows,
/// the first and the last row and those in which a watched column is lowest or highest. What is
/// drawn of the watched columns then covers the same area as the whole table would. Numbers that
/// are not comparable (NaN) are never an extreme.
///
/// The memory depends on `limit` and the number of columns, not on the number of rows.
class RowThinner {
 public:
  /// Rows with their numbers, in their order.
  struct Rows {
    std::vector<std::int64_t> index;  ///< how many came before each
    std::vector<double> numbers;      ///< row after row

    std::size_t size() const { return index.size(); }
    void clear();
  };

  /// \param columns numbers in a row, at least 1
  /// \param limit rows that `rows` may give; at least enough for the ends, the extremes and the
  ///   kept rows: a smaller one is raised to 4/3 (2 + 2 columns + 2 watched)
  /// \param watched columns that are drawn, by number; empty: all
  RowThinner(std::size_t columns, std::size_t limit, std::span<const std::size_t> watched = {});

  /// Takes the next row of `columns` numbers.
  /// \param must_keep whether it is one that a picture needs, such as a change of regime
  void add(std::span<const double> row, bool must_keep = false);

  /// The rows that stay, one after the other.
  std::vector<double> rows() const { return indexed_rows(limit_).numbers; }
  /// The same with their places, and of a run that is thinned at most `most` of them, as far as the
  /// ends, the extremes and the kept rows allow.
  Rows indexed_rows(std::size_t most) const;
  /// Returns how many rows came.
  std::int64_t count() const { return count_; }
  /// Tells whether `rows` gives fewer.
  bool thinned() const { return count_ > static_cast<std::int64_t>(limit_); }

 private:
  using Chosen = std::vector<std::size_t>;

  std::span<const double> row_of(const Rows& rows, std::size_t i) const;
  void append(Rows& to, const Rows& from, std::size_t i) const;
  /// Marks the first and the last of rows [begin, end), and the extremes of `columns` in them.
  void choose(const Rows& rows, std::size_t begin, std::size_t end,
              std::span<const std::size_t> columns, Chosen& chosen) const;
  void close_piece();
  void merge_pieces();
  void keep(std::span<const double> row);

  std::size_t columns_;
  std::size_t limit_;
  std::size_t most_kept_;
  std::vector<std::size_t> all_;
  std::vector<std::size_t> watched_;

  Rows done_;                            ///< the telling rows of complete pieces
  std::vector<std::size_t> piece_ends_;  ///< in done_
  Rows open_;                            ///< of the piece that is not complete
  std::int64_t piece_length_ = 1;        ///< rows that make a piece
  std::int64_t in_piece_ = 0;
  Rows kept_;
  std::int64_t keep_every_ = 1;
  std::int64_t wanted_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace slipbench::driver::results
