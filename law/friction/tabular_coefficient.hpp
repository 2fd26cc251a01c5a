// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "law/friction/coefficient_point.hpp"
#include "law/table_function.hpp"

namespace slipbench::law {

/// mu from a table over slip rate, contact force F_N, temperature and fields (specification
/// sections 8 and 12). Piecewise linear, so continuous with kinks at the knots, where the
/// right-hand slope is reported. Source: C1785 for the form mu F_N, the table is the user's.
/// Proven by law/friction_law_test and law/table_test.
struct TabularCoefficient {
  static constexpr std::string_view kName = "table";
  static constexpr std::string_view kTitle =
      "Table over slip rate, contact force, temperature, fields";
  static constexpr std::string_view kFormula =
      "mu(slip_rate, contact_force, temperature, field1, ...)";
  static constexpr std::string_view kSource = "C1785";

  TableFunction table;

  CoefficientPoint evaluate(const Ambient& ambient, const SlipArguments& slip) const noexcept {
    SlipArguments slopes;
    const double mu = table.value_and_slopes(ambient, slip, &slopes);
    // Linear extrapolation may leave the physical range; friction must not pump energy in.
    if (mu < 0.0) return {0.0, 0.0, 0.0};
    return {mu, slopes.slip_rate, slopes.contact_force};
  }
  bool depends_on_slip_rate() const { return table.column_of(IndependentKind::kSlipRate) >= 0; }
  bool depends_on_contact_force() const {
    return table.column_of(IndependentKind::kContactForce) >= 0;
  }
  double largest() const { return table.table().largest(); }
  double largest_growth() const {
    const int k = table.column_of(IndependentKind::kContactForce);
    return k < 0 ? largest() : table.table().largest_growth(k);
  }
  double steepest_weakening() const {
    const int k = table.column_of(IndependentKind::kSlipRate);
    return k < 0 ? 0.0 : -table.table().steepest_fall(k);
  }
  bool outside(const Ambient& ambient, const SlipArguments& slip) const {
    return table.outside(ambient, slip);
  }
};

}  // namespace slipbench::law
