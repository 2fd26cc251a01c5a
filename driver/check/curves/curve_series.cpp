// SPDX-License-Identifier: Apache-2.0
#include "driver/check/curves/curve_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <variant>

#include "driver/case/curve_file.hpp"
#include "driver/check/curves/common_range.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver::check {
namespace {

/// Times are sums of increments: a border given in decimals may lie beside its row by rounding.
bool within(double time, double from, double to) {
  const double slack = history::kSameTime * std::abs(time);
  return time >= from - slack && time <= to + slack;
}

/// Keeps the rows whose entry in `times` lies in [from, to].
void keep_between(Series& series, const cases::SharedNumbers& times, const Interval& span) {
  std::vector<double>& abscissa = series.abscissa.change();
  std::vector<double>& value = series.value.change();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!within(times[i], span.from, span.to)) continue;
    abscissa[kept] = abscissa[i];
    value[kept++] = value[i];
  }
  abscissa.resize(kept);
  value.resize(kept);
}

/// The part of a curve whose time lies in `span`, its ends interpolated.
void cut_between(Series& series, const cases::SharedNumbers& times, const Interval& span) {
  Series by_time{times, std::move(series.value), std::move(series.abscissa)};
  const Interval all = times.empty() ? Interval{} : extent(times);
  const double slack = history::kSameTime * std::max(std::abs(all.from), std::abs(all.to));
  by_time = cut(by_time, span, slack);
  series.abscissa = std::move(by_time.time);
  series.value = std::move(by_time.value);
}

/// Either of them, as the criterion needs it.
void select(Series& series, const cases::SharedNumbers& times, const Interval& span,
            cases::Criterion criterion) {
  if (criterion == cases::Criterion::kPointwise) {
    keep_between(series, times, span);
  } else {
    cut_between(series, times, span);
  }
}

bool selects_rows(const cases::Check& check) { return check.step || check.from || check.to; }

/// Returns why a golden curve over these times is not that of rows from `run.from` to `run.to`, in
/// a sentence, or nothing: the rest of either would not be compared with anything.
std::string not_of_run(const std::string& name, const cases::SharedNumbers& times,
                       const Interval& run, bool selected) {
  const Interval golden = times.empty() ? Interval{} : extent(times);
  const double slack = history::kSameTime * std::max({std::abs(golden.from), std::abs(golden.to),
                                                      std::abs(run.from), std::abs(run.to)});
  const bool covers = golden.from <= run.from + slack && golden.to >= run.to - slack;
  const bool ends = golden.from >= run.from - slack && golden.to <= run.to + slack;
  if (covers && (ends || selected)) return {};
  return fmt::format(
      "{}: goes from t = {:.9g} to {:.9g}, and the rows that are compared from {:.9g} to {:.9g}: "
      "it is cut off, or the history is another one than when it was blessed; if that is right, "
      "bless the case",
      name, golden.from, golden.to, run.from, run.to);
}

/// The file that the reader shared out, or one for a check that was built by hand.
std::shared_ptr<const cases::CurveFile> file_of(const cases::Check& check,
                                                const cases::CurveReference& reference) {
  if (reference.data) return reference.data;
  auto file = std::make_shared<cases::CurveFile>(
      base::DataSource{reference.file, reference.shown_name, reference.format});
  want_columns(*file, check);
  return file;
}

}  // namespace

void want_columns(cases::CurveFile& file, const cases::Check& check) {
  const auto& reference = std::get<cases::CurveReference>(check.against);
  file.want(reference.abscissa.names);
  file.want(reference.column.names);
  // The column `time` of any other file is none of ours.
  if (check.abscissa && cases::is_golden_curve(file.path())) file.want(cases::golden_time_names());
}

tl::expected<ReferenceCurve, std::string> reference_curve(const cases::Check& check,
                                                          const Series& result) {
  const auto& reference = std::get<cases::CurveReference>(check.against);
  const auto file = file_of(check, reference);
  const auto abscissa = file->column(reference.abscissa.names);
  if (!abscissa) return tl::unexpected(abscissa.error());
  const auto value = file->column(reference.column.names);
  if (!value) return tl::unexpected(value.error());

  ReferenceCurve curve;
  curve.golden = file->golden();
  Series& series = curve.series;
  bool finite = true;
  const auto converted = [&](const cases::SharedNumbers& from,
                             const base::UnitConversion& conversion) {
    if (conversion == base::UnitConversion{}) return from;
    std::vector<double> to;
    to.reserve(from.size());
    for (const double number : from) {
      to.push_back(conversion(number));
      finite = finite && std::isfinite(to.back());
    }
    return cases::SharedNumbers(std::move(to));
  };
  series.abscissa = converted((*abscissa)->values, reference.abscissa.conversion);
  series.value = converted((*value)->values, reference.column.conversion);
  if (!finite) {
    return tl::unexpected(fmt::format(
        "{}: a number exceeds the range of a double in the case's unit", reference.shown_name));
  }
  if ((*value)->resolution) {
    curve.resolution = *(*value)->resolution * std::abs(reference.column.conversion.scale);
  }

  if ((*abscissa)->resolution) {
    // Two numbers that are printed a unit apart may be the same.
    series.noise = 2.0 * *(*abscissa)->resolution * std::abs(reference.abscissa.conversion.scale);
  }

  const std::size_t rows = series.size();
  const double infinity = std::numeric_limits<double>::infinity();
  if (curve.golden && !result.time.empty()) {
    const Interval run{result.time.front(), result.time.back()};
    cases::SharedNumbers times = series.abscissa;
    if (check.abscissa) {
      const auto column = file->column(cases::golden_time_names());
      if (!column) return tl::unexpected(column.error());
      times = (*column)->values;
    }
    std::string fault = not_of_run(reference.shown_name, times, run, selects_rows(check));
    if (!fault.empty()) return tl::unexpected(std::move(fault));
    if (selects_rows(check) && check.abscissa) select(series, times, run, check.criterion);
  }
  if (!check.abscissa && (check.from || check.to)) {
    const cases::SharedNumbers times = series.abscissa;
    select(series, times, {check.from.value_or(-infinity), check.to.value_or(infinity)},
           check.criterion);
  }
  if (series.size() == 0) {
    return tl::unexpected(fmt::format("{}: no row of it was compared", reference.shown_name));
  }
  if (series.size() == 1 && rows > 1 && result.size() > 1) {
    return tl::unexpected(
        fmt::format("{}: only 1 of its {} rows, at {:.9g}, is selected by the check, and a curve "
                    "needs two",
                    reference.shown_name, rows, series.abscissa.front()));
  }
  if (!check.abscissa) series.time = series.abscissa;
  return curve;
}

}  // namespace slipbench::driver::check
