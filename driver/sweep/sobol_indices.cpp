// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sobol_indices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/results/provenance.hpp"
#include "driver/sweep/part.hpp"

namespace slipbench::driver::sweep {
namespace {

constexpr std::size_t kGroups = 64;
/// Of Student's distribution with 63 degrees of freedom, between which 95 % lie.
constexpr double kStudent = 1.998;

/// With two digits, and no sign before what is 0 then.
std::string digits(double part) {
  return fmt::format("{:.2f}", std::abs(part) < 0.005 ? 0.0 : part);
}
std::string digits(const VariancePart& part) {
  return fmt::format("{} ({} .. {})", digits(part.value), digits(part.low), digits(part.high));
}

}  // namespace

void SobolEstimate::Sums::add(const Sums& other, bool subtract) {
  const auto take = [&](ExactSum& sum, const ExactSum& own) {
    subtract ? sum.subtract(own) : sum.add(own);
  };
  rows = subtract ? rows - other.rows : rows + other.rows;
  take(both, other.both);
  take(squares, other.squares);
  for (std::size_t p = 0; p < changes.size(); ++p) {
    take(changes[p].sum, other.changes[p].sum);
    take(changes[p].products, other.changes[p].products);
    take(changes[p].squares, other.changes[p].squares);
  }
}

double SobolEstimate::Sums::variance() const {
  const double count = 2.0 * static_cast<double>(rows);
  return sum_about_means(count, both, both, squares) / count;
}

double SobolEstimate::Sums::first(std::size_t parameter) const {
  const auto count = static_cast<double>(rows);
  ExactSum products = changes[parameter].products;
  products.add_times(changes[parameter].sum, -both.value() / (2.0 * count));
  return products.value() / (count * variance());
}

double SobolEstimate::Sums::total(std::size_t parameter) const {
  return changes[parameter].squares.value() / (2.0 * static_cast<double>(rows) * variance());
}

SobolEstimate::SobolEstimate(const Sweep& sweep)
    : sweep_(&sweep),
      parameters_(sweep.varied.size()),
      row_(sweep.collected.size(), std::vector<double>(parameters_ + 2)),
      dropped_(sweep.collected.size()) {
  Sums none;
  none.changes.resize(parameters_);
  groups_.assign(sweep.collected.size(), std::vector<Sums>(kGroups, none));
}

void SobolEstimate::add(const SampleOutcome& outcome) {
  const std::size_t length = parameters_ + 2;
  const std::size_t place = outcome.id % length;
  for (std::size_t n = 0; n < row_.size(); ++n) row_[n][place] = outcome.numbers[n];
  if (place + 1 < length) return;
  for (std::size_t n = 0; n < row_.size(); ++n) end_row(n, outcome.id / length);
  ++rows_;
}

void SobolEstimate::add(const SobolEstimate& other) {
  rows_ += other.rows_;
  for (std::size_t n = 0; n < row_.size(); ++n) {
    for (std::size_t g = 0; g < kGroups; ++g) groups_[n][g].add(other.groups_[n][g]);
    dropped_[n] += other.dropped_[n];
  }
}

void SobolEstimate::end_row(std::size_t number, std::size_t row) {
  const std::vector<double>& f = row_[number];
  if (!std::all_of(f.begin(), f.end(), [](double one) { return std::isfinite(one); })) {
    ++dropped_[number];
    return;
  }
  const double a = f.front();
  const double b = f.back();
  Sums& group = groups_[number][row % kGroups];
  ++group.rows;
  for (const double one : {a, b}) {
    group.both.add(one);
    group.squares.add_product(one, one);
  }
  for (std::size_t p = 0; p < parameters_; ++p) {
    const double change = f[p + 1] - a;
    group.changes[p].sum.add(change);
    group.changes[p].products.add_product(b, change);
    group.changes[p].squares.add_product(change, change);
  }
}

SobolEstimate::Sums SobolEstimate::sum(std::size_t number) const {
  Sums all = groups_[number].front();
  for (std::size_t g = 1; g < kGroups; ++g) all.add(groups_[number][g]);
  return all;
}

bool SobolEstimate::varies(std::size_t number) const {
  const Sums all = sum(number);
  // Two rows a group at least: a jackknife needs them.
  if (all.rows < 2 * kGroups) return false;
  const double mean = all.both.value() / (2.0 * static_cast<double>(all.rows));
  return all.variance() > 1e-24 * mean * mean;
}

SobolIndices SobolEstimate::indices(std::size_t number, std::size_t parameter) const {
  const Sums all = sum(number);
  const auto with_interval = [&](double (Sums::*index)(std::size_t) const) {
    double sum_of_estimates = 0.0;
    std::vector<double> estimates;
    for (const Sums& group : groups_[number]) {
      Sums others = all;
      others.add(group, true);
      estimates.push_back((others.*index)(parameter));
      sum_of_estimates += estimates.back();
    }
    const double mean = sum_of_estimates / static_cast<double>(kGroups);
    double squares = 0.0;
    for (const double one : estimates) squares += (one - mean) * (one - mean);
    constexpr double kAll = kGroups;
    const double half = kStudent * std::sqrt((kAll - 1.0) / kAll * squares);
    const double value = (all.*index)(parameter);
    return VariancePart{value, value - half, value + half};
  };
  return {with_interval(&Sums::first), with_interval(&Sums::total)};
}

std::string SobolEstimate::text() const {
  // An index that is known less well ranks nothing.
  constexpr double kWide = 0.1;
  std::string text =
      "  parts of the variance (Sobol' indices, 95 % intervals), by the total one:\n";
  bool wide = false;
  for (std::size_t n = 0; n < row_.size(); ++n) {
    text += "  " + base::printable(sweep_->collected[n].name) + ": ";
    if (!varies(n)) {
      text += "does not vary, or in fewer than 128 rows\n";
      continue;
    }
    std::vector<SobolIndices> all;
    for (std::size_t p = 0; p < parameters_; ++p) all.push_back(indices(n, p));
    std::vector<std::size_t> order(parameters_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return all[a].total.value > all[b].total.value;
    });
    for (const std::size_t p : order) {
      const auto& [first, total] = all[p];
      text += fmt::format("{}{} {}, alone {}", p == order.front() ? "" : "; ",
                          base::printable(sweep_->varied[p].name), digits(total), digits(first));
      wide = wide || total.high - total.low > 2.0 * kWide || first.high - first.low > 2.0 * kWide;
    }
    if (dropped_[n] > 0) {
      text += fmt::format("; left out {} of {} rows, where a sample has no such number",
                          dropped_[n], rows_);
    }
    text += "\n";
  }
  if (wide) text += "  some of these are known to no better than 0.1: more samples narrow them\n";
  return text;
}

std::string SobolEstimate::csv() const {
  std::string text = fmt::format(
      "# slipbench {}\n# sweep: {}\n# Sobol' indices with 95 % intervals, from {} rows\n"
      "number,parameter,first,first_low,first_high,total,total_low,total_high\n",
      results::program_version(), base::in_cells(file_name(*sweep_)), rows_);
  for (std::size_t n = 0; n < row_.size(); ++n) {
    if (!varies(n)) continue;
    for (std::size_t p = 0; p < parameters_; ++p) {
      const auto [first, total] = indices(n, p);
      text += sweep_->collected[n].name + "," + sweep_->varied[p].name;
      for (const VariancePart& part : {first, total}) {
        for (const double number : {part.value, part.low, part.high}) {
          text += ",";
          base::append_number(text, number);
        }
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace slipbench::driver::sweep
