// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <string_view>
#include <vector>

#include "reference/catalogue.hpp"

/// The output rows of a closed form along the input rows, evaluated as a driver would.
inline std::vector<std::vector<double>> evaluate(
    const slipbench::reference::ClosedForm& form,
    const std::vector<std::vector<double>>& parameter_values,
    const std::vector<std::vector<double>>& rows) {
  REQUIRE(parameter_values.size() == form.parameters.size());
  REQUIRE_FALSE(form.violation(parameter_values).has_value());
  const auto evaluator = form.make(parameter_values);
  std::vector<std::vector<double>> results;
  for (const auto& row : rows) {
    REQUIRE(row.size() == form.inputs.size());
    results.emplace_back(form.outputs.size());
    evaluator(row, results.back());
  }
  return results;
}

/// The same for the closed form that the catalogue has under that name.
inline std::vector<std::vector<double>> evaluate(
    std::string_view name, const std::vector<std::vector<double>>& parameter_values,
    const std::vector<std::vector<double>>& rows) {
  const auto* form = slipbench::reference::find(name);
  REQUIRE(form != nullptr);
  return evaluate(*form, parameter_values, rows);
}
