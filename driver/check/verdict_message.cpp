// SPDX-License-Identifier: Apache-2.0
#include "driver/check/verdict_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/results/summary.hpp"

namespace slipbench::driver::check {
namespace {

/// Three digits are enough to judge a deviation; a place needs those that tell its row.
std::string brief(double value) { return fmt::format("{:.3g}", value); }

/// With so many digits that a deviation of that size shows.
std::string telling(double value, double deviation) {
  constexpr double kFewest = 3.0;
  constexpr double kMost = 15.0;
  double digits = kFewest;
  if (value != 0.0 && deviation > 0.0 && std::isfinite(value) && std::isfinite(deviation)) {
    digits = std::ceil(std::log10(std::abs(value) / deviation)) + 2.0;
  }
  return fmt::format("{:.{}g}", value, static_cast<int>(std::clamp(digits, kFewest, kMost)));
}

/// "t = 0.84", or "CU1 = 0.02 mm (t = 0.84)".
std::string place(const ToldPoint& told, const CheckLabels& labels) {
  const std::string abscissa = place_text(told.point.abscissa, told.spacing.abscissa);
  if (labels.abscissa == "t") return "t = " + abscissa;
  std::string text =
      fmt::format("{} = {}", labels.abscissa, base::with_unit(abscissa, labels.abscissa_unit));
  if (std::isfinite(told.point.time)) {
    text += fmt::format(" (t = {})", place_text(told.point.time, told.spacing.time));
  }
  return text;
}

}  // namespace

std::string points_message(const cases::Check& check, const PointJudge::Result& result,
                           std::int64_t compared, const CheckLabels& labels) {
  const CurvePoint& worst = result.worst.point;
  const double deviation = std::abs(worst.value - worst.reference);
  std::string text = fmt::format("{} off by {} (limit {}) at {}", check.quantity_text,
                                 base::with_unit(brief(deviation), labels.unit),
                                 brief(result.tolerance), place(result.worst, labels));
  if (result.first && std::isfinite(result.first->time)) {
    text += fmt::format(", first at {}{}, last at {}", labels.abscissa == "t" ? "" : "t = ",
                        place_text(result.first->time, result.first->step),
                        place_text(result.last->time, result.last->step));
  }
  return text + fmt::format(", {} of {} points", result.failing, compared);
}

std::string measures_message(const Verdict& verdict, const CheckLabels& labels,
                             const Series& result) {
  constexpr int kMostTold = 4;
  int failing = 0;
  std::string text;
  for (const Measure& measure : verdict.measures) {
    if (measure.passed() || ++failing > kMostTold) continue;
    const double difference = std::abs(measure.value - measure.reference);
    const bool plain = std::abs(difference - measure.deviation) <= 1e-9 * measure.deviation;
    text += fmt::format(
        "{}{}: {} instead of {} ({}limit {})", text.empty() ? "" : "; ", measure.name,
        base::with_unit(telling(measure.value, measure.deviation), unit_of(measure, verdict)),
        telling(measure.reference, measure.deviation),
        plain ? "" : "off by " + brief(measure.deviation) + ", ", brief(measure.tolerance));
    if (measure.where) text += " at " + place(told_point(*measure.where, result), labels);
  }
  if (failing > kMostTold) text += fmt::format("; and {} more", failing - kMostTold);
  return text;
}

}  // namespace slipbench::driver::check
