// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::driver::sweep {

/// Counts of values in bins of one width, which is a power of two times whatever takes all values
/// in at most kMost bins; so it does not depend on the order of the values. Memory does not grow
/// with their number.
class RunningHistogram {
 public:
  static constexpr std::size_t kMost = 128;

  /// Takes a finite value.
  void add(double value);

  /// Where the first bin begins, and how wide each is; 0 while all values are the same.
  double begin() const { return static_cast<double>(first_) * width_; }
  double width() const { return width_; }
  std::span<const std::uint64_t> counts() const { return counts_; }

 private:
  void widen();

  double width_ = 0.0;
  double only_ = 0.0;       ///< the value of all so far
  std::uint64_t same_ = 0;  ///< how many they are, while the width is 0
  std::int64_t first_ = 0;  ///< bin, counted from 0 at 0
  std::vector<std::uint64_t> counts_;
};

}  // namespace slipbench::driver::sweep
