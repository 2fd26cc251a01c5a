// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/running_histogram.hpp"
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
  /// samples, median and the 5 % and 95 % quantiles (within 1 %), and the parameter with the
  /// highest correlation (Pearson's). Four digits.
  std::string text() const;
  /// The same with all digits, and the histogram and all correlations of each number.
  base::json::Value to_json() const;

  /// Pearson's correlation of a number with a parameter and its 95 % interval (Fisher 1921);
  /// nothing where one of them does not vary.
  struct Correlation {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
  };
  std::optional<Correlation> correlation(std::size_t number, std::size_t parameter) const;

  /// Spread of a number that was collected.
  struct Spread {
    std::size_t count = 0;  ///< of samples that have it
    double mean = 0.0;
    double deviation = 0.0;
    double least = 0.0;
    double most = 0.0;
    std::size_t least_id = 0;
    std::size_t most_id = 0;
    std::array<double, 3> quantiles{};  ///< 5, 50 and 95 %
    const RunningHistogram* histogram = nullptr;
  };
  Spread spread(std::size_t number) const;

  std::size_t samples() const { return samples_; }
  /// Says why the first sample failed that did, and which it was; or nothing.
  std::string failure() const;

 private:
  struct Running;
  std::string strongest_text(std::size_t number) const;

  const Sweep* sweep_;
  std::vector<std::unique_ptr<Running>> numbers_;
  std::size_t samples_ = 0;
  std::size_t failed_ = 0;
  std::size_t first_failed_ = 0;
  std::string failure_;
};

}  // namespace slipbench::driver::sweep
