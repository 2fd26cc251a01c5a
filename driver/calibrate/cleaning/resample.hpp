// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "driver/calibrate/cleaning/data_rows.hpp"

namespace slipbench::driver::cleaning {

/// More would fill the memory.
inline constexpr double kMostResampledRows = 1.0e6;

/// Interpolates rows linearly at ascending times: every look goes on where the last one ended.
class RowCursor {
 public:
  explicit RowCursor(const DataRows& rows) : rows_(&rows) {}

  /// Goes to a time, not before that of the last call. \return whether there is a value: the time
  /// lies within the rows and not inside a gap
  bool seek(double time);
  /// The value of a column there.
  double value(std::size_t column) const;

 private:
  const DataRows* rows_;
  std::size_t row_ = 0;  ///< the last one at or before the time
  double fraction_ = 0.0;
};

/// Rows at t0, t0 + every, ... up to the last time, t0 being the first; times inside a gap are left
/// out.
/// \param every time from one row to the next [T], > 0
DataRows resampled(const DataRows& rows, double every);

/// `points` rows spread evenly from the first time to the last; times inside a gap are left out.
/// \param points >= 2
DataRows resampled(const DataRows& rows, int points);

}  // namespace slipbench::driver::cleaning
