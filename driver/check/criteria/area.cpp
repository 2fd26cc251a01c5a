// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/area.hpp"

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/criteria/integral.hpp"
#include "driver/check/curves/branches.hpp"

namespace slipbench::driver::check {

CurveComparison compare_area(const Series& result, const Series& reference,
                             const cases::Tolerance& tolerance) {
  const MatchedBranches matched = match_branches(result, reference);
  if (!matched.fault.empty()) return incomparable(matched.fault);
  const Series& ours = matched.result;
  const Series& theirs = matched.reference;
  if (way(theirs) == 0.0) {
    return incomparable("a single point of the abscissa has no area");
  }
  Measure area = judged("area", MeasureUnit::kProduct, work(ours, 0, ours.size() - 1),
                        work(theirs, 0, theirs.size() - 1));
  area.scale = magnitude_integral(theirs);
  area.tolerance = value_bound(tolerance, area.scale);
  return compared(theirs.size(), {std::move(area)});
}

}  // namespace slipbench::driver::check
