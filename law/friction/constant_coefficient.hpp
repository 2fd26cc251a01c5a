// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "law/base/capstan.hpp"
#include "law/base/field.hpp"
#include "law/friction/coefficient_point.hpp"
#include "law/friction/slip_line.hpp"
#include "law/table/table_function.hpp"

namespace slipbench::law {

/// Coulomb friction: mu is a number. Source: Coulomb 1785 (key C1785).
/// Admissible: mu >= 0; mu = 0 is frictionless. Proven by law/friction/friction_law_test.
struct ConstantCoefficient {
  static constexpr std::string_view kName = "constant";
  static constexpr std::string_view kTitle = "Constant (Coulomb)";
  static constexpr std::string_view kFormula = "mu";
  static constexpr std::string_view kSource = "C1785";
  static constexpr std::array<std::string_view, 0> kRules{};
  static constexpr bool kHasFloor = false;

  double mu = 0.0;

  static constexpr auto fields() {
    return std::tuple{Field{"mu", &ConstantCoefficient::mu, dimension::kNone, kNotNegative, true,
                            "Coefficient of friction."}};
  }

  static ConstantCoefficient example() { return {0.2}; }

  template <class Number>
  Number coefficient(const Number& /*slip_rate*/) const {
    return Number(mu);
  }
  CoefficientPoint evaluate(const Ambient& /*ambient*/,
                            const SlipArguments& /*slip*/) const noexcept {
    return {mu, 0.0, 0.0};
  }
  /// dmu/d(number) in the order of fields().
  std::array<double, 1> to_numbers(const Ambient& /*ambient*/,
                                   const SlipArguments& /*slip*/) const noexcept {
    return {1.0};
  }
  bool depends_on_slip_rate() const { return false; }
  bool depends_on_contact_force() const { return false; }
  double largest() const { return mu; }
  double largest_growth() const { return mu; }
  double steepest_weakening() const { return 0.0; }
  double next_bend(const SlipLine& /*line*/) const noexcept { return kNoBend; }
  double next_belt_bend(const SlipLine& /*line*/, double /*wrap_angle*/,
                        FlowSense /*sense*/) const noexcept {
    return kNoBend;
  }
};

}  // namespace slipbench::law
