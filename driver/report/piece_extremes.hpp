// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::driver::report {

/// Divides a table into pieces of equally many rows while they come, however many there will be,
/// and keeps of each its first and last row and the smallest and largest number of every column.
/// The memory does not grow with the table: the pieces do.
class PieceExtremes {
 public:
  /// \param columns of a row
  /// \param most pieces, an even number
  PieceExtremes(std::size_t columns, std::size_t most) : columns_(columns), most_(most) {}

  void add(std::span<const double> row);

  /// Rows of a piece; the last one may have fewer.
  std::int64_t length() const { return length_; }
  std::size_t size() const { return columns_ == 0 ? 0 : first_.size() / columns_; }
  std::span<const double> first(std::size_t piece) const { return row_of(first_, piece); }
  std::span<const double> last(std::size_t piece) const { return row_of(last_, piece); }
  /// Piece after piece, each with a number for every column; NaN where none can be compared.
  const std::vector<double>& low() const { return low_; }
  const std::vector<double>& high() const { return high_; }

 private:
  std::span<const double> row_of(const std::vector<double>& rows, std::size_t piece) const {
    return {rows.data() + piece * columns_, columns_};
  }
  void merge();

  std::size_t columns_;
  std::size_t most_;
  std::int64_t length_ = 1;
  std::int64_t in_last_ = 0;  ///< rows of the last piece
  std::vector<double> first_;
  std::vector<double> last_;
  std::vector<double> low_;
  std::vector<double> high_;
};

}  // namespace slipbench::driver::report
