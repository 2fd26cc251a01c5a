// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slipbench::driver::sweep {

/// Counts of values in bins of one width, the least power of two by which at most kMost bins hold
/// all values and the ends of bins are doubles; so it does not depend on the order of the values,
/// nor on how they were divided. Memory does not grow with their number.
class RunningHistogram {
 public:
  static constexpr std::size_t kMost = 128;

  /// Takes a finite value.
  void add(double value) { add(value, 1); }
  /// Takes all values of another one.
  void add(const RunningHistogram& other);

  /// Where the first bin begins, and how wide each is; 0 while all values are the same.
  double begin() const { return static_cast<double>(first_) * width_; }
  double width() const { return width_; }
  std::span<const std::uint64_t> counts() const { return counts_; }

  void fields(auto& archive) { archive(width_, only_, same_, first_, counts_); }

 private:
  void add(double value, std::uint64_t count);
  void add_bin(std::int64_t bin, std::uint64_t count);
  void widen();

  double width_ = 0.0;
  double only_ = 0.0;       ///< the value of all so far, while the width is 0
  std::uint64_t same_ = 0;  ///< how many they are
  std::int64_t first_ = 0;  ///< bin, counted from 0 at 0
  std::vector<std::uint64_t> counts_;
};

}  // namespace slipbench::driver::sweep
