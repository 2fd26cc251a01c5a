// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sweep_summary.hpp"

#include <fmt/format.h>
#include <gsl/gsl_rstat.h>

#include <array>
#include <cmath>
#include <utility>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::sweep {
/// Mean and sums of squares, updated value by value (Welford 1962).
struct SweepSummary::Running {
  struct FreeQuantile {
    void operator()(gsl_rstat_quantile_workspace* work) const { gsl_rstat_quantile_free(work); }
  };
  using Quantile = std::unique_ptr<gsl_rstat_quantile_workspace, FreeQuantile>;
  static Quantile quantile(double part) { return Quantile(gsl_rstat_quantile_alloc(part)); }

  struct Beside {
    double mean = 0.0;
    double squares = 0.0;   ///< of the differences from the mean
    double products = 0.0;  ///< of these with the number's
  };
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;
  double least = 0.0;
  double most = 0.0;
  std::size_t least_id = 0;
  std::size_t most_id = 0;
  std::array<Quantile, 3> quantiles{quantile(0.05), quantile(0.5), quantile(0.95)};
  std::vector<Beside> parameters;

  void add(double value, const SampleOutcome& outcome) {
    if (count == 0.0 || value < least) {
      least = value;
      least_id = outcome.id;
    }
    if (count == 0.0 || value > most) {
      most = value;
      most_id = outcome.id;
    }
    count += 1.0;
    const double before = value - mean;
    mean += before / count;
    squares += before * (value - mean);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      Beside& one = parameters[p];
      const double own = outcome.values[p] - one.mean;
      one.mean += own / count;
      one.squares += own * (outcome.values[p] - one.mean);
      one.products += own * (value - mean);
    }
    for (const Quantile& one : quantiles) gsl_rstat_quantile_add(value, one.get());
  }

  /// Pearson's correlation with a parameter; 0 where one of them does not vary.
  double correlation(std::size_t parameter) const {
    const Beside& one = parameters[parameter];
    const double both = std::sqrt(one.squares * squares);
    return both > 0.0 ? one.products / both : 0.0;
  }
};

SweepSummary::SweepSummary(const Sweep& sweep) : sweep_(&sweep) {
  for (std::size_t i = 0; i < sweep.collected.size(); ++i) {
    numbers_.push_back(std::make_unique<Running>());
    numbers_.back()->parameters.resize(sweep.varied.size());
  }
}

SweepSummary::~SweepSummary() = default;

void SweepSummary::add(const SampleOutcome& outcome) {
  ++samples_;
  if (!outcome.failure.empty()) {
    if (failed_++ == 0) {
      first_failed_ = outcome.id;
      failure_ = outcome.failure;
    }
    return;
  }
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (!std::isnan(outcome.numbers[i])) numbers_[i]->add(outcome.numbers[i], outcome);
  }
}

std::string SweepSummary::text() const {
  std::string text;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const Running& one = *numbers_[i];
    text += "  " + base::printable(sweep_->collected[i].name) + ": ";
    if (one.count == 0.0) {
      text += "no sample has a value\n";
      continue;
    }
    const auto with_value = static_cast<std::size_t>(one.count);
    const std::size_t lacking = samples_ - failed_ - with_value;
    const std::string without = lacking == 0 ? ""
                                             : fmt::format(" (no value in {} {})", lacking,
                                                           lacking == 1 ? "sample" : "samples");
    if (one.least == one.most) {
      text += fmt::format("{:.4g} in every sample{}\n", one.least, without);
      continue;
    }
    const double deviation = one.count > 1.0 ? std::sqrt(one.squares / (one.count - 1.0)) : 0.0;
    text += fmt::format(
        "mean {:.4g}, standard deviation {:.4g}, from {:.4g} (sample {}) to {:.4g} "
        "(sample {})",
        one.mean, deviation, one.least, one.least_id, one.most, one.most_id);
    std::array<double, 3> at{};
    for (std::size_t q = 0; q < at.size(); ++q) {
      at[q] = gsl_rstat_quantile_get(one.quantiles[q].get());
    }
    text += fmt::format(", 5 / 50 / 95 %: {:.4g} / {:.4g} / {:.4g}", at[0], at[1], at[2]);
    // Rows of samples that share coordinates are no random sample; their indices tell more.
    if (sweep_->sobol_indices) {
      text += without + "\n";
      continue;
    }
    std::size_t strongest = 0;
    for (std::size_t p = 1; p < one.parameters.size(); ++p) {
      if (std::abs(one.correlation(p)) > std::abs(one.correlation(strongest))) strongest = p;
    }
    text += fmt::format(", correlation with {} {:.2f}{}\n",
                        base::printable(sweep_->varied[strongest].name), one.correlation(strongest),
                        without);
  }
  if (failed_ > 0) {
    text += fmt::format("  {} of {} samples failed, the first is {}: {}\n", failed_, samples_,
                        first_failed_, base::printable(failure_));
  }
  return text;
}

}  // namespace slipbench::driver::sweep
