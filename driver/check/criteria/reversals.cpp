// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/reversals.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"

namespace slipbench::driver::check {

CurveComparison compare_reversals(const Series& result, const Series& reference,
                                  const cases::Tolerance& tolerance) {
  const CommonRange common = common_range(result, reference);
  if (!common.fault.empty()) return incomparable(common.fault);
  const double noise = common_noise(result, reference);
  const std::vector<Branch> ours = branches(result.abscissa, noise);
  const std::vector<Branch> theirs = branches(reference.abscissa, noise);
  const std::size_t count = theirs.size() - 1;
  if (count == 0) return incomparable("the abscissa of the reference never turns");
  CurveComparison comparison;
  comparison.compared = static_cast<std::int64_t>(count);
  Measure number = judged("number of reversals", MeasureUnit::kNone,
                          static_cast<double>(ours.size() - 1), static_cast<double>(count));
  number.scale = static_cast<double>(count);
  comparison.measures.push_back(std::move(number));
  // Of different numbers, it is unknown which one belongs to which.
  if (ours.size() != theirs.size()) return comparison;
  const double positions = scale_of(reference.abscissa);
  const double values = scale_of(reference.value);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = ours[i].last;
    const std::size_t reference_row = theirs[i].last;
    CurvePoint where{.abscissa = result.abscissa[row],
                     .value = result.value[row],
                     .reference = reference.value[reference_row]};
    if (!result.time.empty()) where.time = result.time[row];
    Measure position = judged(fmt::format("position of reversal {}", i + 1), MeasureUnit::kAbscissa,
                              where.abscissa, reference.abscissa[reference_row]);
    position.scale = positions;
    position.tolerance = position_bound(tolerance, positions);
    position.where = where;
    Measure value = judged(fmt::format("value at reversal {}", i + 1), MeasureUnit::kQuantity,
                           where.value, where.reference);
    value.scale = values;
    value.tolerance = value_bound(tolerance, values);
    value.where = where;
    comparison.measures.push_back(std::move(position));
    comparison.measures.push_back(std::move(value));
  }
  return comparison;
}

}  // namespace slipbench::driver::check
