// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Outcome of one sample.
struct SampleOutcome {
  std::size_t id = 0;               ///< from 0 on
  std::span<const double> values;   ///< of the varied parameters
  std::span<const double> numbers;  ///< what was collected; all nan if it failed
  std::string_view failure;         ///< a sentence, or empty
};

struct SweepOptions {
  unsigned threads = 1;
  std::size_t first = 0;                                      ///< sample
  std::size_t end = std::numeric_limits<std::size_t>::max();  ///< the samples end before it
  std::function<void(std::size_t done, std::size_t failed)> progress = {};
};

/// Runs all samples and hands out each in the order of their ids, whatever the threads do; memory
/// does not grow with their number. Nothing is thrown by a sample that fails.
void run_sweep(const Sweep& sweep, const SweepOptions& options,
               const std::function<void(const SampleOutcome&)>& take);

}  // namespace slipbench::driver::sweep
