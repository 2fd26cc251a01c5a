// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Spread of what a sweep collects, sample by sample; memory does not grow with their number.
class SweepSummary {
 public:
  explicit SweepSummary(const Sweep& sweep);
  ~SweepSummary();
  SweepSummary(const SweepSummary&) = delete;
  SweepSummary& operator=(const SweepSummary&) = delete;

  void add(const SampleOutcome& outcome);
  std::size_t failed() const { return failed_; }

  /// One line a number that was collected: mean and standard deviation, the extremes with their
  /// samples, median and the 5 % and 95 % quantiles (estimated by the P2 algorithm, Jain and
  /// Chlamtac 1985), and the parameter with the highest correlation (Pearson's). Four digits.
  std::string text() const;

 private:
  struct Running;
  const Sweep* sweep_;
  std::vector<std::unique_ptr<Running>> numbers_;
  std::size_t samples_ = 0;
  std::size_t failed_ = 0;
  std::size_t first_failed_ = 0;
  std::string failure_;
};

}  // namespace slipbench::driver::sweep
