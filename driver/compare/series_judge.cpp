// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/series_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "driver/compare/criteria.hpp"
#include "driver/compare/criteria/pointwise.hpp"
#include "driver/compare/curve_series.hpp"
#include "driver/compare/likely_cause.hpp"
#include "driver/compare/tolerance_doubts.hpp"
#include "driver/compare/verdict_message.hpp"

namespace slipbench::driver {
namespace {

/// What is doubtful about a tolerance. A curve that agrees far better than its digits allow is one
/// of round numbers: their digits are all there.
std::vector<std::string> doubts(const Tolerance& tolerance, double scale, double worst,
                                std::optional<double> resolution, const std::string& unit) {
  constexpr double kFarBetter = 1e-2;
  if (resolution && worst < kFarBetter * *resolution) resolution.reset();
  return tolerance_doubts(tolerance,
                          {.scale = scale, .worst = worst, .resolution = resolution, .unit = unit});
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

void judge_points(const Check& check, const CheckLabels& labels, const ComparedRows& rows,
                  const Series& reference, std::optional<double> resolution, Verdict& verdict) {
  const PointwiseComparison comparison = compare_points(rows.value, reference);
  verdict.message = comparison.fault;
  if (!verdict.message.empty()) return;
  PointJudge judge(check.tolerance);
  for (const CurvePoint& point : comparison.points) judge.add(point, status_at(rows, point.time));
  conclude(check, labels, judge, resolution, verdict);
}

void judge_measures(const Check& check, const CheckLabels& labels, const ComparedRows& rows,
                    const Series& reference, std::optional<double> resolution, Verdict& verdict) {
  CurveComparison comparison = compare(check.criterion, rows.value, reference, check.tolerance);
  verdict.message = std::move(comparison.fault);
  verdict.compared = comparison.compared;
  verdict.measures = std::move(comparison.measures);
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
  if (verdict.failing > 0) verdict.message = measures_message(verdict, labels);
  const std::optional<double> printed =
      worst->unit == MeasureUnit::kQuantity ? resolution : std::nullopt;
  if (worst->unit != MeasureUnit::kAbscissa) {
    verdict.warnings =
        doubts(check.tolerance, worst->scale, worst->deviation, printed, unit_of(*worst, verdict));
  }
}

}  // namespace

Series reference_of(const ComparedRows& rows) {
  return {rows.value.abscissa, rows.reference, rows.value.time};
}

void conclude(const Check& check, const CheckLabels& labels, const PointJudge& judge,
              std::optional<double> resolution, Verdict& verdict) {
  const PointJudge::Result result = judge.result();
  verdict.compared = judge.count();
  verdict.failing = result.failing;
  verdict.tolerance = result.tolerance;
  verdict.scale = result.scale;
  verdict.worst = {result.worst.time, result.worst.value, result.worst.reference,
                   result.worst.abscissa};
  if (result.first && std::isfinite(result.first->time)) {
    verdict.first_failing = result.first->time;
    verdict.last_failing = result.last->time;
  }
  if (result.failing > 0) {
    verdict.message = points_message(check, result, verdict.compared, labels);
    verdict.likely_cause = likely_cause(judge.sample(), {.tolerance = result.tolerance,
                                                         .unit = labels.unit,
                                                         .over_time = !check.abscissa,
                                                         .time_unit = labels.time_unit});
    if (!verdict.likely_cause.empty()) verdict.message += "; " + verdict.likely_cause;
  }
  verdict.warnings =
      doubts(check.tolerance, result.scale, verdict.worst.size(), resolution, labels.unit);
}

void judge_rows(const Check& check, const CheckLabels& labels, const ComparedRows& rows,
                Verdict& verdict) {
  std::optional<double> resolution;
  bool golden = false;
  Series reference;
  if (std::holds_alternative<CurveReference>(check.against)) {
    auto read = reference_curve(check, rows.value);
    if (!read) {
      verdict.message = std::move(read.error());
      return;
    }
    reference = std::move(read->series);
    resolution = read->resolution;
    golden = read->golden;
  } else {
    reference = reference_of(rows);
  }
  if (check.criterion == Criterion::kPointwise) {
    judge_points(check, labels, rows, reference, resolution, verdict);
  } else {
    judge_measures(check, labels, rows, reference, resolution, verdict);
  }
  // A program agrees with its own past to the last digit: that says nothing of the tolerance.
  if (golden) verdict.warnings.clear();
}

}  // namespace slipbench::driver
