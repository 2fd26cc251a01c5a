// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "law/base/capstan.hpp"
#include "law/friction/coefficient_point.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/slip_line.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// mu from a table over slip rate, contact force F_N, temperature and fields (docs/theory,
/// sections 9 and 9.1). Piecewise linear, so continuous with kinks at the knots, where the
/// right-hand slope is reported. Source: C1785 for the form mu F_N, the table is the user's.
/// Proven by law/friction/friction_law_test and law/table/table_test.
struct TabularCoefficient {
  static constexpr std::string_view kName = "table";
  static constexpr std::string_view kTitle =
      "Table over slip rate, contact force, temperature, fields";
  static constexpr std::string_view kFormula =
      "mu(slip_rate, contact_force, temperature, field1, ...)";
  static constexpr std::string_view kSource = "C1785";
  static constexpr std::array<std::string_view, 0> kRules{};
  static constexpr bool kHasFloor = false;

  TableFunction table;

  /// Ragged blocks over slip rate and contact force at two temperatures.
  static TabularCoefficient example() {
    const std::vector<std::vector<double>> rows = {{0.30, 0, 0, 20},   {0.20, 10, 0, 20},
                                                   {0.26, 0, 100, 20}, {0.18, 10, 100, 20},
                                                   {0.24, 0, 50, 120}, {0.22, 20, 50, 120}};
    Table table;
    TableError error;
    Table::build(rows, 1, 3, Extrapolation::kConstant, &table, &error);
    return {TableFunction(std::move(table), {{IndependentKind::kSlipRate, 0},
                                             {IndependentKind::kContactForce, 0},
                                             {IndependentKind::kTemperature, 0}})};
  }

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
  LawRange range() const {
    const auto last = [&](IndependentKind kind) {
      const int column = table.column_of(kind);
      return column < 0 ? 0.0 : 1.1 * table.table().knots(column).back();
    };
    return {last(IndependentKind::kSlipRate), last(IndependentKind::kContactForce), {}};
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
  /// The next knot over the slip rate or the contact force.
  double next_bend(const SlipLine& line) const noexcept {
    const double next = next_knot_of_rate(line);
    const int k = table.column_of(IndependentKind::kContactForce);
    if (k < 0 || line.force_per_slip == 0.0) return next;
    const auto knots = table.table().knots(k);
    const auto here = std::upper_bound(knots.begin(), knots.end(), line.force);
    // A force that stands on a knot may be rounded to either side of it: that knot is past.
    const auto first_ahead = [&](auto knot, auto end) {
      for (; knot != end; ++knot) {
        const double x = line.slip + (*knot - line.force) / line.force_per_slip;
        if (is_ahead(line, x)) return std::min(next, x);
      }
      return next;
    };
    return line.force_per_slip > 0.0 ? first_ahead(here, knots.end())
                                     : first_ahead(std::make_reverse_iterator(here), knots.rend());
  }
  /// exp(mu alpha) of a linear coefficient is convex, -exp(-mu alpha) concave.
  double next_belt_bend(const SlipLine& line, double /*wrap_angle*/,
                        FlowSense /*sense*/) const noexcept {
    return next_knot_of_rate(line);
  }
  bool outside(const Ambient& ambient, const SlipArguments& slip) const {
    return table.outside(ambient, slip);
  }

 private:
  double next_knot_of_rate(const SlipLine& line) const noexcept {
    const int k = table.column_of(IndependentKind::kSlipRate);
    if (k < 0 || !(line.rate_per_slip > 0.0)) return kNoBend;
    const auto knots = table.table().knots(k);
    auto knot = std::upper_bound(knots.begin(), knots.end(), line.rate_at(line.slip));
    const auto slip_at = [&] { return (*knot - line.rate_at_zero) / line.rate_per_slip; };
    // A slip that stands on a knot may be rounded back before it: that knot is past.
    while (knot != knots.end() && slip_at() <= line.slip) ++knot;
    return knot == knots.end() ? kNoBend : slip_at();
  }
};

}  // namespace slipbench::law
