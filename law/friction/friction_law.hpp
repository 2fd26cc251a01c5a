// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "law/friction/boxed_law.hpp"
#include "law/friction/constant_coefficient.hpp"
#include "law/friction/exponential_decay.hpp"
#include "law/friction/law_range.hpp"
#include "law/friction/radioss_coefficient.hpp"
#include "law/friction/tabular_coefficient.hpp"

namespace slipbench::law {

/// A coefficient law: one of the list in law_list.hpp. Named here are those that most updates call,
/// whose code is in line; the others are asked through friction_law.cpp.
using FrictionLaw =
    std::variant<ConstantCoefficient, ExponentialDecay, TabularCoefficient, BoxedLaw>;

/// The key and the title of a law.
std::string_view name_of(const FrictionLaw& law);
std::string_view title_of(const FrictionLaw& law);

CoefficientPoint evaluate_boxed(const BoxedLaw& law, const Ambient& ambient,
                                const SlipArguments& slip) noexcept;
inline CoefficientPoint evaluate(const FrictionLaw& law, const Ambient& ambient,
                                 const SlipArguments& slip) noexcept {
  if (const auto* constant = std::get_if<ConstantCoefficient>(&law)) {
    return constant->evaluate(ambient, slip);
  }
  if (const auto* table = std::get_if<TabularCoefficient>(&law)) {
    return table->evaluate(ambient, slip);
  }
  if (const auto* decay = std::get_if<ExponentialDecay>(&law)) {
    return decay->evaluate(ambient, slip);
  }
  return evaluate_boxed(*std::get_if<BoxedLaw>(&law), ambient, slip);
}

bool any_depends_on_slip_rate(const FrictionLaw& law);
inline bool depends_on_slip_rate(const FrictionLaw& law) {
  return !std::holds_alternative<ConstantCoefficient>(law) && any_depends_on_slip_rate(law);
}
bool depends_on_contact_force(const FrictionLaw& law);
/// The largest coefficient the law gives inside its data; infinity where no bound is known.
double largest(const FrictionLaw& law);
/// The largest d(mu F_N)/dF_N the law has: how fast the limit can follow the normal force.
/// Infinity where no bound is known.
double largest_growth(const FrictionLaw& law);
/// max(-dmu/d(slip rate)) [T/L], 0 for a law that never weakens; infinity where no bound is known.
double steepest_weakening(const FrictionLaw& law);

double any_next_bend(const FrictionLaw& law, const SlipLine& line) noexcept;
/// The next slip along the line [L] at which mu F_N may have a kink or change its curvature, all of
/// them but the inflection of a table over both rate and contact force; infinity if there is none.
inline double next_bend(const FrictionLaw& law, const SlipLine& line) noexcept {
  if (const auto* table = std::get_if<TabularCoefficient>(&law)) return table->next_bend(line);
  return any_next_bend(law, line);
}
/// The same of exp(mu alpha) or -exp(-mu alpha) at a constant contact force.
double next_belt_bend(const FrictionLaw& law, const SlipLine& line, double wrap_angle,
                      FlowSense sense) noexcept;

/// Tells whether the law keeps its coefficient above kCoefficientFloor.
bool has_floor(const FrictionLaw& law);
/// The coefficient [1] before the floor; that of evaluate() for a law without one.
double raw_coefficient(const FrictionLaw& law, const Ambient& ambient,
                       const SlipArguments& slip) noexcept;
/// Tells whether the floor holds the coefficient up.
inline bool is_clamped(const FrictionLaw& law, const Ambient& ambient,
                       const SlipArguments& slip) noexcept {
  return has_floor(law) && !(raw_coefficient(law, ambient, slip) >= kCoefficientFloor);
}
/// The key of the coefficient whose exponent overflows at a slip rate [L/T], so that mu is
/// infinite; empty if none does.
std::string_view overflow(const FrictionLaw& law, double slip_rate);
/// The range over which the law is drawn to be understood.
LawRange range(const FrictionLaw& law);
/// The area that the law divides the normal force by [L^2]; 0 for a law of the force itself, or
/// without an area because it does not need one.
double area_of(const FrictionLaw& law);
/// Tells whether the law sees the pressure and has no area to take it from.
bool needs_area(const FrictionLaw& law);
/// The exponential decay that a law is or stands for; nothing for other laws.
std::optional<ExponentialDecay> exponential_decay(const FrictionLaw& law);
/// Tells whether a table is asked outside its data.
inline bool outside(const FrictionLaw& law, const Ambient& ambient, const SlipArguments& slip) {
  const auto* table = std::get_if<TabularCoefficient>(&law);
  return table != nullptr && table->outside(ambient, slip);
}

}  // namespace slipbench::law
