// SPDX-License-Identifier: Apache-2.0
#include "driver/report/thin_trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "driver/report/row_choice.hpp"

namespace slipbench::driver::report {
namespace {

constexpr std::size_t kPointsOfFailed = 10000;
constexpr std::size_t kPointsOfPassed = 1000;
/// Points of all checks of a case together, as long as each has those around its worst one.
constexpr std::size_t kPointsOfCase = 20000;
constexpr std::size_t kFewestPoints = 300;
/// Points on each side of the worst one that are never left out: RowChoice keeps so many wanted
/// ones.
constexpr std::size_t kNeighbours = 8;

/// The point nearest to the worst deviation: by its time where the series has times.
std::size_t nearest(const check::Series& series, const check::Deviation& worst) {
  const bool timed = series.time.size() == series.size() && std::isfinite(worst.time);
  const std::vector<double>& at = timed ? series.time : series.abscissa;
  const double wanted = timed ? worst.time : worst.abscissa;
  std::size_t best = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (std::abs(at[i] - wanted) < std::abs(at[best] - wanted)) best = i;
  }
  return best;
}

bool near_worst(std::size_t i, std::size_t worst) {
  return i + kNeighbours >= worst && i <= worst + kNeighbours;
}

/// The chosen points of a table whose first column is the abscissa, and those columns as curves.
template <std::size_t kColumns, class RowAt>
std::array<ReportCurve, kColumns - 1> chosen(std::size_t count, std::size_t limit,
                                             std::size_t worst, bool& thinned, RowAt row_at) {
  RowChoice choice(kColumns, limit, {});
  for (std::size_t i = 0; i < count; ++i) choice.add(row_at(i), near_worst(i, worst));
  const DrawnRows drawn = choice.finish();
  thinned = thinned || drawn.thinned;
  std::array<ReportCurve, kColumns - 1> curves;
  for (std::size_t c = 1; c < kColumns; ++c) {
    ReportCurve& curve = curves[c - 1];
    curve.index = drawn.rows.index;
    curve.piece = drawn.piece;
    for (std::size_t i = 0; i < drawn.rows.numbers.size(); i += kColumns) {
      curve.x.push_back(drawn.rows.numbers[i]);
      curve.y.push_back(drawn.rows.numbers[i + c]);
    }
    for (std::size_t i = c; i < drawn.low.size(); i += kColumns) {
      curve.low.push_back(drawn.low[i]);
      curve.high.push_back(drawn.high[i]);
    }
  }
  return curves;
}

ReportCurve thin(const check::Series& series, const check::Deviation& worst, std::size_t limit,
                 bool& thinned) {
  return chosen<2>(series.size(), limit, nearest(series, worst), thinned, [&](std::size_t i) {
    return std::array{series.abscissa[i], series.value[i]};
  })[0];
}

}  // namespace

void put_trace(ReportCheck& check, const check::CheckTrace& trace, std::size_t checks) {
  check.abscissa = trace.abscissa_label;
  check.abscissa_unit = trace.abscissa_unit;
  if (trace.tube > 0.0) check.tube = trace.tube;
  const std::size_t limit =
      std::clamp(kPointsOfCase / std::max<std::size_t>(checks, 1), kFewestPoints,
                 check.verdict.passed ? kPointsOfPassed : kPointsOfFailed);
  const check::Deviation& worst = check.verdict.worst;
  if (trace.value.abscissa != trace.reference.abscissa) {
    check.value = thin(trace.value, worst, limit, check.thinned);
    check.reference = thin(trace.reference, worst, limit, check.thinned);
    return;
  }
  // Point against point: the same points of both stay, so that their difference can be seen.
  auto curves = chosen<4>(
      trace.value.size(), limit, nearest(trace.value, worst), check.thinned, [&](std::size_t i) {
        const double value = trace.value.value[i];
        const double reference = trace.reference.value[i];
        return std::array{trace.value.abscissa[i], value, reference, value - reference};
      });
  check.value = std::move(curves[0]);
  check.reference = std::move(curves[1]);
  check.difference = std::move(curves[2]);
}

}  // namespace slipbench::driver::report
