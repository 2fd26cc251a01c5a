// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/common_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "driver/check/curves/interpolation.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {
namespace {

std::string not_finite(std::string_view name, std::string_view what, std::size_t row) {
  return fmt::format("{} of the {} is not a finite number in row {}", what, name, row + 1);
}

/// Numbers are taken so many at a time: the compiler must not reorder a single chain of them.
constexpr std::size_t kLanes = 8;

bool all_finite(std::span<const double> numbers) {
  std::array<double, kLanes> zeros{};
  std::size_t i = 0;
  for (; i + kLanes <= numbers.size(); i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) zeros[k] += 0.0 * numbers[i + k];
  }
  for (; i < numbers.size(); ++i) zeros[0] += 0.0 * numbers[i];
  return std::none_of(zeros.begin(), zeros.end(), [](double zero) { return std::isnan(zero); });
}

/// Returns why nothing can be compared with a curve; empty if something can.
std::string unusable(const Series& curve, std::string_view name) {
  const std::size_t rows = curve.value.size();
  if (curve.abscissa.size() != rows || (!curve.time.empty() && curve.time.size() != rows)) {
    return fmt::format("the {} has {} values, but {} abscissas", name, rows, curve.abscissa.size());
  }
  if (rows == 0) return fmt::format("the {} has no rows", name);
  if (all_finite(curve.abscissa) && all_finite(curve.value)) return {};
  for (std::size_t i = 0; i < rows; ++i) {
    if (!std::isfinite(curve.abscissa[i])) return not_finite(name, "the abscissa", i);
    if (!std::isfinite(curve.value[i])) return not_finite(name, "the value", i);
  }
  return {};
}

std::string in_words(const Interval& range, std::string_view name) {
  if (range.from == range.to) return fmt::format("the {} is at {:.9g} only", name, range.from);
  return fmt::format("the {} goes from {:.9g} to {:.9g}", name, range.from, range.to);
}

}  // namespace

Interval extent(std::span<const double> numbers) {
  std::array<double, kLanes> low{};
  std::array<double, kLanes> high{};
  low.fill(numbers.front());
  high.fill(numbers.front());
  std::size_t i = 0;
  for (; i + kLanes <= numbers.size(); i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double x = numbers[i + k];
      low[k] = x < low[k] ? x : low[k];
      high[k] = x > high[k] ? x : high[k];
    }
  }
  for (; i < numbers.size(); ++i) {
    low[0] = std::min(low[0], numbers[i]);
    high[0] = std::max(high[0], numbers[i]);
  }
  Interval found{*std::min_element(low.begin(), low.end()),
                 *std::max_element(high.begin(), high.end())};
  // Of 0 and -0, which are the same number, the lowest is the first and the highest the last.
  if (found.from == 0.0) found.from = *std::find(numbers.begin(), numbers.end(), 0.0);
  if (found.to == 0.0) found.to = *std::find(numbers.rbegin(), numbers.rend(), 0.0);
  return found;
}

bool are_same_rows(const Series& result, const Series& reference) {
  return !result.time.empty() && result.time == reference.time &&
         result.abscissa == reference.abscissa;
}

CommonRange common_range(const Series& result, const Series& reference) {
  CommonRange common;
  common.fault = unusable(result, "result");
  if (common.fault.empty()) common.fault = unusable(reference, "reference");
  if (!common.fault.empty()) return common;
  // A result may be as far off as it likes; what it is measured by must be a number.
  if (!std::isfinite(extent(reference.value).width()) ||
      !std::isfinite(extent(reference.abscissa).width())) {
    common.fault = "the range of the reference exceeds that of a double";
    return common;
  }
  const Interval ours = extent(result.abscissa);
  const Interval theirs = extent(reference.abscissa);
  common.slack = history::kSameTime * std::max({std::abs(ours.from), std::abs(ours.to),
                                                std::abs(theirs.from), std::abs(theirs.to)});
  common.interval = {std::max(ours.from, theirs.from), std::min(ours.to, theirs.to)};
  const std::string ranges = fmt::format("over the abscissa {}, {}", in_words(ours, "result"),
                                         in_words(theirs, "reference"));
  if (common.interval.width() < -common.slack) {
    common.fault = "no common range: " + ranges;
  } else if (common.interval.width() <= common.slack &&
             (theirs.width() > common.slack || result.size() > 1) &&
             !are_same_rows(result, reference)) {
    common.fault = "only one point in common: " + ranges;
  }
  if (common.interval.width() < 0.0) common.interval.to = common.interval.from;
  return common;
}

Series cut(const Series& curve, const Interval& interval, double slack) {
  Series part;
  part.noise = curve.noise;
  const std::array<double, 2> ends{interval.from, interval.to};
  const std::size_t count = interval.width() > slack ? 2 : 1;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = curve.abscissa[i];
    if (i > 0) {
      const double before = curve.abscissa[i - 1];
      for (std::size_t k = 0; k < count; ++k) {
        const double end = ends[x > before ? k : count - 1 - k];
        if (std::min(x, before) < end - slack && std::max(x, before) > end + slack) {
          append_between(part, curve, i - 1, (end - before) / (x - before));
        }
      }
    }
    if (x >= interval.from - slack && x <= interval.to + slack) append_between(part, curve, i, 0.0);
  }
  return part;
}

}  // namespace slipbench::driver::check
