// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/sobol_indices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

void take(ExactSum& sum, const ExactSum& own, bool subtract) {
  subtract ? sum.subtract(own) : sum.add(own);
}

/// Returns an index with the interval that its estimates without each of the groups give.
VariancePart with_interval(double value, const std::array<double, kGroups>& estimates) {
  constexpr double kAll = kGroups;
  const double mean = std::accumulate(estimates.begin(), estimates.end(), 0.0) / kAll;
  double squares = 0.0;
  for (const double one : estimates) squares += (one - mean) * (one - mean);
  const double half = kStudent * std::sqrt((kAll - 1.0) / kAll * squares);
  return {value, value - half, value + half};
}

/// With two digits, and no sign before what is 0 then.
std::string digits(double part) {
  return fmt::format("{:.2f}", std::abs(part) < 0.005 ? 0.0 : part);
}
std::string digits(const VariancePart& part) {
  return fmt::format("{} ({} .. {})", digits(part.value), digits(part.low), digits(part.high));
}

}  // namespace

void SobolEstimate::Sums::Change::add(const Change& other, bool subtract) {
  take(sum, other.sum, subtract);
  take(products, other.products, subtract);
  take(squares, other.squares, subtract);
}

void SobolEstimate::Sums::add(const Sums& other, bool subtract) {
  rows = subtract ? rows - other.rows : rows + other.rows;
  take(both, other.both, subtract);
  take(squares, other.squares, subtract);
  for (std::size_t p = 0; p < changes.size(); ++p) changes[p].add(other.changes[p], subtract);
}

double SobolEstimate::Sums::variance() const {
  const double count = 2.0 * static_cast<double>(rows);
  return sum_about_means(count, both, both, squares) / count;
}

/// Parts of the indices that all parameters have in common, of some rows.
struct SobolEstimate::Basis {
  double rows = 0.0;
  double mean = 0.0;
  double variance = 0.0;

  explicit Basis(const Sums& sums)
      : rows(static_cast<double>(sums.rows)),
        mean(sums.both.value() / (2.0 * rows)),
        variance(sums.variance()) {}

  double first(const Sums::Change& change) const {
    ExactSum products = change.products;
    products.add_times(change.sum, -mean);
    return products.value() / (rows * variance);
  }
  double total(const Sums::Change& change) const {
    return change.squares.value() / (2.0 * rows * variance);
  }
};

SobolEstimate::SobolEstimate(const Sweep& sweep)
    : sweep_(&sweep),
      parameters_(sweep.varied.size()),
      row_(sweep.collected.size(), std::vector<double>(parameters_ + 2)),
      dropped_(sweep.collected.size()) {
  Sums none;
  none.changes.resize(parameters_);
  groups_.assign(sweep.collected.size(), std::vector<Sums>(kGroups, none));
}

std::size_t SobolEstimate::size(std::size_t parameters, std::size_t numbers) {
  return numbers * kGroups * (sizeof(Sums) + parameters * sizeof(Sums::Change));
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

std::vector<SobolIndices> SobolEstimate::indices(std::size_t number) const {
  const std::vector<Sums>& groups = groups_[number];
  const Sums all = sum(number);
  const Basis whole(all);
  std::vector<Basis> without;
  for (const Sums& group : groups) {
    Sums others{all.rows, all.both, all.squares, {}};
    others.add(group, true);
    without.emplace_back(others);
  }
  std::vector<SobolIndices> found;
  for (std::size_t p = 0; p < parameters_; ++p) {
    std::array<double, kGroups> first{};
    std::array<double, kGroups> total{};
    for (std::size_t g = 0; g < kGroups; ++g) {
      Sums::Change others = all.changes[p];
      others.add(groups[g].changes[p], true);
      first[g] = without[g].first(others);
      total[g] = without[g].total(others);
    }
    found.push_back({with_interval(whole.first(all.changes[p]), first),
                     with_interval(whole.total(all.changes[p]), total)});
  }
  return found;
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
    const std::vector<SobolIndices> all = indices(n);
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
    const std::vector<SobolIndices> all = indices(n);
    for (std::size_t p = 0; p < parameters_; ++p) {
      const auto& [first, total] = all[p];
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
