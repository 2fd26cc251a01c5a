// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::driver::results {

/// Thins rows while they come, for curves over a time axis of known ends that a picture is so many
/// pixels wide for. A column of pixels with up to four rows keeps them. Of more it keeps the first
/// and the last; between them two rows stand for the others, with the lowest and the highest number
/// of each column in the order in which they came. A curve drawn through these covers the pixels
/// that one through all rows would, and joins no two rows that are not neighbours but within a
/// pixel. Rows 2 and 3 of such four are therefore none of the result: no number of one column
/// belongs to one of another.
class PixelColumns {
 public:
  /// \param columns numbers in a row; the first is the time, which does not decrease
  PixelColumns(std::size_t columns, double begin, double end, std::size_t pixels);

  void add(std::span<const double> row);
  /// The rows that stay, one after the other; of one that is finished, nothing more may be added.
  std::vector<double> finish();

 private:
  void flush();

  std::size_t columns_;
  double begin_;
  double width_;                ///< of a pixel
  std::int64_t pixel_ = 0;      ///< the one whose rows are coming
  std::int64_t count_ = 0;      ///< its rows so far
  std::vector<double> few_;     ///< its first four rows
  std::vector<double> last_;    ///< its last one
  std::vector<double> lowest_;  ///< over its rows
  std::vector<double> highest_;
  std::vector<bool> rises_;  ///< whether the lowest came before the highest
  std::vector<double> done_;
};

}  // namespace slipbench::driver::results
