// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/running_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slipbench::driver::sweep {
namespace {

/// Returns the least width of bins whose ends are doubles around a value.
double least_width(double value) {
  // Of the 53 bits of a double some are left, as bins are counted from 0 on.
  constexpr int kBits = 48;
  return std::ldexp(1.0, std::max(std::ilogb(value) - kBits, -1022));
}

std::int64_t half(std::int64_t bin) { return bin >= 0 ? bin / 2 : (bin - 1) / 2; }

}  // namespace

void RunningHistogram::add(double value, std::uint64_t count) {
  if (width_ == 0.0) {
    if (same_ == 0) only_ = value;
    if (value == only_) {
      same_ += count;
      return;
    }
    width_ = least_width(only_ == 0.0 ? value : only_);
    first_ = static_cast<std::int64_t>(std::floor(only_ / width_));
    counts_.assign(1, same_);
  }
  while (value != 0.0 && width_ < least_width(value)) widen();
  add_bin(static_cast<std::int64_t>(std::floor(value / width_)), count);
}

/// Adds to a bin of today's width, which may be wider afterwards.
void RunningHistogram::add_bin(std::int64_t bin, std::uint64_t count) {
  const auto last = [&] { return first_ + static_cast<std::int64_t>(counts_.size()) - 1; };
  while (std::max(bin, last()) - std::min(bin, first_) >= std::int64_t{kMost}) {
    widen();
    bin = half(bin);
  }
  if (bin < first_) {
    counts_.insert(counts_.begin(), static_cast<std::size_t>(first_ - bin), 0);
    first_ = bin;
  } else if (bin > last()) {
    counts_.resize(static_cast<std::size_t>(bin - first_) + 1);
  }
  counts_[static_cast<std::size_t>(bin - first_)] += count;
}

void RunningHistogram::add(const RunningHistogram& other) {
  if (other.width_ == 0.0) {
    if (other.same_ > 0) add(other.only_, other.same_);
    return;
  }
  RunningHistogram wide = other;
  if (width_ == 0.0) {
    std::swap(*this, wide);
    add(wide);
    return;
  }
  while (wide.width_ < width_) wide.widen();
  while (width_ < wide.width_) widen();
  for (std::size_t i = 0; i < wide.counts_.size(); ++i) {
    if (wide.counts_[i] == 0) continue;
    std::int64_t bin = wide.first_ + static_cast<std::int64_t>(i);
    for (double width = wide.width_; width < width_; width *= 2.0) bin = half(bin);
    add_bin(bin, wide.counts_[i]);
  }
}

void RunningHistogram::widen() {
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
