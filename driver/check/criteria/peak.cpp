// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/peak.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/curves/common_range.hpp"

namespace slipbench::driver::check {
namespace {

/// The row of the largest value, or with sign -1 of the smallest; the first of several.
std::size_t peak_row(const Series& curve, double sign) {
  const auto found = std::max_element(curve.value.begin(), curve.value.end(),
                                      [sign](double a, double b) { return sign * a < sign * b; });
  return static_cast<std::size_t>(found - curve.value.begin());
}

}  // namespace

CurveComparison compare_peak(const Series& result, const Series& reference,
                             const cases::Tolerance& tolerance) {
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return incomparable(common.fault);
  const Series ours = cut(result, common.interval, common.slack);
  const Series theirs = cut(reference, common.interval, common.slack);
  CurveComparison comparison;
  comparison.compared = static_cast<std::int64_t>(theirs.size());
  for (const auto& [name, sign] :
       {std::pair{"largest value", 1.0}, std::pair{"smallest value", -1.0}}) {
    const std::size_t row = peak_row(ours, sign);
    Measure peak =
        judged(name, MeasureUnit::kQuantity, ours.value[row], theirs.value[peak_row(theirs, sign)]);
    peak.scale = scale_of(theirs.value);
    peak.tolerance = value_bound(tolerance, peak.scale);
    peak.where = CurvePoint{
        .abscissa = ours.abscissa[row], .value = peak.value, .reference = peak.reference};
    if (!ours.time.empty()) peak.where->time = ours.time[row];
    comparison.measures.push_back(std::move(peak));
  }
  return comparison;
}

}  // namespace slipbench::driver::check
