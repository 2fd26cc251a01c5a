// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "law/base/slip_vector.hpp"

namespace slipbench::law {

/// Values that are extrapolated: those at the end of a piece, and sums over it.
struct PieceSums {
  SlipVector held{};       ///< of the spring: force [F], or elastic slip [L] under an allowable one
  double slip = 0.0;       ///< [L]
  double slip_rate = 0.0;  ///< at the end [L/T]
  double dissipation = 0.0;  ///< [F L]
  double work = 0.0;         ///< [F L]
};

/// The table of Aitken and Neville over 1, 2, 3, ... equal sub-increments of a piece (Deuflhard
/// 1983; theory 11.9): sums whose error is a series in the length of the sub-increments are
/// extrapolated to the length 0. The last row is kept.
class NevilleTable {
 public:
  static constexpr int kMostRows = 8;

  /// Adds the sums over one sub-increment more than those of the last row; at most kMostRows times.
  void add(const PieceSums& sums) noexcept {
    above_ = corner_;
    corner_ = sums;
    for (int k = 0; k < rows_; ++k) {
      const auto n = static_cast<std::size_t>(k);
      const PieceSums above = row_[n];
      row_[n] = beside_ = corner_;
      corner_ = extrapolated(corner_, above, 1.0 / ((rows_ + 1.0) / (rows_ - k) - 1.0));
    }
    row_[static_cast<std::size_t>(rows_++)] = corner_;
  }

  /// The best estimate: the last entry of the last row.
  const PieceSums& corner() const { return corner_; }
  /// The entry before it in its row, and the corner of the row before: from two rows on.
  const PieceSums& beside() const { return beside_; }
  const PieceSums& above() const { return above_; }

 private:
  static PieceSums extrapolated(const PieceSums& entry, const PieceSums& above, double weight) {
    const auto next = [weight](double a, double b) { return a + weight * (a - b); };
    PieceSums sums;
    for (std::size_t i = 0; i < sums.held.size(); ++i) {
      sums.held[i] = next(entry.held[i], above.held[i]);
    }
    sums.slip = next(entry.slip, above.slip);
    sums.slip_rate = next(entry.slip_rate, above.slip_rate);
    sums.dissipation = next(entry.dissipation, above.dissipation);
    sums.work = next(entry.work, above.work);
    return sums;
  }

  std::array<PieceSums, kMostRows> row_{};
  PieceSums corner_, beside_, above_;
  int rows_ = 0;
};

}  // namespace slipbench::law
