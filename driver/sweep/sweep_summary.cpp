// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sweep_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/sweep/running_quantiles.hpp"

namespace slipbench::driver::sweep {
/// Mean and sums of squares, updated value by value (Welford 1962).
struct SweepSummary::Running {
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
  RunningQuantiles quantiles;
  std::vector<Beside> parameters;
  RunningHistogram histogram;

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
    quantiles.add(value);
    if (std::isfinite(value)) histogram.add(value);
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

SweepSummary::Spread SweepSummary::spread(std::size_t number) const {
  const Running& one = *numbers_[number];
  Spread spread{.count = static_cast<std::size_t>(one.count),
                .mean = one.mean,
                .deviation = one.count > 1.0 ? std::sqrt(one.squares / (one.count - 1.0)) : 0.0,
                .least = one.least,
                .most = one.most,
                .least_id = one.least_id,
                .most_id = one.most_id,
                .histogram = &one.histogram};
  spread.quantiles = {one.quantiles.at(0.05), one.quantiles.at(0.5), one.quantiles.at(0.95)};
  return spread;
}

std::optional<SweepSummary::Correlation> SweepSummary::correlation(std::size_t number,
                                                                   std::size_t parameter) const {
  // Between which a standard normal variable lies in 95 of 100 cases.
  constexpr double kNormal = 1.959964;
  const Running& one = *numbers_[number];
  const Running::Beside& beside = one.parameters[parameter];
  const double both = std::sqrt(beside.squares * one.squares);
  if (!(both > 0.0) || one.count < 4.0) return std::nullopt;
  const double value = std::clamp(beside.products / both, -1.0, 1.0);
  if (std::abs(value) == 1.0) return Correlation{value, value, value};
  const double half = kNormal / std::sqrt(one.count - 3.0);
  return Correlation{value, std::tanh(std::atanh(value) - half),
                     std::tanh(std::atanh(value) + half)};
}

std::string SweepSummary::failure() const {
  if (failed_ == 0) return {};
  return fmt::format("{} of {} samples failed, the first is {}: {}", failed_, samples_,
                     first_failed_, base::printable(failure_));
}

std::string SweepSummary::text() const {
  std::string text;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const Spread one = spread(i);
    text += "  " + base::printable(sweep_->collected[i].name) + ": ";
    if (one.count == 0) {
      text += "no sample has a value\n";
      continue;
    }
    const std::size_t lacking = samples_ - failed_ - one.count;
    const std::string without = lacking == 0 ? ""
                                             : fmt::format(" (no value in {} {})", lacking,
                                                           lacking == 1 ? "sample" : "samples");
    if (one.least == one.most) {
      text += fmt::format("{:.4g} in every sample{}\n", one.least, without);
      continue;
    }
    text += fmt::format(
        "mean {:.4g}, standard deviation {:.4g}, from {:.4g} (sample {}) to {:.4g} "
        "(sample {}), 5 / 50 / 95 %: {:.4g} / {:.4g} / {:.4g}",
        one.mean, one.deviation, one.least, one.least_id, one.most, one.most_id, one.quantiles[0],
        one.quantiles[1], one.quantiles[2]);
    text += strongest_text(i) + without + "\n";
  }
  if (failed_ > 0) text += "  " + failure() + "\n";
  return text;
}

std::string SweepSummary::strongest_text(std::size_t number) const {
  // Rows of samples that share coordinates are no random sample; their indices tell more.
  if (sweep_->sobol_indices) return {};
  std::optional<Correlation> strongest;
  std::size_t which = 0;
  for (std::size_t p = 0; p < sweep_->varied.size(); ++p) {
    const auto one = correlation(number, p);
    if (!one || (strongest && std::abs(one->value) <= std::abs(strongest->value))) continue;
    strongest = one;
    which = p;
  }
  if (!strongest) return {};
  return fmt::format(", correlation with {} {:.2f} ({:.2f} .. {:.2f})",
                     base::printable(sweep_->varied[which].name), strongest->value, strongest->low,
                     strongest->high);
}

base::json::Value SweepSummary::to_json() const {
  base::json::Value document;
  document["samples"] = samples_;
  document["failed"] = failed_;
  if (failed_ > 0) document["first_failure"] = failure();
  base::json::Value numbers = base::json::Array{};
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const Spread one = spread(i);
    base::json::Value entry;
    entry["name"] = sweep_->collected[i].name;
    entry["samples"] = one.count;
    if (one.count > 0) {
      entry["mean"] = one.mean;
      entry["standard_deviation"] = one.deviation;
      entry["least"] = one.least;
      entry["least_sample"] = one.least_id;
      entry["most"] = one.most;
      entry["most_sample"] = one.most_id;
      entry["quantile_05"] = one.quantiles[0];
      entry["quantile_50"] = one.quantiles[1];
      entry["quantile_95"] = one.quantiles[2];
    }
    if (one.histogram->width() > 0.0) {
      base::json::Value histogram;
      histogram["begin"] = one.histogram->begin();
      histogram["width"] = one.histogram->width();
      base::json::Value counts = base::json::Array{};
      for (const std::uint64_t count : one.histogram->counts()) counts.push_back(count);
      histogram["counts"] = counts;
      entry["histogram"] = histogram;
    }
    base::json::Value correlations = base::json::Array{};
    for (std::size_t p = 0; p < sweep_->varied.size() && !sweep_->sobol_indices; ++p) {
      const auto found = correlation(i, p);
      if (!found) continue;
      base::json::Value with;
      with["parameter"] = sweep_->varied[p].name;
      with["correlation"] = found->value;
      with["low"] = found->low;
      with["high"] = found->high;
      correlations.push_back(with);
    }
    if (!sweep_->sobol_indices) entry["correlations"] = correlations;
    numbers.push_back(entry);
  }
  document["numbers"] = numbers;
  return document;
}

}  // namespace slipbench::driver::sweep
