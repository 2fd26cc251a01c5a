// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/ascending.hpp"

#include <cmath>

#include "driver/check/curves/branches.hpp"

namespace slipbench::driver::check {
namespace {

/// Empty if the abscissa turns. Turns that are rounding are flattened.
AscendingCurve ascending(const Series& curve, double noise) {
  const std::vector<Branch> pieces = branches(curve.abscissa, noise);
  if (pieces.size() != 1) return {};
  AscendingCurve out{curve.abscissa, curve.value};
  if (pieces.front().direction < 0) {
    std::reverse(out.at.begin(), out.at.end());
    std::reverse(out.value.begin(), out.value.end());
  }
  for (std::size_t i = 1; i < out.at.size(); ++i) out.at[i] = std::max(out.at[i], out.at[i - 1]);
  return out;
}

std::string turns(const char* whose) {
  return std::string("the abscissa of the ") + whose +
         " goes back and forth; compare over time, or loops by arc_length or loop_energy";
}

}  // namespace

AscendingCurves ascending_curves(const Series& result, const Series& reference) {
  AscendingCurves out;
  const CommonRange range = common_range(result, reference);
  if (!range.fault.empty()) {
    out.fault = range.fault;
    return out;
  }
  const double noise = common_noise(result, reference);
  if (branches(result.abscissa, noise).size() != 1) {
    out.fault = turns("result");
    return out;
  }
  if (branches(reference.abscissa, noise).size() != 1) {
    out.fault = turns("reference");
    return out;
  }
  if (range.interval.width() <= range.slack) {
    out.fault = "the abscissas of the curves have no more than a point in common";
    return out;
  }
  out.interval = range.interval;
  for (const double x : reference.abscissa) {
    if (x >= range.interval.from - range.slack && x <= range.interval.to + range.slack) {
      ++out.compared;
    }
  }
  out.result = ascending(cut(result, range.interval, range.slack), noise);
  out.reference = ascending(cut(reference, range.interval, range.slack), noise);
  if (out.result.at.empty() || out.reference.at.empty()) {
    out.fault = "the abscissas of the curves go back and forth by rounding in their common range";
  }
  return out;
}

std::vector<double> cell_means(const AscendingCurve& curve, const Interval& interval,
                               std::size_t n) {
  std::vector<double> means(n, 0.0);
  const double width = interval.width() / static_cast<double>(n);
  AscendingReader read(curve);
  double from = interval.from;
  for (std::size_t cell = 0; cell < n; ++cell) {
    const double begin = from;
    const double end =
        cell + 1 == n ? interval.to : interval.from + static_cast<double>(cell + 1) * width;
    double sum = 0.0;
    while (from < end) {
      read.advance(from);
      const double to = read.next() > from ? std::min(end, read.next()) : end;
      sum += 0.5 * (read(from) + read(to)) * (to - from);
      from = to;
    }
    means[cell] = end > begin ? sum / (end - begin) : read(end);
  }
  return means;
}

}  // namespace slipbench::driver::check
