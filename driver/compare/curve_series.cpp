// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/curve_series.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <variant>

#include "driver/compare/curve_file.hpp"
#include "driver/history/step_grid.hpp"

namespace slipbench::driver {
namespace {

/// Times are sums of increments: a border given in decimals may lie beside its row by rounding.
bool within(double time, double from, double to) {
  const double slack = kSameTime * std::abs(time);
  return time >= from - slack && time <= to + slack;
}

/// Keeps the rows whose entry in `times` lies in [from, to].
void keep_between(Series& series, std::span<const double> times, double from, double to) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!within(times[i], from, to)) continue;
    series.abscissa[kept] = series.abscissa[i];
    series.value[kept++] = series.value[i];
  }
  series.abscissa.resize(kept);
  series.value.resize(kept);
}

bool selects_rows(const Check& check) { return check.step || check.from || check.to; }

/// The file that the reader shared out, or one for a check that was built by hand.
std::shared_ptr<const CurveFile> file_of(const Check& check, const CurveReference& reference) {
  if (reference.data) return reference.data;
  auto file = std::make_shared<CurveFile>(reference.file, reference.shown_name);
  want_columns(*file, check);
  return file;
}

}  // namespace

void want_columns(CurveFile& file, const Check& check) {
  const auto& reference = std::get<CurveReference>(check.against);
  file.want(reference.abscissa.names);
  file.want(reference.column.names);
  if (check.abscissa && selects_rows(check)) file.want(golden_time_names());
}

tl::expected<ReferenceCurve, std::string> reference_curve(const Check& check,
                                                          const Series& result) {
  const auto& reference = std::get<CurveReference>(check.against);
  const auto file = file_of(check, reference);
  const auto abscissa = file->column(reference.abscissa.names);
  if (!abscissa) return tl::unexpected(abscissa.error());
  const auto value = file->column(reference.column.names);
  if (!value) return tl::unexpected(value.error());

  ReferenceCurve curve;
  curve.golden = file->golden();
  Series& series = curve.series;
  bool finite = true;
  const auto convert = [&](const std::vector<double>& from, const UnitConversion& conversion,
                           std::vector<double>& to) {
    to.reserve(from.size());
    for (const double number : from) {
      to.push_back(conversion(number));
      finite = finite && std::isfinite(to.back());
    }
  };
  convert((*abscissa)->values, reference.abscissa.conversion, series.abscissa);
  convert((*value)->values, reference.column.conversion, series.value);
  if (!finite) {
    return tl::unexpected(fmt::format(
        "{}: a number exceeds the range of a double in the case's unit", reference.shown_name));
  }
  if ((*value)->resolution) {
    curve.resolution = *(*value)->resolution * std::abs(reference.column.conversion.scale);
  }

  const double infinity = std::numeric_limits<double>::infinity();
  if (!check.abscissa && (check.from || check.to)) {
    const std::vector<double> times = series.abscissa;
    keep_between(series, times, check.from.value_or(-infinity), check.to.value_or(infinity));
  }
  if (selects_rows(check) && check.abscissa && !result.time.empty() && curve.golden) {
    const auto times = file->column(golden_time_names());
    if (!times) return tl::unexpected(times.error());
    keep_between(series, (*times)->values, result.time.front(), result.time.back());
  }
  if (series.size() == 0) {
    return tl::unexpected(fmt::format("{}: no row of it was compared", reference.shown_name));
  }
  if (!check.abscissa) series.time = series.abscissa;
  return curve;
}

}  // namespace slipbench::driver
