// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/report/kept_samples.hpp"

#include <algorithm>

namespace slipbench::driver::sweep {

void KeptSamples::add(const SampleOutcome& outcome) {
  if (outcome.id % stride_ != 0) return;
  const auto width = static_cast<std::ptrdiff_t>(width_ + depth_);
  if (kept_ == kMost) {
    // The first of each pair stays.
    for (std::size_t i = 0; 2 * i < kept_; ++i) {
      std::copy_n(table_.begin() + static_cast<std::ptrdiff_t>(2 * i) * width, width,
                  table_.begin() + static_cast<std::ptrdiff_t>(i) * width);
    }
    kept_ = (kept_ + 1) / 2;
    table_.resize(kept_ * static_cast<std::size_t>(width));
    stride_ *= 2;
    if (outcome.id % stride_ != 0) return;
  }
  table_.insert(table_.end(), outcome.values.begin(), outcome.values.end());
  table_.insert(table_.end(), outcome.numbers.begin(), outcome.numbers.end());
  ++kept_;
}

}  // namespace slipbench::driver::sweep
