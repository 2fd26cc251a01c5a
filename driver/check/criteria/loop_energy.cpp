// SPDX-License-Identifier: Apache-2.0
#include "driver/check/criteria/loop_energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "driver/check/criteria/bounds.hpp"
#include "driver/check/criteria/integral.hpp"
#include "driver/check/curves/branches.hpp"
#include "driver/check/curves/common_range.hpp"

namespace slipbench::driver::check {
namespace {

/// A loop whose ends are further apart than this part of its longer branch is not whole.
constexpr double kOpenLoop = 0.25;
/// Mean gaps that differ by less than this are equal.
constexpr double kSameGap = 1e-6;
/// Below this part of range x range, a loop has no energy to be relative to.
constexpr double kNoEnergy = 1e-9;

/// The rows of the start, of the reversals and of the end.
std::vector<std::size_t> turning_rows(const std::vector<Branch>& parts) {
  std::vector<std::size_t> rows{parts.front().first};
  for (const Branch& part : parts) rows.push_back(part.last);
  return rows;
}

/// Returns how far the loop from turning point `p` to p + 2 is from closed, as a part of its longer
/// branch; at most kOpenLoop, whatever is beyond.
double gap(const Series& curve, const std::vector<std::size_t>& turns, std::size_t p) {
  const auto x = [&](std::size_t i) { return curve.abscissa[turns[i]]; };
  const double there = std::abs(x(p + 1) - x(p));
  const double back = std::abs(x(p + 2) - x(p + 1));
  const double width = std::max(there, back);
  return std::min(std::abs(there - back) / width, kOpenLoop);
}

double mean_gap(const Series& curve, const std::vector<std::size_t>& turns, std::size_t begin) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t p = begin; p + 2 < turns.size(); p += 2, ++count) sum += gap(curve, turns, p);
  return count == 0 ? kOpenLoop : sum / static_cast<double>(count);
}

/// The turning points where a whole loop begins.
std::vector<std::size_t> whole_loops(const Series& curve, const std::vector<std::size_t>& turns) {
  const std::size_t begin =
      mean_gap(curve, turns, 1) < mean_gap(curve, turns, 0) - kSameGap ? 1 : 0;
  std::vector<std::size_t> loops;
  for (std::size_t p = begin; p + 2 < turns.size(); p += 2) {
    if (gap(curve, turns, p) < kOpenLoop) loops.push_back(p);
  }
  return loops;
}

/// Energies smaller than this are rounding, or second order of an elastic curve: range x range.
double product_of_ranges(const Series& curve, std::size_t first, std::size_t last) {
  const std::size_t count = last - first + 1;
  return extent(std::span<const double>(curve.abscissa).subspan(first, count)).width() *
         extent(std::span<const double>(curve.value).subspan(first, count)).width();
}

}  // namespace

CurveComparison compare_loop_energy(const Series& result, const Series& reference,
                                    const cases::Tolerance& tolerance) {
  const MatchedBranches matched = match_branches(result, reference);
  if (!matched.fault.empty()) return incomparable(matched.fault);
  const Series& ours = matched.result;
  const Series& theirs = matched.reference;
  if (way(theirs) == 0.0) return incomparable("a single point of the abscissa has no energy");
  const std::vector<std::size_t> turns = turning_rows(matched.result_branches);
  const std::vector<std::size_t> reference_turns = turning_rows(matched.reference_branches);
  const std::vector<std::size_t> loops = whole_loops(theirs, reference_turns);

  CurveComparison comparison;
  comparison.compared = static_cast<std::int64_t>(theirs.size());
  const auto energy = [&](std::string name, std::size_t from, std::size_t to) {
    const std::size_t first = reference_turns[from];
    const std::size_t last = reference_turns[to];
    Measure measure = judged(std::move(name), MeasureUnit::kProduct,
                             work(ours, turns[from], turns[to]), work(theirs, first, last));
    const double ranges = product_of_ranges(theirs, first, last);
    const double magnitude = std::abs(measure.reference);
    measure.scale = magnitude > kNoEnergy * ranges ? magnitude : ranges;
    measure.tolerance = value_bound(tolerance, measure.scale);
    return measure;
  };
  if (loops.empty()) {
    comparison.measures.push_back(
        energy("energy over the whole range (no whole loop)", 0, reference_turns.size() - 1));
    return comparison;
  }
  Measure total =
      judged(fmt::format("energy of all {} loops", loops.size()), MeasureUnit::kProduct, 0.0, 0.0);
  for (const std::size_t p : loops) {
    Measure loop =
        energy(fmt::format("energy of loop {}", comparison.measures.size() + 1), p, p + 2);
    const std::size_t row = turns[p];
    loop.where = CurvePoint{.abscissa = ours.abscissa[row],
                            .value = ours.value[row],
                            .reference = theirs.value[reference_turns[p]]};
    if (!ours.time.empty()) loop.where->time = ours.time[row];
    total.value += loop.value;
    total.reference += loop.reference;
    total.scale += loop.scale;
    comparison.measures.push_back(std::move(loop));
  }
  if (loops.size() > 1) {
    total.deviation = std::abs(total.value - total.reference);
    total.tolerance = value_bound(tolerance, total.scale);
    comparison.measures.push_back(std::move(total));
  }
  return comparison;
}

}  // namespace slipbench::driver::check
