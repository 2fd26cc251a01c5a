// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/running_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace slipbench::driver::sweep {
namespace {

/// Returns the narrowest power of two of which kMost bins hold two values.
double width_for(double low, double high) {
  // Bins begin at multiples of their width: one more may be touched than fit.
  int power = std::ilogb((high - low) / (RunningHistogram::kMost - 1));
  while (true) {
    const double width = std::ldexp(1.0, power);
    if (std::floor(high / width) - std::floor(low / width) < double{RunningHistogram::kMost}) {
      return width;
    }
    ++power;
  }
}

}  // namespace

void RunningHistogram::add(double value) {
  if (width_ == 0.0) {
    if (same_ == 0) only_ = value;
    if (value == only_) {
      ++same_;
      return;
    }
    const auto [low, high] = std::minmax(only_, value);
    // Of neighbouring numbers, or of such whose difference overflows, no bins can be told apart.
    if (!std::isfinite(high - low) ||
        !(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
      ++same_;
      return;
    }
    width_ = width_for(low, high);
    first_ = static_cast<std::int64_t>(std::floor(only_ / width_));
    counts_.assign(1, same_);
  }
  while (true) {
    const double bin = std::floor(value / width_);
    const auto first = static_cast<double>(first_);
    const double last = first + static_cast<double>(counts_.size()) - 1.0;
    if (std::max(bin, last) - std::min(bin, first) < double{kMost}) {
      if (bin < first) {
        counts_.insert(counts_.begin(), static_cast<std::size_t>(first - bin), 0);
        first_ = static_cast<std::int64_t>(bin);
      } else if (bin > last) {
        counts_.resize(static_cast<std::size_t>(bin - first) + 1);
      }
      ++counts_[static_cast<std::size_t>(bin - static_cast<double>(first_))];
      return;
    }
    widen();
  }
}

void RunningHistogram::widen() {
  const auto half = [](std::int64_t bin) { return bin >= 0 ? bin / 2 : (bin - 1) / 2; };
  const std::int64_t first = half(first_);
  std::vector<std::uint64_t> wider;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const auto bin = static_cast<std::size_t>(half(first_ + static_cast<std::int64_t>(i)) - first);
    wider.resize(std::max(wider.size(), bin + 1));
    wider[bin] += counts_[i];
  }
  counts_ = std::move(wider);
  first_ = first;
  width_ *= 2.0;
}

}  // namespace slipbench::driver::sweep
