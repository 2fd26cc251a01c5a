// SPDX-License-Identifier: Apache-2.0
#include "driver/results/pixel_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slipbench::driver::results {
namespace {

constexpr std::int64_t kFew = 4;

}  // namespace

PixelColumns::PixelColumns(std::size_t columns, double begin, double end, std::size_t pixels)
    : columns_(columns),
      begin_(begin),
      width_((end - begin) / static_cast<double>(pixels)),
      rises_(columns) {}

void PixelColumns::add(std::span<const double> row) {
  const std::int64_t pixel =
      width_ > 0.0 ? static_cast<std::int64_t>(std::floor((row[0] - begin_) / width_)) : 0;
  if (pixel != pixel_) flush();
  pixel_ = pixel;
  if (count_++ == 0) {
    lowest_.assign(row.begin(), row.end());
    highest_ = lowest_;
  }
  if (count_ <= kFew) few_.insert(few_.end(), row.begin(), row.end());
  last_.assign(row.begin(), row.end());
  for (std::size_t k = 0; k < columns_; ++k) {
    // A number that compares with nothing is no extreme, also where it came first.
    if (!(row[k] >= lowest_[k]) && !std::isnan(row[k])) {
      if (std::isnan(highest_[k])) highest_[k] = row[k];
      lowest_[k] = row[k];
      rises_[k] = false;
    }
    if (row[k] > highest_[k]) {
      highest_[k] = row[k];
      rises_[k] = true;
    }
  }
}

void PixelColumns::flush() {
  if (count_ <= kFew) {
    done_.insert(done_.end(), few_.begin(), few_.end());
  } else {
    const double begin = few_[0];
    const double third = (last_[0] - begin) / 3.0;
    done_.insert(done_.end(), few_.begin(), few_.begin() + static_cast<std::ptrdiff_t>(columns_));
    for (const bool second : {false, true}) {
      done_.push_back(begin + (second ? 2.0 : 1.0) * third);
      for (std::size_t k = 1; k < columns_; ++k) {
        done_.push_back(rises_[k] == second ? highest_[k] : lowest_[k]);
      }
    }
    done_.insert(done_.end(), last_.begin(), last_.end());
  }
  few_.clear();
  count_ = 0;
}

std::vector<double> PixelColumns::finish() {
  flush();
  return std::move(done_);
}

}  // namespace slipbench::driver::results
