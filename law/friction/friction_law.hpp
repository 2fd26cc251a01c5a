// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "law/friction/constant_coefficient.hpp"
#include "law/friction/exponential_decay.hpp"
#include "law/friction/exponential_test_data.hpp"
#include "law/friction/generalized_viscous.hpp"
#include "law/friction/law_contract.hpp"
#include "law/friction/law_defaults.hpp"
#include "law/friction/modified_darmstad.hpp"
#include "law/friction/renard.hpp"
#include "law/friction/stribeck.hpp"
#include "law/friction/tabular_coefficient.hpp"

namespace slipbench::law {

/// The single list of coefficient laws: the reader, the schema, `slipbench list`, the documentation
/// and the tests fold over it. A new law is one header and one entry here. What a law does not say
/// itself is taken from law_defaults.hpp.
using FrictionLaw =
    std::variant<ConstantCoefficient, ExponentialDecay, ExponentialTestData, GeneralizedViscous,
                 ModifiedDarmstad, Renard, Stribeck<>, TabularCoefficient>;
static_assert(keep_contract(std::type_identity<FrictionLaw>{}));

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
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.evaluate(ambient, slip); }) {
          return l.evaluate(ambient, slip);
        } else {
          return default_point(l, ambient, slip);
        }
      },
      law);
}

/// Returns the same as depends_on_slip_rate, out of line: what asks on the way of an update stays
/// small enough to be in line, however long the list.
[[gnu::noinline]] inline bool visited_slip_rate_dependence(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.depends_on_slip_rate(); }) {
          return l.depends_on_slip_rate();
        } else {
          return true;
        }
      },
      law);
}
inline bool depends_on_slip_rate(const FrictionLaw& law) {
  return !std::holds_alternative<ConstantCoefficient>(law) && visited_slip_rate_dependence(law);
}
inline bool depends_on_contact_force(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.depends_on_contact_force(); }) {
          return l.depends_on_contact_force();
        } else {
          return kSeesForce<std::remove_cvref_t<decltype(l)>>;
        }
      },
      law);
}
/// The largest coefficient the law gives inside its data; infinity where no bound is known.
inline double largest(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.largest(); }) {
          return l.largest();
        } else {
          return default_largest(l);
        }
      },
      law);
}
/// The largest d(mu F_N)/dF_N the law has: how fast the limit can follow the normal force.
/// Infinity where no bound is known.
inline double largest_growth(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.largest_growth(); }) {
          return l.largest_growth();
        } else {
          return default_largest_growth(l);
        }
      },
      law);
}
/// max(-dmu/d(slip rate)) [T/L], 0 for a law that never weakens; infinity where no bound is known.
inline double steepest_weakening(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.steepest_weakening(); }) {
          return l.steepest_weakening();
        } else {
          return default_steepest_weakening(l);
        }
      },
      law);
}
/// The next slip along the line [L] at which mu F_N may have a kink or change its curvature, all of
/// them but the inflection of a table over both rate and contact force; infinity if there is none.
inline double next_bend(const FrictionLaw& law, const SlipLine& line) noexcept {
  if (const auto* table = std::get_if<TabularCoefficient>(&law)) return table->next_bend(line);
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.next_bend(line); }) {
          return l.next_bend(line);
        } else {
          return default_next_bend(l, line);
        }
      },
      law);
}
/// The same of exp(mu alpha) or -exp(-mu alpha) at a constant contact force.
inline double next_belt_bend(const FrictionLaw& law, const SlipLine& line, double wrap_angle,
                             FlowSense sense) noexcept {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.next_belt_bend(line, wrap_angle, sense); }) {
          return l.next_belt_bend(line, wrap_angle, sense);
        } else {
          return default_next_belt_bend(l, line, wrap_angle, sense);
        }
      },
      law);
}

/// Tells whether the law keeps its coefficient above kCoefficientFloor.
inline bool has_floor(const FrictionLaw& law) {
  return std::visit([](const auto& l) { return keeps_floor<std::remove_cvref_t<decltype(l)>>(); },
                    law);
}
/// The coefficient [1] before the floor; that of evaluate() for a law without one.
inline double raw_coefficient(const FrictionLaw& law, const Ambient& ambient,
                              const SlipArguments& slip) noexcept {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.raw(ambient, slip); }) {
          return l.raw(ambient, slip);
        } else if constexpr (requires { l.evaluate(ambient, slip); }) {
          return l.evaluate(ambient, slip).mu;
        } else {
          return coefficient_of(l, ambient, slip.slip_rate, slip.contact_force);
        }
      },
      law);
}
/// Tells whether the floor holds the coefficient up.
inline bool is_clamped(const FrictionLaw& law, const Ambient& ambient,
                       const SlipArguments& slip) noexcept {
  return has_floor(law) && !(raw_coefficient(law, ambient, slip) >= kCoefficientFloor);
}
/// The key of the coefficient whose exponent overflows at a slip rate [L/T], so that mu is
/// infinite; empty if none does.
inline std::string_view overflow(const FrictionLaw& law, double slip_rate) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.overflow(slip_rate); }) return l.overflow(slip_rate);
        return std::string_view{};
      },
      law);
}
/// The range over which the law is drawn to be understood.
inline LawRange range(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.range(); }) {
          return l.range();
        } else {
          return default_range(l);
        }
      },
      law);
}
/// The area that the law divides the normal force by [L^2]; 0 for a law of the force itself, or
/// without an area because it does not need one.
inline double area_of(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.area; }) return l.area.value_or(0.0);
        return 0.0;
      },
      law);
}
/// Tells whether the law sees the pressure and has no area to take it from.
inline bool needs_area(const FrictionLaw& law) {
  return std::visit(
      [](const auto& l) {
        if constexpr (requires { l.needs_area(); }) return l.needs_area();
        return false;
      },
      law);
}

/// The exponential decay that a law is or stands for; nothing for other laws.
inline std::optional<ExponentialDecay> exponential_decay(const FrictionLaw& law) {
  if (const auto* decay = std::get_if<ExponentialDecay>(&law)) return *decay;
  if (const auto* data = std::get_if<ExponentialTestData>(&law)) return data->fit();
  return std::nullopt;
}
/// Tells whether a table is asked outside its data.
inline bool outside(const FrictionLaw& law, const Ambient& ambient, const SlipArguments& slip) {
  const auto* table = std::get_if<TabularCoefficient>(&law);
  return table != nullptr && table->outside(ambient, slip);
}

/// Returns dmu/d(number) in the order of a law's fields().
template <class Law>
auto to_numbers(const Law& law, const Ambient& ambient, const SlipArguments& slip) noexcept {
  if constexpr (requires { law.to_numbers(ambient, slip); }) {
    return law.to_numbers(ambient, slip);
  } else {
    return default_to_numbers(law, ambient, slip);
  }
}

}  // namespace slipbench::law
