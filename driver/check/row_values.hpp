// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::check {

/// An expression over t (time in the step), T (total time), result columns and parameters of the
/// case, evaluated on the rows of a run. It keeps references to the case and the expression.
class RowExpression {
 public:
  /// \param columns all of the case
  /// \param variables of `expression`, in its order
  /// Error: a variable that is none of these, in a sentence.
  static tl::expected<RowExpression, std::string> make(const cases::Case& problem,
                                                       std::span<const results::Column> columns,
                                                       const base::Expression& expression,
                                                       std::span<const std::string> variables);

  /// Its value on a row; allocates nothing when it succeeds. Errors: those of the expression.
  tl::expected<double, base::ExpressionError> operator()(const bench::Row& row);

  const std::string& text() const { return expression_->text(); }

 private:
  struct Input {
    enum class Kind : std::uint8_t {
      kStepTime,
      kTotalTime,
      kParameter,
      kColumn
    } kind = Kind::kColumn;
    results::Column column;
    double number = 0.0;  ///< of a parameter
  };

  RowExpression(const cases::Case& problem, const base::Expression& expression)
      : case_(&problem), expression_(&expression) {}

  double read(const Input& input, const bench::Row& row) const;

  const cases::Case* case_;
  const base::Expression* expression_;
  std::vector<Input> inputs_;
  std::vector<double> arguments_;
  bool plain_ = false;  ///< nothing but its only input: most quantities are columns
};

/// The definition whose friction force a check compares: the one that all columns of the quantity
/// belong to, or the only one there is. Nothing if a column is no friction force, so that stick and
/// slip say nothing of it.
std::optional<std::size_t> friction_of(const cases::Case& problem,
                                       std::span<const results::Column> columns,
                                       const cases::Check& check);

}  // namespace slipbench::driver::check
