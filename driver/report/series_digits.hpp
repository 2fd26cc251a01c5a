// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace slipbench::driver::report {

/// Number of significant digits that the numbers of a page need, so that what differs in a run
/// differs on the page, too: never fewer than kFewestDigits, never more than kMostDigits, with
/// which any number is told from those that rounding could have made of it.
inline constexpr int kFewestDigits = 6;
inline constexpr int kMostDigits = 15;

/// Significant digits that tell `value` to within `resolution`.
int digits_within(double value, double resolution);

/// The digits of each number of a series: six of the range of them all (10000.000 .. 10000.001
/// needs thirteen), and three of the step to its neighbours: a small motion that follows a long way
/// keeps its shape. Steps below 1e-8 of the range count as none.
class SeriesDigits {
 public:
  explicit SeriesDigits(std::span<const double> numbers);
  int operator[](std::size_t i) const;

 private:
  std::span<const double> numbers_;
  double of_range_ = 0.0;  ///< resolution that the range asks for
  double least_step_ = 0.0;
};

/// Returns what times are told to within: a thousandth of the shortest time between two rows, so
/// that events within an increment are told apart, too. 0 if there are no two times.
double time_resolution(std::span<const double> times);

}  // namespace slipbench::driver::report
