// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <variant>

#include "law/table/table_function.hpp"

namespace slipbench::law {

/// A force along a component and its slope to the motion or velocity it follows: [F] and [F/L] or
/// [F T/L]; of a rotation [F L] and [F L] or [F L T].
struct ForcePoint {
  double force = 0.0;
  double slope = 0.0;
};

/// Connector elasticity of one component, in parallel with its friction: CEF = k u, or a table of
/// the force over the displacement u (CCU, of a belt its strain), temperature and fields
/// (docs/theory, sections 9.1 and 13.4).
///
/// In a table the independent kConstitutiveMotion stands for u whatever its index: the value is
/// asked for at a displacement, not at a position of the connector.
class Elasticity {
 public:
  Elasticity() = default;
  /// \param stiffness k [F/L], [F L] for a rotation
  explicit Elasticity(double stiffness) : force_(stiffness) {}
  /// \param force one dependent [F], [F L]
  explicit Elasticity(TableFunction force) : force_(std::move(force)) {}

  /// CEF and its slope dCEF/du at a displacement [L], [1]. Of `ambient` only temperature and fields
  /// count. At a knot of the table the slope is the right-hand one.
  ForcePoint value(double displacement, const Ambient& ambient) const noexcept {
    if (const double* stiffness = std::get_if<double>(&force_)) {
      return {*stiffness * displacement, *stiffness};
    }
    const TableFunction& table = *std::get_if<TableFunction>(&force_);
    const Ambient here = at(displacement, ambient);
    RelativePosition slopes;
    table.add_motion_slopes(here, {}, 1.0, &slopes);
    double slope = 0.0;
    for (const double s : slopes.values) slope += s;
    return {table.value(here, {}), slope};
  }

  /// The energy it holds, the integral of CEF from 0 to the displacement at the present temperature
  /// and fields [F L]; exact for a table, whose force is linear between its knots.
  double energy(double displacement, const Ambient& ambient) const noexcept {
    if (const double* stiffness = std::get_if<double>(&force_)) {
      return 0.5 * *stiffness * displacement * displacement;
    }
    const TableFunction& table = *std::get_if<TableFunction>(&force_);
    const int column = table.column_of(IndependentKind::kConstitutiveMotion);
    const double low = std::min(displacement, 0.0);
    const double high = std::max(displacement, 0.0);
    double sum = 0.0;
    double u = low;
    double force = table.value(at(u, ambient), {});
    const auto go_to = [&](double next) {
      const double there = table.value(at(next, ambient), {});
      sum += 0.5 * (force + there) * (next - u);
      u = next;
      force = there;
    };
    if (column >= 0) {
      for (const double knot : table.table().knots(column)) {
        if (knot > low && knot < high) go_to(knot);
      }
    }
    go_to(high);
    return displacement < 0.0 ? -sum : sum;
  }

  /// The table; null for a linear spring.
  const TableFunction* table() const { return std::get_if<TableFunction>(&force_); }

 private:
  static Ambient at(double displacement, const Ambient& ambient) {
    Ambient here = ambient;
    here.motion.values.fill(displacement);
    return here;
  }

  std::variant<double, TableFunction> force_ = 0.0;
};

}  // namespace slipbench::law
