// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <variant>

#include "law/component/elasticity.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Connector damping of one component, in parallel with its friction: CVF = c v, or a table of the
/// force over the velocity v, temperature and fields (docs/theory, sections 9.1 and
/// 13.4).
///
/// In a table the independent kSlipRate stands for v, with its sign.
class Damping {
 public:
  Damping() = default;
  /// \param coefficient c [F T/L], [F L T] for a rotation
  explicit Damping(double coefficient) : force_(coefficient) {}
  /// \param force one dependent [F], [F L]
  explicit Damping(TableFunction force) : force_(std::move(force)) {}

  /// CVF and its slope dCVF/dv at a velocity [L/T], [1/T]. Of `ambient` only temperature and fields
  /// count. At a knot of the table the slope is the right-hand one.
  ForcePoint value(double velocity, const Ambient& ambient) const noexcept {
    if (const double* coefficient = std::get_if<double>(&force_)) {
      return {*coefficient * velocity, *coefficient};
    }
    SlipArguments slopes;
    const double force = std::get_if<TableFunction>(&force_)->value_and_slopes(
        ambient, {.slip_rate = velocity}, &slopes);
    return {force, slopes.slip_rate};
  }

  /// The table; null for a linear damper.
  const TableFunction* table() const { return std::get_if<TableFunction>(&force_); }

 private:
  std::variant<double, TableFunction> force_ = 0.0;
};

}  // namespace slipbench::law
