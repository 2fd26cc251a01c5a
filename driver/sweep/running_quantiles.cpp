// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/running_quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slipbench::driver::sweep {
namespace {

/// Bin of a value: 0 of 0, else the logarithm of its magnitude in steps of 1 %, counted from where
/// none of a double is negative; with the sign of the value.
std::int32_t bin_of(double value) {
  constexpr double kSteps = 1.0 / 0.00995033085316808;  // of ln 1.01
  constexpr double kLeast = 80000.0;                    // the smallest double is at -74818
  constexpr double kInfinite = 200000.0;
  if (value == 0.0) return 0;
  const double magnitude = std::abs(value);
  const double step =
      std::isinf(magnitude) ? kInfinite : std::floor(std::log(magnitude) * kSteps) + kLeast;
  return static_cast<std::int32_t>(std::copysign(step, value));
}

}  // namespace

void RunningQuantiles::add(double value) {
  Bin& bin = bins_[bin_of(value)];
  bin.least = bin.count == 0 ? value : std::min(bin.least, value);
  bin.most = bin.count == 0 ? value : std::max(bin.most, value);
  ++bin.count;
  ++count_;
}

void RunningQuantiles::add(const RunningQuantiles& other) {
  for (const auto& [key, theirs] : other.bins_) {
    const auto [place, is_new] = bins_.try_emplace(key, theirs);
    if (is_new) continue;
    Bin& bin = place->second;
    bin.least = std::min(bin.least, theirs.least);
    bin.most = std::max(bin.most, theirs.most);
    bin.count += theirs.count;
  }
  count_ += other.count_;
}

double RunningQuantiles::at(double part) const {
  // The rank of the value, from 1 on.
  const double wanted = std::ceil(part * static_cast<double>(count_) * (1.0 - 1e-12));
  const auto rank = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(wanted));
  std::uint64_t below = 0;
  for (const auto& [key, bin] : bins_) {
    if (below + bin.count < rank) {
      below += bin.count;
      continue;
    }
    if (bin.least == bin.most) return bin.least;
    // The bin has two values or more: its ends, and others between as if evenly.
    const double way = static_cast<double>(rank - below - 1) / static_cast<double>(bin.count - 1);
    return bin.least + way * (bin.most - bin.least);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace slipbench::driver::sweep
