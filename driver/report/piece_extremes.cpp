// SPDX-License-Identifier: Apache-2.0
#include "driver/report/piece_extremes.hpp"

#include <algorithm>

namespace slipbench::driver::report {
namespace {

// Returns the lower; a NaN is no extreme: the other one is taken.
double lower(double a, double b) { return !(a <= b) && b == b ? b : a; }
double higher(double a, double b) { return !(a >= b) && b == b ? b : a; }

}  // namespace

void PieceExtremes::add(std::span<const double> row) {
  if (size() == most_ && in_last_ == length_) merge();
  if (size() == 0 || in_last_ == length_) {
    for (std::vector<double>* rows : {&first_, &last_, &low_, &high_}) {
      rows->insert(rows->end(), row.begin(), row.end());
    }
    in_last_ = 1;
    return;
  }
  const std::size_t place = last_.size() - columns_;
  for (std::size_t c = 0; c < columns_; ++c) {
    last_[place + c] = row[c];
    low_[place + c] = lower(low_[place + c], row[c]);
    high_[place + c] = higher(high_[place + c], row[c]);
  }
  ++in_last_;
}

/// Two neighbours become one.
void PieceExtremes::merge() {
  const std::size_t half = size() / 2;
  for (std::size_t i = 0; i < half * columns_; ++i) {
    const std::size_t c = i % columns_;
    const std::size_t a = 2 * (i - c) + c;
    const std::size_t b = a + columns_;
    first_[i] = first_[a];
    last_[i] = last_[b];
    low_[i] = lower(low_[a], low_[b]);
    high_[i] = higher(high_[a], high_[b]);
  }
  for (std::vector<double>* rows : {&first_, &last_, &low_, &high_}) rows->resize(half * columns_);
  length_ *= 2;
  in_last_ = length_;
}

}  // namespace slipbench::driver::report
