// SPDX-License-Identifier: Apache-2.0
#include "driver/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/bench/run_length.hpp"
#include "driver/check/curves/curve_series.hpp"
#include "driver/check/kept_rows.hpp"
#include "driver/results/columns.hpp"
#include "driver/results/summary.hpp"

namespace slipbench::driver::check {

CheckProgress::CheckProgress(const cases::Case& problem, const cases::Check& check, Trace trace)
    : case_(&problem), check_(&check), judge_(check.tolerance) {
  const bool against_curve = std::holds_alternative<cases::CurveReference>(check.against);
  streamed_ = !keeps_rows(check, Trace::kNone);
  kept_ = keeps_rows(check, trace);
  const std::vector<results::Column> columns = results::result_columns(problem);
  definition_ = friction_of(problem, columns, check);
  const auto make = [&](const base::Expression& expression,
                        const std::vector<std::string>& variables,
                        std::optional<RowExpression>& target) {
    auto made = RowExpression::make(problem, columns, expression, variables);
    if (made) {
      target = std::move(*made);
    } else {
      stop(std::move(made.error()));
    }
  };
  make(check.quantity, check.variables, quantity_);
  if (check.abscissa) make(check.abscissa->expression, check.abscissa->variables, abscissa_);
  if (kept_) reserve_rows();
  if (against_curve) return;
  auto reference = RowReference::make(problem, columns, check);
  if (reference) {
    reference_ = std::move(*reference);
  } else {
    stop(std::move(reference.error()));
  }
}

/// Memory that is not touched costs nothing; a column that grows is copied again and again.
void CheckProgress::reserve_rows() {
  constexpr double kMost = 1 << 20;
  constexpr double kEver = std::numeric_limits<double>::infinity();
  const auto rows = static_cast<std::size_t>(std::min(
      kMost, 1.0 + bench::RunLength(*case_).increments_between(
                       check_->step, check_->from.value_or(-kEver), check_->to.value_or(kEver))));
  rows_.value.value.change().reserve(rows);
  rows_.value.time.change().reserve(rows);
  rows_.status.reserve(rows);
}

bool CheckProgress::selected(const bench::Row& row) const {
  if (!check_->step && !check_->from && !check_->to) return true;
  if (check_->step) {
    const auto step = static_cast<std::size_t>(row.step);
    if (step >= case_->steps.size() || case_->steps[step].name != *check_->step) return false;
  }
  // Times are sums of increments: a border given in decimals may lie beside its row by rounding.
  const double slack = history::kSameTime * std::abs(row.time);
  if (check_->from && row.time < *check_->from - slack) return false;
  return !check_->to || row.time <= *check_->to + slack;
}

/// Nothing that follows can make the check pass.
void CheckProgress::stop(std::string message) {
  if (fault_.empty()) fault_ = std::move(message);
}

void CheckProgress::fault(const bench::Row& row, std::string message) {
  if (faults_++ == 0) fault_ = fmt::format("{} at t = {}", message, base::rounded(row.time));
}

/// The reference at a row, if there is one to be had.
std::optional<double> CheckProgress::reference(const bench::Row& row, bool compared) {
  if (!compared && !reference_->follows_path()) return std::nullopt;
  auto value = (*reference_)(row);
  if (value) return *value;
  if (value.error().breaks_path) {
    fault_ = std::move(value.error().message);
    faults_ = 0;
  } else {
    fault(row, std::move(value.error().message));
  }
  return std::nullopt;
}

void CheckProgress::add(std::span<const bench::Row> rows) {
  for (const bench::Row& row : rows) add_row(row);
}

void CheckProgress::add_row(const bench::Row& row) {
  if (!fault_.empty() && faults_ == 0) return;
  const bool compared = selected(row);
  std::optional<double> wanted;
  if (reference_) wanted = reference(row, compared);
  if (!compared) return;
  ++compared_;
  if (reference_ && !wanted) return;
  const auto value = (*quantity_)(row);
  if (!value) return fault(row, "the quantity has no value: " + value.error().message);
  if (!std::isfinite(*value)) return fault(row, "the quantity is not a finite number");
  if (wanted && !std::isfinite(*wanted)) return fault(row, "the reference is not a finite number");
  double abscissa = row.time;
  if (abscissa_) {
    const auto there = (*abscissa_)(row);
    if (!there) return fault(row, "the abscissa has no value: " + there.error().message);
    if (!std::isfinite(*there)) return fault(row, "the abscissa is not a finite number");
    abscissa = *there;
  }
  compare(row, abscissa, *value, wanted.value_or(0.0));
}

void CheckProgress::compare(const bench::Row& row, double abscissa, double value,
                            double reference) {
  const int status =
      definition_ ? static_cast<int>(row.definitions[*definition_].update.state.regime) : -1;
  if (streamed_) judge_.add({abscissa, value, reference, row.time}, status);
  if (!kept_) return;
  if (check_->abscissa) rows_.value.abscissa.push_back(abscissa);
  rows_.value.value.push_back(value);
  rows_.value.time.push_back(row.time);
  rows_.status.push_back(static_cast<std::int8_t>(status));
  if (reference_) rows_.reference.push_back(reference);
}

ComparedRows CheckProgress::kept_rows() const {
  ComparedRows rows = rows_;
  if (!check_->abscissa) rows.value.abscissa = rows.value.time;
  return rows;
}

Verdict CheckProgress::verdict() const {
  const CheckLabels labels = labels_of(*case_, *check_);
  Verdict result;
  result.name = check_->name;
  result.criterion = check_->criterion;
  result.unit = labels.unit;
  result.abscissa = labels.abscissa;
  if (!labels.abscissa_unit.empty()) result.abscissa += " [" + labels.abscissa_unit + "]";
  result.abscissa_unit = labels.abscissa_unit;
  result.product_unit = labels.product_unit;
  if (streamed_) conclude(*check_, labels, judge_, {}, result);
  result.compared = compared_;
  if (!fault_.empty()) {
    result.failing += faults_;
    result.likely_cause.clear();
    result.warnings.clear();
    result.message = fault_;
    if (faults_ > 1) {
      result.message += fmt::format(", and at {} more of {} points", faults_ - 1, compared_);
    }
  } else if (compared_ == 0) {
    result.message = "no row was compared";
  } else if (!streamed_) {
    judge_rows(*check_, labels, kept_rows(), result);
  }
  result.message = base::printable(result.message);  // it may quote a file
  result.passed = result.message.empty();
  return result;
}

CheckTrace CheckProgress::trace() const {
  CheckTrace trace;
  if (!kept_) return trace;
  const CheckLabels labels = labels_of(*case_, *check_);
  trace.abscissa_label = labels.abscissa;
  trace.abscissa_unit = labels.abscissa_unit;
  const ComparedRows rows = kept_rows();
  trace.value = rows.value;
  if (std::holds_alternative<cases::CurveReference>(check_->against)) {
    if (auto curve = reference_curve(*check_, rows.value)) {
      trace.reference = std::move(curve->series);
    }
  } else {
    trace.reference = reference_of(rows);
  }
  if (check_->criterion == cases::Criterion::kPointwise) trace.tube = verdict().tolerance;
  return trace;
}

}  // namespace slipbench::driver::check
