// SPDX-License-Identifier: Apache-2.0
#include "driver/check/verdict.hpp"

#include <cmath>
#include <limits>

#include "driver/check/criteria/criteria.hpp"

namespace slipbench::driver::check {
namespace {

double fraction(double deviation, double tolerance) {
  if (deviation == 0.0) return 0.0;
  return tolerance > 0.0 ? deviation / tolerance : std::numeric_limits<double>::infinity();
}

base::json::Value to_json(const CurvePoint& point) {
  base::json::Value one;
  one["time"] = point.time;
  one["abscissa"] = point.abscissa;
  one["value"] = point.value;
  one["reference"] = point.reference;
  return one;
}

base::json::Value to_json(const Measure& measure, const Verdict& verdict) {
  base::json::Value one;
  one["name"] = measure.name;
  one["unit"] = unit_of(measure, verdict);
  one["value"] = measure.value;
  one["reference"] = measure.reference;
  one["deviation"] = measure.deviation;
  one["tolerance"] = measure.tolerance;
  one["scale"] = measure.scale;
  one["passed"] = measure.passed();
  if (measure.where) one["where"] = to_json(*measure.where);
  return one;
}

base::json::Value or_null(const std::optional<double>& number) {
  return number ? base::json::Value(*number) : base::json::Value(nullptr);
}

}  // namespace

double Deviation::size() const { return std::abs(value - reference); }

double Verdict::worst_deviation() const {
  if (measures.empty()) return worst.size();
  const Measure* measure = worst_measure(*this);
  return measure == nullptr ? 0.0 : measure->deviation;
}

double Verdict::worst_fraction() const { return fraction(worst_deviation(), tolerance); }

const Measure* worst_measure(const Verdict& verdict) {
  const Measure* worst = nullptr;
  for (const Measure& measure : verdict.measures) {
    if (std::isinf(measure.tolerance)) continue;
    if (worst == nullptr || fraction(measure.deviation, measure.tolerance) >
                                fraction(worst->deviation, worst->tolerance)) {
      worst = &measure;
    }
  }
  return worst;
}

const std::string& unit_of(const Measure& measure, const Verdict& verdict) {
  static const std::string kNothing;
  switch (measure.unit) {
    case MeasureUnit::kQuantity:
      return verdict.unit;
    case MeasureUnit::kAbscissa:
      return verdict.abscissa_unit;
    case MeasureUnit::kProduct:
      return verdict.product_unit;
    case MeasureUnit::kNone:
      break;
  }
  return kNothing;
}

base::json::Value to_json(const Verdict& verdict) {
  base::json::Value one;
  one["name"] = verdict.name;
  one["criterion"] = info_of(verdict.criterion).word;
  one["passed"] = verdict.passed;
  one["message"] = verdict.message;
  one["likely_cause"] = verdict.likely_cause;
  base::json::Value warnings = base::json::Array{};
  for (const std::string& warning : verdict.warnings) warnings.push_back(warning);
  one["warnings"] = std::move(warnings);
  one["compared"] = verdict.compared;
  one["failing"] = verdict.failing;
  one["unit"] = verdict.unit;
  one["abscissa"] = verdict.abscissa;
  one["tolerance"] = verdict.tolerance;
  one["scale"] = verdict.scale;
  one["worst_deviation"] = verdict.worst_deviation();
  one["worst_fraction"] = verdict.worst_fraction();
  one["worst_time"] = verdict.worst.time;
  one["worst_abscissa"] = verdict.worst.abscissa;
  one["worst_value"] = verdict.worst.value;
  one["worst_reference"] = verdict.worst.reference;
  one["first_failing"] = or_null(verdict.first_failing);
  one["last_failing"] = or_null(verdict.last_failing);
  base::json::Value measures = base::json::Array{};
  for (const Measure& measure : verdict.measures) measures.push_back(to_json(measure, verdict));
  one["measures"] = std::move(measures);
  return one;
}

}  // namespace slipbench::driver::check
