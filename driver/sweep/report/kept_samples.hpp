// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Every n-th sample, with the least n (a power of two) that keeps at most kMost of them: a picture
/// shows no more, and which they are depends on nothing but the ids.
class KeptSamples {
 public:
  static constexpr std::size_t kMost = 1500;

  explicit KeptSamples(const Sweep& sweep)
      : width_(sweep.varied.size()), depth_(sweep.collected.size()) {}

  /// Takes the next sample; those that failed have no numbers, and are kept as nan.
  void add(const SampleOutcome& outcome);

  /// n.
  std::size_t stride() const { return stride_; }
  std::size_t size() const { return kept_; }
  double value(std::size_t sample, std::size_t parameter) const {
    return table_[sample * (width_ + depth_) + parameter];
  }
  double number(std::size_t sample, std::size_t number) const {
    return table_[sample * (width_ + depth_) + width_ + number];
  }

 private:
  std::size_t width_;
  std::size_t depth_;
  std::size_t stride_ = 1;
  std::size_t kept_ = 0;
  std::vector<double> table_;
};

}  // namespace slipbench::driver::sweep
