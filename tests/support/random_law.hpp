// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>

#include "law/friction/friction_law.hpp"
#include "tests/support/random_definition.hpp"

namespace slipbench::test {

/// Calls visit(number, field) for every number of a law, those that may be absent and are not too.
template <class Law, class Visit>
void for_each_number(Law& law, Visit visit) {
  const auto one = [&](const auto& field) {
    auto& member = law.*(field.member);
    using Member = std::remove_cvref_t<decltype(member)>;
    if constexpr (std::is_same_v<Member, double>) visit(member, field);
    if constexpr (std::is_same_v<Member, std::optional<double>>) {
      if (member) visit(*member, field);
    }
  };
  std::apply([&](const auto&... field) { (one(field), ...); }, std::remove_cvref_t<Law>::fields());
}

/// Any law of a type that its rules admit: numbers up to three times those of its example, of any
/// sign that the bounds in fields() let pass, some on a bound or 0. Tables are over the slip rate
/// or the contact force.
template <class Law>
Law random_law(Dice& dice) {
  if constexpr (std::is_same_v<Law, law::TabularCoefficient>) {
    const auto kind =
        dice.chance(0.7) ? law::IndependentKind::kSlipRate : law::IndependentKind::kContactForce;
    TableRows table = random_table(&dice, {{kind, 0}}, 1, 0.05, 0.4);
    table.extrapolation = law::Extrapolation::kConstant;
    return {table.build()};
  } else {
    for (;;) {
      Law law = Law::example();
      for_each_number(law, [&](double& number, const auto& field) {
        const law::Bounds& bounds = field.bounds;
        const double size = number != 0.0 ? std::abs(number) : 1.0;
        double x = size * dice.between(0.0, 3.0) * (dice.chance(0.3) ? -1.0 : 1.0);
        if (dice.chance(0.1)) x = 0.0;
        if (!bounds.contains(x)) x = -x;
        x = std::clamp(x, bounds.lower, bounds.upper);
        number = bounds.contains(x) ? x : size;
      });
      if constexpr (requires { law.violation(); }) {
        if (law.violation()) continue;
      }
      return law;
    }
  }
}

/// The same law, its numbers in other units; one with a speed unit of its own keeps them.
template <class Law>
Law in_units(Law law, const Units& units) {
  if constexpr (requires { law.speed_factor; }) {
    law.speed_factor *= units.length / units.time;
  } else {
    for_each_number(law, [&](double& number, const auto& field) {
      number /= std::pow(units.force, field.dimension.force) *
                std::pow(units.length, field.dimension.length) *
                std::pow(units.time, field.dimension.time);
    });
  }
  return law;
}

}  // namespace slipbench::test
