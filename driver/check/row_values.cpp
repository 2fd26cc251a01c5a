// SPDX-License-Identifier: Apache-2.0
#include "driver/check/row_values.hpp"

#include <cmath>
#include <string_view>
#include <utility>

namespace slipbench::driver::check {
namespace {

/// Without the '=' and the blanks around it.
std::string_view bare(std::string_view text) {
  while (!text.empty() && (text.front() == '=' || text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

tl::expected<RowExpression, std::string> RowExpression::make(
    const cases::Case& problem, std::span<const results::Column> columns,
    const base::Expression& expression, std::span<const std::string> variables) {
  RowExpression result(problem, expression);
  for (const std::string& name : variables) {
    Input input;
    if (name == "t" || name == "T") {
      input.kind = name == "t" ? Input::Kind::kStepTime : Input::Kind::kTotalTime;
    } else if (auto column = results::find_column(problem, columns, name)) {
      input.column = std::move(*column);
    } else if (const auto number = problem.parameters.find(name);
               number != problem.parameters.end()) {
      input.kind = Input::Kind::kParameter;
      input.number = number->second;
    } else {
      return tl::unexpected("there is no result column '" + name + "'");
    }
    result.inputs_.push_back(std::move(input));
  }
  result.arguments_.resize(result.inputs_.size());
  result.plain_ = variables.size() == 1 && bare(expression.text()) == variables[0];
  return result;
}

double RowExpression::read(const Input& input, const bench::Row& row) const {
  switch (input.kind) {
    case Input::Kind::kStepTime:
      return row.step_time;
    case Input::Kind::kTotalTime:
      return row.time;
    case Input::Kind::kParameter:
      return input.number;
    case Input::Kind::kColumn:
      break;
  }
  return results::column_value(input.column, *case_, row);
}

tl::expected<double, base::ExpressionError> RowExpression::operator()(const bench::Row& row) {
  if (plain_) {
    const double value = read(inputs_.front(), row);
    if (std::isfinite(value)) return value;
  }
  for (std::size_t i = 0; i < inputs_.size(); ++i) arguments_[i] = read(inputs_[i], row);
  return (*expression_)(arguments_);
}

std::optional<std::size_t> friction_of(const cases::Case& problem,
                                       std::span<const results::Column> columns,
                                       const cases::Check& check) {
  std::optional<int> definition;
  for (const std::string& name : check.variables) {
    const auto column = results::find_column(problem, columns, name);
    if (!column || !results::is_friction_force(*column)) return std::nullopt;
    if (definition && *definition != column->definition) return std::nullopt;
    definition = column->definition;
  }
  if (definition && *definition >= 0) return static_cast<std::size_t>(*definition);
  if (definition && problem.definitions.size() == 1) return 0;
  return std::nullopt;
}

}  // namespace slipbench::driver::check
