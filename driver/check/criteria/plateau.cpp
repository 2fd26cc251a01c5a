// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/plateau.hpp"

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/criteria/integral.hpp"
#include "driver/check/curves/common_range.hpp"

namespace slipbench::driver::check {

CurveComparison compare_plateau(const Series& result, const Series& reference,
                                const cases::Tolerance& tolerance) {
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return incomparable(common.fault);
  if (common.interval.width() <= common.slack) {
    return incomparable("a single point of the abscissa has no plateau");
  }
  const Series ours = cut(result, common.interval, common.slack);
  const Series theirs = cut(reference, common.interval, common.slack);
  Measure mean = judged("mean", MeasureUnit::kQuantity, integral_over_way(ours) / way(ours),
                        integral_over_way(theirs) / way(theirs));
  mean.scale = scale_of(theirs.value);
  mean.tolerance = value_bound(tolerance, mean.scale);
  return compared(theirs.size(), {std::move(mean)});
}

}  // namespace slipbench::driver::check
