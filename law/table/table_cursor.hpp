// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "law/table/table_function.hpp"

namespace slipbench::law {

/// A reader of the first dependent of a table along a history: it keeps the cell of the last value,
/// in which most next values lie. In the bits of TableFunction::value(). The table must outlive it
/// and stay as it is.
class TableCursor {
 public:
  explicit TableCursor(const TableFunction& function) noexcept : function_(&function) {}

  [[gnu::always_inline]] double value(const Ambient& ambient, SlipArguments slip) noexcept {
    // The cell is empty until there is one, and its independents are told by then.
    const double x = argument(along_.independent, ambient, slip);
    if (!along_.holds(x)) return value_elsewhere(ambient, slip);
    const double f = along_.fraction(x);
    const double low = low_.first + f * low_.rise;
    if (!has_two_) return low;
    const double y = argument(across_.independent, ambient, slip);
    if (!across_.holds(y)) return value_elsewhere(ambient, slip);
    const double high = high_.first + f * high_.rise;
    return low + across_.fraction(y) * (high - low);
  }

 private:
  /// The cell along one independent; empty by default.
  struct Side {
    Independent independent;
    double begin = std::numeric_limits<double>::infinity();
    double end = begin;
    double width = 0.0;

    bool holds(double x) const noexcept { return x >= begin && x < end; }
    double fraction(double x) const noexcept { return (x - begin) / width; }
  };
  /// The ordinates along the first independent.
  struct Edge {
    double first = 0.0;
    double rise = 0.0;  ///< to the second
  };

  /// Moves to the cell of a value, if it has one that can be kept.
  /// \param slip a copy, so that the caller's can stay in registers
  double value_elsewhere(const Ambient& ambient, SlipArguments slip) noexcept;

  const TableFunction* function_;
  bool has_two_ = false;  ///< independents
  Side along_;
  Side across_;
  Edge low_;   ///< where `across_` begins
  Edge high_;  ///< where it ends
};

}  // namespace slipbench::law
