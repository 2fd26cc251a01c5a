// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace slipbench::driver::cleaning {

/// Measured rows, column by column.
struct DataRows {
  std::vector<double> time;                  ///< [T], ascending
  std::vector<std::vector<double>> columns;  ///< each as long as `time`
  /// 1 where rows were left out before this one, so that nothing is to be interpolated towards it;
  /// as long as `time`, or empty: there are no gaps.
  std::vector<char> gap;

  std::size_t size() const { return time.size(); }
  bool gap_before(std::size_t row) const { return !gap.empty() && gap[row] != 0; }
};

}  // namespace slipbench::driver::cleaning
