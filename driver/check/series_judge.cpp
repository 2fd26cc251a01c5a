// SPDX-License-Identifier: Apache-2.0
#include "driver/check/series_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "driver/check/criteria/criteria.hpp"
#include "driver/check/criteria/likely_cause.hpp"
#include "driver/check/criteria/pointwise.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/check/curves/curve_series.hpp"
#include "driver/check/tolerance_doubts.hpp"
#include "driver/check/verdict_message.hpp"

namespace slipbench::driver::check {
namespace {

/// Adds what is doubtful about a tolerance. A program may agree with its own past to the last
/// digit, and that says nothing of the tolerance.
void doubt(const cases::Tolerance& tolerance, const ToleranceUse& use, bool golden,
           Verdict& verdict) {
  // Met but for rounding, which another machine may do otherwise: as it was blessed.
  constexpr double kRounding = 1e-9;
  if (golden && use.worst <= kRounding * use.scale) return;
  for (std::string& doubt : tolerance_doubts(tolerance, use)) {
    verdict.warnings.push_back(std::move(doubt));
  }
}

/// Rows that the check picks from the run are on purpose no more than a part of the reference, but
/// of them the reference should cover most.
void doubt_coverage(const cases::Check& check, const ComparedRows& rows, const Series& reference,
                    std::int64_t compared, Verdict& verdict) {
  const bool is_part = check.step || (check.abscissa && (check.from || check.to));
  std::string doubt = is_part ? range_doubt(rows.value, reference)
                              : coverage_doubt(rows.value, reference, compared);
  if (!doubt.empty()) verdict.warnings.push_back(std::move(doubt));
}

/// The status at a total time: that of the increment which leads there.
int status_at(const ComparedRows& rows, double time) {
  if (rows.status.empty() || std::isnan(time)) return -1;
  const std::vector<double>& times = rows.value.time;
  const auto row = std::lower_bound(times.begin(), times.end(), time);
  const auto index =
      std::min<std::ptrdiff_t>(row - times.begin(), static_cast<std::ptrdiff_t>(times.size()) - 1);
  return rows.status[static_cast<std::size_t>(index)];
}

void judge_points(const cases::Check& check, const CheckLabels& labels, const ComparedRows& rows,
                  const ReferenceCurve& reference, Verdict& verdict) {
  std::optional<double> resolution = reference.resolution;
  PointJudge judge(check.tolerance);
  std::vector<CurvePoint> points;
  verdict.message = each_point(rows.value, reference.series, [&](const CurvePoint& point) {
    judge.add(point, -1);
    if (resolution) points.push_back(point);
  });
  if (!verdict.message.empty()) return;
  if (resolution && has_all_digits(points, *resolution)) resolution.reset();
  conclude(check, labels, judge, {resolution, reference.golden}, verdict, &rows);
  doubt_coverage(check, rows, reference.series, judge.count(), verdict);
}

/// A measure that is no number, or relative to none, is that of numbers near the largest double.
std::string beyond_doubles(const std::vector<Measure>& measures) {
  for (const Measure& measure : measures) {
    if (std::isfinite(measure.value) && std::isfinite(measure.reference) &&
        std::isfinite(measure.scale)) {
      continue;
    }
    return "the numbers are too large: " + measure.name + " exceeds the range of a double";
  }
  return {};
}

/// The measure that tells whether the tolerance is a good one: the worst of those that it bounds.
/// The number of reversals has none.
const Measure* worst_doubted(const Verdict& verdict) {
  Verdict bounded;
  std::vector<const Measure*> origins;
  for (const Measure& measure : verdict.measures) {
    if (!(measure.tolerance > 0.0)) continue;
    bounded.measures.push_back(measure);
    origins.push_back(&measure);
  }
  const Measure* worst = worst_measure(bounded);
  return worst == nullptr ? nullptr
                          : origins[static_cast<std::size_t>(worst - bounded.measures.data())];
}

/// Distances and errors without a unit have a size beyond which nothing is alike.
std::string dimensionless_doubt(const cases::Check& check, const Measure& measure) {
  const std::string_view one = info_of(check.criterion).one;
  if (one.empty() || measure.tolerance < 1.0) return {};
  return fmt::format("the tolerance of {:.3g} has no unit, and 1 is already {}", measure.tolerance,
                     one);
}

/// A tolerance of positions as wide as the reference lets every position pass.
void doubt_positions(const Series& reference, Verdict& verdict) {
  const double width = extent(reference.abscissa).width();
  for (const Measure& measure : verdict.measures) {
    if (measure.unit != MeasureUnit::kAbscissa || !std::isfinite(measure.tolerance) ||
        measure.tolerance < width) {
      continue;
    }
    verdict.warnings.push_back(
        fmt::format("the tolerance of {:.3g} for the {} is as wide as the reference itself, {:.3g}",
                    measure.tolerance, measure.name, width));
    return;
  }
}

void doubt_measures(const cases::Check& check, const ReferenceCurve& reference, Verdict& verdict) {
  const Measure* worst = worst_doubted(verdict);
  if (worst == nullptr || worst->unit == MeasureUnit::kAbscissa) return;
  std::string doubted = dimensionless_doubt(check, *worst);
  if (!doubted.empty()) return verdict.warnings.push_back(std::move(doubted));
  std::optional<double> resolution;
  if (worst->unit == MeasureUnit::kQuantity) resolution = reference.resolution;
  // One number has all its digits only if it agrees far better than they tell.
  const CurvePoint only{.value = worst->value, .reference = worst->reference};
  if (resolution && has_all_digits({&only, 1}, *resolution)) resolution.reset();
  doubt(check.tolerance,
        {.scale = worst->scale,
         .worst = worst->deviation,
         .resolution = resolution,
         .unit = unit_of(*worst, verdict)},
        reference.golden, verdict);
}

std::int64_t rows_in_common(const Series& result, const Series& reference) {
  const CommonRange common = common_range(result, reference);
  return std::count_if(reference.abscissa.begin(), reference.abscissa.end(), [&](double x) {
    return x >= common.interval.from - common.slack && x <= common.interval.to + common.slack;
  });
}

/// Returns why a curve cannot be compared by measures of it, in a sentence, or nothing.
std::string unfit(const cases::Check& check, const Series& result, const Series& reference) {
  if (!check.abscissa && !std::is_sorted(reference.abscissa.begin(), reference.abscissa.end())) {
    return "the times of the reference fall";
  }
  if (result.size() > 1 && reference.size() > 1 && rows_in_common(result, reference) < 2) {
    return "fewer than two rows of the reference are in the range of the result";
  }
  return {};
}

void judge_measures(const cases::Check& check, const CheckLabels& labels, const ComparedRows& rows,
                    const ReferenceCurve& reference, Verdict& verdict) {
  if (std::holds_alternative<cases::CurveReference>(check.against)) {
    verdict.message = unfit(check, rows.value, reference.series);
    if (!verdict.message.empty()) return;
  }
  CurveComparison comparison =
      compare(check.criterion, rows.value, reference.series, check.tolerance);
  verdict.message = std::move(comparison.fault);
  verdict.compared = comparison.compared;
  verdict.measures = std::move(comparison.measures);
  if (verdict.message.empty()) verdict.message = beyond_doubles(verdict.measures);
  if (!verdict.message.empty()) return;
  const Measure* worst = worst_measure(verdict);
  if (worst == nullptr) {
    verdict.message = "the tolerance bounds nothing of what this criterion measures";
    return;
  }
  verdict.tolerance = worst->tolerance;
  verdict.scale = worst->scale;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  verdict.worst = worst->where ? Deviation{worst->where->time, worst->where->value,
                                           worst->where->reference, worst->where->abscissa}
                               : Deviation{unknown, worst->value, worst->reference, unknown};
  verdict.failing = std::count_if(verdict.measures.begin(), verdict.measures.end(),
                                  [](const Measure& measure) { return !measure.passed(); });
  if (verdict.failing > 0) verdict.message = measures_message(verdict, labels, rows.value);
  doubt_positions(reference.series, verdict);
  doubt_measures(check, reference, verdict);
  doubt_coverage(check, rows, reference.series, rows_in_common(rows.value, reference.series),
                 verdict);
}

}  // namespace

Series reference_of(const ComparedRows& rows) {
  return {rows.value.abscissa, rows.reference, rows.value.time};
}

void conclude(const cases::Check& check, const CheckLabels& labels, const PointJudge& judge,
              const ReferenceDigits& digits, Verdict& verdict, const ComparedRows* rows) {
  const PointJudge::Result result = judge.result();
  verdict.compared = judge.count();
  verdict.scale = result.scale;
  const CurvePoint& worst = result.worst.point;
  verdict.worst = {worst.time, worst.value, worst.reference, worst.abscissa};
  if (!std::isfinite(result.scale)) {
    verdict.message = "the range of the reference exceeds that of a double";
    return;
  }
  verdict.failing = result.failing;
  verdict.tolerance = result.tolerance;
  if (result.first && std::isfinite(result.first->time)) {
    verdict.first_failing = result.first->time;
    verdict.last_failing = result.last->time;
  }
  if (result.failing > 0) {
    verdict.message = points_message(check, result, verdict.compared, labels);
    std::vector<CausePoint> sample = judge.sample();
    if (rows != nullptr) {
      for (CausePoint& one : sample) one.status = status_at(*rows, one.point.time);
    }
    verdict.likely_cause =
        likely_cause(sample, {.tolerance = result.tolerance,
                              .unit = labels.unit,
                              .over_time = !check.abscissa,
                              .time_unit = labels.time_unit,
                              .stiffness_follows_limit = labels.stiffness_follows_limit});
    if (!verdict.likely_cause.empty()) verdict.message += "; " + verdict.likely_cause;
  }
  doubt(check.tolerance,
        {.scale = result.scale,
         .worst = verdict.worst.size(),
         .largest = digits.golden ? std::nullopt : std::optional(result.largest),
         .resolution = digits.resolution,
         .unit = labels.unit},
        digits.golden, verdict);
}

void judge_rows(const cases::Check& check, const CheckLabels& labels, const ComparedRows& rows,
                Verdict& verdict) {
  ReferenceCurve reference;
  if (std::holds_alternative<cases::CurveReference>(check.against)) {
    auto read = reference_curve(check, rows.value);
    if (!read) {
      verdict.message = std::move(read.error());
      return;
    }
    reference = std::move(*read);
  } else {
    reference.series = reference_of(rows);
  }
  if (check.criterion == cases::Criterion::kPointwise) {
    judge_points(check, labels, rows, reference, verdict);
  } else {
    judge_measures(check, labels, rows, reference, verdict);
  }
}

}  // namespace slipbench::driver::check
