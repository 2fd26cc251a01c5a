// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/case/case.hpp"
#include "driver/check/row_values.hpp"
#include "reference/closed_form.hpp"

namespace slipbench::driver::check {

/// Reference by an expression or a closed form, row by row. It keeps references
/// to the case and the check.
class RowReference {
 public:
  /// Reason why a row has no reference.
  struct Fault {
    std::string message;
    bool breaks_path = false;  ///< nothing that follows has one either
  };

  /// \param check one against an expression or a closed form
  /// Errors, in a sentence: an unknown closed form, a name that is no result column.
  static tl::expected<RowReference, std::string> make(const cases::Case& problem,
                                                      std::span<const results::Column> columns,
                                                      const cases::Check& check);

  /// A closed form follows the whole path: it has to be given every row, from the first on.
  bool follows_path() const { return static_cast<bool>(form_); }

  /// The reference at a row.
  tl::expected<double, Fault> operator()(const bench::Row& row);

 private:
  reference::PathEvaluator form_;
  std::vector<RowExpression> inputs_;  ///< of the closed form; else the expression alone
  std::vector<double> arguments_;
  std::vector<double> outputs_;
  std::size_t output_ = 0;
};

}  // namespace slipbench::driver::check
