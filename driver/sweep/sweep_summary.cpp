// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sweep_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "driver/base/text/diagnostic.hpp"

namespace slipbench::driver::sweep {

void SweepSummary::Running::take_extremes(double low, std::size_t low_id, double high,
                                          std::size_t high_id) {
  // Of equal ones the first sample.
  if (count == 0 || low < least || (low == least && low_id < least_id)) {
    least = low;
    least_id = low_id;
  }
  if (count == 0 || high > most || (high == most && high_id < most_id)) {
    most = high;
    most_id = high_id;
  }
}

void SweepSummary::Running::add(double value, const SampleOutcome& outcome) {
  take_extremes(value, outcome.id, value, outcome.id);
  ++count;
  sum.add(value);
  squares.add_product(value, value);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    Beside& one = parameters[p];
    const double own = outcome.values[p];
    one.sum.add(own);
    one.squares.add_product(own, own);
    one.products.add_product(own, value);
  }
  quantiles.add(value);
  if (std::isfinite(value)) histogram.add(value);
}

void SweepSummary::Running::add(const Running& other) {
  if (other.count == 0) return;
  take_extremes(other.least, other.least_id, other.most, other.most_id);
  count += other.count;
  sum.add(other.sum);
  squares.add(other.squares);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    parameters[p].sum.add(other.parameters[p].sum);
    parameters[p].squares.add(other.parameters[p].squares);
    parameters[p].products.add(other.parameters[p].products);
  }
  quantiles.add(other.quantiles);
  histogram.add(other.histogram);
}

SweepSummary::SweepSummary(const Sweep& sweep) : sweep_(&sweep), numbers_(sweep.collected.size()) {
  for (Running& one : numbers_) one.parameters.resize(sweep.varied.size());
}

void SweepSummary::add(const SampleOutcome& outcome) {
  ++samples_;
  if (!outcome.failure.empty()) {
    if (failed_ == 0 || outcome.id < first_failed_) {
      first_failed_ = outcome.id;
      failure_ = outcome.failure;
    }
    ++failed_;
    return;
  }
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (!std::isnan(outcome.numbers[i])) numbers_[i].add(outcome.numbers[i], outcome);
  }
}

void SweepSummary::add(const SweepSummary& other) {
  samples_ += other.samples_;
  if (other.failed_ > 0 && (failed_ == 0 || other.first_failed_ < first_failed_)) {
    first_failed_ = other.first_failed_;
    failure_ = other.failure_;
  }
  failed_ += other.failed_;
  for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i].add(other.numbers_[i]);
}

SweepSummary::Spread SweepSummary::spread(std::size_t number) const {
  // Values that differ by less are the same, and their histogram would show rounding.
  constexpr double kSame = 1e-12;
  const Running& one = numbers_[number];
  Spread spread{.count = one.count,
                .least = one.least,
                .most = one.most,
                .least_id = one.least_id,
                .most_id = one.most_id};
  if (one.count == 0) return spread;
  const auto count = static_cast<double>(one.count);
  spread.mean = one.sum.value() / count;
  if (one.count > 1) {
    const double squares = sum_about_means(count, one.sum, one.sum, one.squares);
    spread.deviation = std::sqrt(squares / (count - 1.0));
  }
  spread.quantiles = {one.quantiles.at(0.05), one.quantiles.at(0.5), one.quantiles.at(0.95)};
  const double larger = std::max(std::abs(one.least), std::abs(one.most));
  if (one.most - one.least > kSame * larger) spread.histogram = &one.histogram;
  return spread;
}

std::optional<SweepSummary::Correlation> SweepSummary::correlation(std::size_t number,
                                                                   std::size_t parameter) const {
  // Between which a standard normal variable lies in 95 of 100 cases.
  constexpr double kNormal = 1.959964;
  constexpr std::size_t kFewest = 4;
  const Running& one = numbers_[number];
  if (one.count < kFewest) return std::nullopt;
  const Running::Beside& beside = one.parameters[parameter];
  const auto count = static_cast<double>(one.count);
  const double both = std::sqrt(sum_about_means(count, beside.sum, beside.sum, beside.squares) *
                                sum_about_means(count, one.sum, one.sum, one.squares));
  if (!(both > 0.0)) return std::nullopt;
  const double value =
      std::clamp(sum_about_means(count, beside.sum, one.sum, beside.products) / both, -1.0, 1.0);
  if (std::abs(value) == 1.0) return Correlation{value, value, value};
  const double half = kNormal / std::sqrt(count - 3.0);
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
    if (one.histogram != nullptr) {
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
