// SPDX-License-Identifier: Apache-2.0
#include "driver/compare/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "driver/results/summary.hpp"
#include "reference/catalogue.hpp"

namespace slipbench::driver {
namespace {

/// Below this part of its magnitude, the range of a reference is its rounding.
constexpr double kNearlyConstant = 1e-9;

/// Three digits are enough to judge a deviation.
std::string brief(double value) { return fmt::format("{:.3g}", value); }

}  // namespace

double Deviation::size() const { return std::abs(value - reference); }

double Verdict::worst_fraction() const {
  const double size = worst.size();
  if (size == 0.0) return 0.0;
  return tolerance > 0.0 ? size / tolerance : std::numeric_limits<double>::infinity();
}

CheckProgress::CheckProgress(const Case& problem, const Check& check)
    : case_(&problem), check_(&check), columns_(result_columns(problem)) {
  if (auto inputs = inputs_of(check.variables)) quantity_inputs_ = std::move(*inputs);
  if (const auto* expression = std::get_if<ExpressionReference>(&check.against)) {
    if (auto inputs = inputs_of(expression->variables)) reference_inputs_ = std::move(*inputs);
    return;
  }
  const auto& form = std::get<ClosedFormReference>(check.against);
  const reference::ClosedForm* found = reference::find(form.name);
  if (found == nullptr) {
    fault_ = "there is no closed form '" + form.name + "'";
    return;
  }
  for (const ExpressionReference& input : form.inputs) {
    if (auto inputs = inputs_of(input.variables))
      form_inputs_.push_back({std::move(*inputs), &input});
  }
  form_arguments_.resize(form_inputs_.size());
  closed_form_ = found->make(form.parameters);
  outputs_.resize(found->outputs.size());
}

std::optional<std::vector<CheckProgress::Input>> CheckProgress::inputs_of(
    const std::vector<std::string>& names) {
  std::vector<Input> inputs;
  for (const std::string& name : names) {
    Input input;
    if (name == "t" || name == "T") {
      input.kind = name == "t" ? Input::Kind::kStepTime : Input::Kind::kTotalTime;
    } else if (auto column = find_column(*case_, columns_, name)) {
      input.column = std::move(*column);
    } else {
      if (fault_.empty()) fault_ = "there is no result column '" + name + "'";
      return std::nullopt;
    }
    inputs.push_back(std::move(input));
  }
  return inputs;
}

void CheckProgress::gather(const std::vector<Input>& inputs, const Row& row) {
  arguments_.clear();
  for (const Input& input : inputs) {
    switch (input.kind) {
      case Input::Kind::kStepTime:
        arguments_.push_back(row.step_time);
        break;
      case Input::Kind::kTotalTime:
        arguments_.push_back(row.time);
        break;
      case Input::Kind::kColumn:
        arguments_.push_back(column_value(input.column, *case_, row));
        break;
    }
  }
}

bool CheckProgress::selected(const Row& row) const {
  if (check_->step) {
    const auto step = static_cast<std::size_t>(row.step);
    if (step >= case_->steps.size() || case_->steps[step].name != *check_->step) return false;
  }
  // Times are sums of increments: a border given in decimals may lie beside its row by rounding.
  const double slack = kSameTime * std::abs(row.time);
  if (check_->from && row.time < *check_->from - slack) return false;
  return !check_->to || row.time <= *check_->to + slack;
}

/// Evaluates the inputs of the closed form. Without one of them the path is broken, and with it all
/// that follows.
bool CheckProgress::gather_form_inputs(const Row& row) {
  for (std::size_t i = 0; i < form_inputs_.size(); ++i) {
    gather(form_inputs_[i].inputs, row);
    const auto value = form_inputs_[i].value->expression(arguments_);
    if (!value) {
      fault_ = fmt::format("an input of the closed form, '{}', has no value: {} at t = {}",
                           form_inputs_[i].value->expression.text(), value.error().message,
                           rounded(row.time));
      return false;
    }
    form_arguments_[i] = *value;
  }
  return true;
}

std::optional<double> CheckProgress::reference(const Row& row, bool compared) {
  if (closed_form_) {
    if (!gather_form_inputs(row)) return std::nullopt;
    closed_form_(form_arguments_, outputs_);
    const auto& form = std::get<ClosedFormReference>(check_->against);
    return outputs_[static_cast<std::size_t>(form.output)];
  }
  if (!compared) return std::nullopt;
  gather(reference_inputs_, row);
  auto value = std::get<ExpressionReference>(check_->against).expression(arguments_);
  if (value) return *value;
  fault(row, "the reference has no value: " + value.error().message);
  return std::nullopt;
}

void CheckProgress::fault(const Row& row, std::string message) {
  if (faults_++ == 0) fault_ = fmt::format("{} at t = {}", message, rounded(row.time));
}

void CheckProgress::add(const Row& row) {
  if (!fault_.empty() && faults_ == 0) return;
  const bool compared = selected(row);
  if (!compared && !closed_form_) return;
  const std::optional<double> wanted = reference(row, compared);
  if (!compared) return;
  ++compared_;
  if (!wanted) return;
  gather(quantity_inputs_, row);
  const auto value = check_->quantity(arguments_);
  if (!value) {
    fault(row, "the quantity has no value: " + value.error().message);
  } else if (!std::isfinite(*wanted) || !std::isfinite(*value)) {
    fault(row, std::isfinite(*value) ? "the reference is not a finite number"
                                     : "the quantity is not a finite number");
  } else {
    compare(row.time, *value, *wanted);
  }
}

/// What a relative tolerance is relative to.
double CheckProgress::scale() const {
  const double range = highest_ - lowest_;
  const double magnitude = std::max(std::abs(highest_), std::abs(lowest_));
  return range < kNearlyConstant * magnitude ? magnitude : range;
}

/// The tolerance cannot turn out smaller than this: the range only grows, and the magnitude, too.
double CheckProgress::certain_tolerance() const {
  const double range = highest_ - lowest_;
  const double magnitude = std::max(std::abs(highest_), std::abs(lowest_));
  return std::max(
      check_->tolerance.absolute.value_or(0.0),
      check_->tolerance.relative.value_or(0.0) * std::max(range, kNearlyConstant * magnitude));
}

void CheckProgress::compare(double time, double value, double reference_value) {
  const bool first = compared_ - faults_ == 1;
  lowest_ = first ? reference_value : std::min(lowest_, reference_value);
  highest_ = first ? reference_value : std::max(highest_, reference_value);
  const Deviation here{time, value, reference_value};
  const double size = here.size();
  if (first || size > worst_.size()) worst_ = here;
  if (size <= certain_tolerance()) return;
  // Only rows that may yet fail are kept, so a check that passes needs next to no memory.
  suspects_.push_back({time, size});
  if (suspects_.size() < prune_at_) return;
  const double certain = certain_tolerance();
  std::erase_if(suspects_, [&](const Suspect& s) { return s.deviation <= certain; });
  prune_at_ = std::max(prune_at_, 2 * suspects_.size());
}

Verdict CheckProgress::verdict() const {
  Verdict result;
  result.name = check_->name;
  result.compared = compared_;
  result.worst = worst_;
  result.scale = scale();
  result.tolerance = std::max(check_->tolerance.absolute.value_or(0.0),
                              check_->tolerance.relative.value_or(0.0) * result.scale);
  for (const Suspect& suspect : suspects_) {
    if (suspect.deviation <= result.tolerance) continue;
    ++result.failing;
    if (!result.first_failing) result.first_failing = suspect.time;
    result.last_failing = suspect.time;
  }
  const std::string unit = check_unit(*case_, *check_);
  if (!fault_.empty()) {
    result.failing += faults_;
    result.message = fault_;
    if (faults_ > 1) {
      result.message += fmt::format(", and at {} more of {} points", faults_ - 1, compared_);
    }
  } else if (compared_ == 0) {
    result.message = "no row was compared";
  } else if (result.failing > 0) {
    result.message =
        fmt::format("{} off by {} (limit {}) at t = {}, first at {}, last at {}, {} of {} points",
                    check_->quantity_text, with_unit(brief(worst_.size()), unit),
                    brief(result.tolerance), brief(worst_.time), brief(*result.first_failing),
                    brief(*result.last_failing), result.failing, compared_);
  }
  result.passed = result.message.empty();
  return result;
}

std::string check_unit(const Case& problem, const Check& check) {
  const std::vector<Column> columns = result_columns(problem);
  const auto column = find_column(problem, columns, check.quantity_text);
  return column ? unit_text(column->dimension, problem.units) : std::string();
}

json::Value to_json(const Verdict& verdict) {
  json::Value one;
  one["name"] = verdict.name;
  one["passed"] = verdict.passed;
  one["message"] = verdict.message;
  one["compared"] = verdict.compared;
  one["failing"] = verdict.failing;
  one["tolerance"] = verdict.tolerance;
  one["worst_deviation"] = verdict.worst.size();
  one["worst_time"] = verdict.worst.time;
  return one;
}

}  // namespace slipbench::driver
