// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "law/table/table_function.hpp"

namespace slipbench::test {

using Rows = std::vector<std::vector<double>>;

/// A table that must be buildable. \throws std::logic_error if it is not
inline law::Table make_table(const Rows& rows, int dependents, int independents,
                             law::Extrapolation extrapolation = law::Extrapolation::kConstant) {
  law::Table table;
  law::TableError error;
  if (!law::Table::build(rows, dependents, independents, extrapolation, &table, &error)) {
    throw std::logic_error("the rows of a test do not make a table");
  }
  return table;
}

/// As make_table(), with the connector quantity each independent stands for.
inline law::TableFunction make_function(
    const Rows& rows, std::vector<law::Independent> independents, int dependents = 1,
    law::Extrapolation extrapolation = law::Extrapolation::kConstant) {
  const int count = static_cast<int>(independents.size());
  return {make_table(rows, dependents, count, extrapolation), std::move(independents)};
}

inline constexpr law::Independent kOverSlipRate{law::IndependentKind::kSlipRate, 0};
inline constexpr law::Independent kOverContactForce{law::IndependentKind::kContactForce, 0};
inline constexpr law::Independent kOverAccumulatedSlip{law::IndependentKind::kAccumulatedSlip, 0};
inline constexpr law::Independent kOverTemperature{law::IndependentKind::kTemperature, 0};
/// \param index of the field variable, from 0
constexpr law::Independent over_field(int index) { return {law::IndependentKind::kField, index}; }
/// \param number of the component as users write it, 1..6
constexpr law::Independent over_position(int number) {
  return {law::IndependentKind::kPosition, number - 1};
}
constexpr law::Independent over_motion(int number) {
  return {law::IndependentKind::kConstitutiveMotion, number - 1};
}

}  // namespace slipbench::test
