// SPDX-License-Identifier: Apache-2.0
#include "driver/report/thin_trace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "driver/results/thinning.hpp"

namespace slipbench::driver {
namespace {

constexpr std::size_t kPointsOfFailed = 300;
constexpr std::size_t kPointsOfPassed = 120;
/// Points of all checks of a case together, as long as each has those around its worst one.
constexpr std::size_t kPointsOfCase = 3000;
constexpr std::size_t kFewestPoints = 72;
/// Points on each side of the worst one that are never left out.
constexpr std::size_t kNeighbours = 8;

/// The point nearest to the worst deviation: by its time where the series has times.
std::size_t nearest(const Series& series, const Deviation& worst) {
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

ReportCurve thin(const Series& series, const Deviation& worst, std::size_t limit) {
  RowThinner thinner(2, limit);
  const std::size_t place = nearest(series, worst);
  for (std::size_t i = 0; i < series.size(); ++i) {
    thinner.add(std::array{series.abscissa[i], series.value[i]}, near_worst(i, place));
  }
  ReportCurve curve;
  const std::vector<double> rows = thinner.rows();
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    curve.x.push_back(rows[i]);
    curve.y.push_back(rows[i + 1]);
  }
  return curve;
}

}  // namespace

void put_trace(ReportCheck& check, const CheckTrace& trace, std::size_t checks) {
  check.abscissa = trace.abscissa_label;
  check.abscissa_unit = trace.abscissa_unit;
  if (trace.tube > 0.0) check.tube = trace.tube;
  const std::size_t limit =
      std::clamp(kPointsOfCase / std::max<std::size_t>(checks, 1), kFewestPoints,
                 check.verdict.passed ? kPointsOfPassed : kPointsOfFailed);
  const Deviation& worst = check.verdict.worst;
  if (trace.value.abscissa != trace.reference.abscissa) {
    check.value = thin(trace.value, worst, limit);
    check.reference = thin(trace.reference, worst, limit);
    check.thinned = check.value.x.size() < trace.value.size() ||
                    check.reference.x.size() < trace.reference.size();
    return;
  }
  // Point against point: the same points of both stay, so that their difference can be seen.
  constexpr std::array<std::size_t, 3> kWatched{1, 2, 3};
  RowThinner thinner(4, limit, kWatched);
  const std::size_t place = nearest(trace.value, worst);
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    const double value = trace.value.value[i];
    const double reference = trace.reference.value[i];
    thinner.add(std::array{trace.value.abscissa[i], value, reference, value - reference},
                near_worst(i, place));
  }
  const std::vector<double> rows = thinner.rows();
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    check.value.x.push_back(rows[i]);
    check.value.y.push_back(rows[i + 1]);
    check.reference.y.push_back(rows[i + 2]);
  }
  check.reference.x = check.value.x;
  check.thinned = thinner.thinned();
}

}  // namespace slipbench::driver
