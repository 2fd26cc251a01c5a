// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "law/table/table_function.hpp"

namespace slipbench::law {

/// F_int >= 0 [F] or M_int [F L]: a number, or a table over accumulated slip, motions, temperature
/// and fields (docs/theory, section 8).
using InternalContactForce = std::variant<double, TableFunction>;

/// Value and its slope to accumulated slip.
struct InternalContactForcePoint {
  double value = 0.0;
  double to_accumulated_slip = 0.0;
};

inline InternalContactForcePoint evaluate(const InternalContactForce& internal,
                                          const Ambient& ambient,
                                          double accumulated_slip) noexcept {
  if (const double* number = std::get_if<double>(&internal)) return {*number, 0.0};
  SlipArguments slopes;
  const double value = std::get_if<TableFunction>(&internal)->value_and_slopes(
      ambient, {.accumulated_slip = accumulated_slip}, &slopes);
  // Linear extrapolation may leave the physical range: F_int is never negative.
  if (value < 0.0) return {0.0, 0.0};
  return {value, slopes.accumulated_slip};
}

inline bool depends_on_accumulated_slip(const InternalContactForce& internal) {
  const auto* function = std::get_if<TableFunction>(&internal);
  return function != nullptr && function->column_of(IndependentKind::kAccumulatedSlip) >= 0;
}

}  // namespace slipbench::law
