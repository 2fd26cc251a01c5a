// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/text/json.hpp"
#include "driver/sweep/exact_sum.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/running_histogram.hpp"
#include "driver/sweep/running_quantiles.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Spread of what a sweep collects. It has the same bits whatever the order of the samples, and
/// however they were divided; memory does not grow with their number.
class SweepSummary {
 public:
  explicit SweepSummary(const Sweep& sweep);

  void add(const SampleOutcome& outcome);
  /// Takes all samples of another summary of the same sweep.
  void add(const SweepSummary& other);
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
    std::array<double, 3> quantiles{};            ///< 5, 50 and 95 %
    const RunningHistogram* histogram = nullptr;  ///< where the values can be told apart
  };
  Spread spread(std::size_t number) const;

  std::size_t samples() const { return samples_; }
  /// Says why the first sample failed that did, and which it was; or nothing.
  std::string failure() const;

  void fields(auto& archive) { archive(numbers_, samples_, failed_, first_failed_, failure_); }

 private:
  /// State of a number.
  struct Running {
    /// Sums over those samples that have the number.
    struct Beside {
      ExactSum sum;
      ExactSum squares;
      ExactSum products;  ///< with the number

      void fields(auto& archive) { archive(sum, squares, products); }
    };
    std::size_t count = 0;
    ExactSum sum;
    ExactSum squares;
    double least = 0.0;
    double most = 0.0;
    std::size_t least_id = 0;
    std::size_t most_id = 0;
    RunningQuantiles quantiles;
    std::vector<Beside> parameters;
    RunningHistogram histogram;

    void take_extremes(double low, std::size_t low_id, double high, std::size_t high_id);
    void add(double value, const SampleOutcome& outcome);
    void add(const Running& other);
    void fields(auto& archive) {
      archive(count, sum, squares, least, most, least_id, most_id, quantiles, parameters,
              histogram);
    }
  };
  std::string strongest_text(std::size_t number) const;

  const Sweep* sweep_;
  std::vector<Running> numbers_;
  std::size_t samples_ = 0;
  std::size_t failed_ = 0;
  std::size_t first_failed_ = 0;
  std::string failure_;
};

}  // namespace slipbench::driver::sweep
