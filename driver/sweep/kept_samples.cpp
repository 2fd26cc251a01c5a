// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/kept_samples.hpp"

#include <algorithm>
#include <utility>

namespace slipbench::driver::sweep {

void KeptSamples::add(const SampleOutcome& outcome) {
  if (outcome.id % stride_ != 0) return;
  Row row{outcome.id, {outcome.values.begin(), outcome.values.end()}};
  row.table.insert(row.table.end(), outcome.numbers.begin(), outcome.numbers.end());
  insert(std::move(row));
}

void KeptSamples::add(const KeptSamples& other) {
  while (stride_ < other.stride_) thin();
  for (const Row& row : other.rows_) {
    if (row.id % stride_ == 0) insert(row);
  }
}

void KeptSamples::insert(Row row) {
  const auto place =
      std::upper_bound(rows_.begin(), rows_.end(), row.id,
                       [](std::size_t id, const Row& other) { return id < other.id; });
  rows_.insert(place, std::move(row));
  while (rows_.size() > kMost) thin();
}

void KeptSamples::thin() {
  stride_ *= 2;
  std::erase_if(rows_, [&](const Row& row) { return row.id % stride_ != 0; });
}

}  // namespace slipbench::driver::sweep
