// SPDX-License-Identifier: Apache-2.0
// Definitions and histories of any size, out of a seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <variant>
#include <vector>

#include "law/definition/packed_definition.hpp"
#include "law/exact/continuous_update.hpp"
#include "tests/difference/one_step.hpp"
#include "tests/support/any_definition.hpp"

namespace slipbench::test {

/// A definition, and increments without the states that they begin from.
struct AnyCase {
  std::vector<double> definition;  ///< packed
  std::vector<PlainIncrement<double>> increments;
};

/// Returns a number of the environment, if it is set.
inline std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// Returns how many increments a test compares.
inline std::uint64_t increments_wanted() {
  return number_of("SLIPBENCH_DIFFERENCE_INCREMENTS", 10000);
}
inline std::uint64_t first_seed() { return number_of("SLIPBENCH_DIFFERENCE_SEED", 1); }

/// Writes the numbers of a formulation in other units.
inline void put_in_units(law::Formulation& formulation, const Units& units) {
  const double stiffness = units.force / units.length;
  if (auto* viscous = std::get_if<law::ViscousPenalty>(&formulation.penalty)) {
    std::get<double>(viscous->stiffness) /= stiffness;
    viscous->mass /= stiffness * units.time * units.time;
    if (viscous->coefficient) *viscous->coefficient /= stiffness * units.time;
  } else {
    std::get<law::StiffnessPenalty>(formulation.penalty).stiffness /= stiffness;
  }
  if (formulation.filter.kind == law::Filter::Kind::kPeriod) formulation.filter.value /= units.time;
  if (formulation.filter.kind == law::Filter::Kind::kFrequency) {
    formulation.filter.value *= units.time;
  }
}

/// Returns a law of the list in other units; one that is a table keeps its numbers.
inline law::FrictionLaw any_law_in_units(Dice& dice, const Units& units) {
  const law::FrictionLaw drawn = any_law(dice);
  return law::visit_law(
      [&](const auto& one) -> law::FrictionLaw {
        using Law = std::remove_cvref_t<decltype(one)>;
        if constexpr (std::is_same_v<Law, law::TabularCoefficient>) {
          return one;
        } else {
          return in_units(one, units);
        }
      },
      drawn);
}

inline PlainIncrement<double>::End plain_end(const law::RelativePosition& position,
                                             const HistoryRow& row) {
  return {position.values, law::constitutive_motion(position, row.reference).values,
          row.force.values, row.temperature, row.fields};
}

/// Returns the case of a seed: every type of connection, belts and potentials among them, with
/// every law, lengths, forces and times of 1e-12 to 1e12, and springs so stiff that an increment is
/// 1e9 elastic slips long.
inline AnyCase any_case(std::uint64_t seed, Way way) {
  Dice dice(seed);
  Units units;
  if (dice.chance(0.7)) {
    const auto any_size = [&] { return std::pow(10.0, dice.between(-12.0, 12.0)); };
    units = {any_size(), any_size(), any_size()};
  }
  const int kind = dice.pick(kDefinitionKinds + 1);
  const bool belt = kind == kDefinitionKinds;
  const DefinitionDescription description =
      belt ? random_belt(&dice) : random_definition(&dice, kind);
  law::FrictionDefinition definition = in_units(description, units).build();
  const SlipUnits own = slip_units(description, units);
  const Units slip{own.slip, own.force, own.time};
  // Some laws make exp(mu alpha) of a belt overflow.
  if (!belt && dice.chance(0.5)) definition.law = any_law_in_units(dice, slip);
  if (!belt && dice.chance(0.15)) {
    law::Formulation& formulation =
        definition.formulation.emplace(any_formulation(dice, definition));
    put_in_units(formulation, slip);
    if (formulation.orthotropy) formulation.orthotropy->second = any_law_in_units(dice, slip);
  }
  if (dice.chance(0.4)) {
    // Extrapolation needs seconds for an increment that is very long.
    const bool quick = way == Way::kBackwardEuler ||
                       law::continuous_method(definition) == law::ContinuousMethod::kEvents;
    const double stiffer = std::pow(10.0, dice.between(-1.0, quick ? 7.0 : 0.0));
    definition.stick.value *=
        definition.stick.mode == law::StickStiffness::Mode::kStiffness ? stiffer : 1.0 / stiffer;
  }
  AnyCase made{law::pack(definition), {}};
  std::vector<HistoryRow> rows = in_units(random_history(&dice, 12), units);
  const auto* capstan = std::get_if<law::Capstan>(&definition.criterion);
  const bool changes = dice.chance(0.15);
  for (HistoryRow& row : rows) {
    // Half of all tensions push: three of four belts are tight instead.
    if (belt && dice.chance(0.75)) row.force[0] = std::abs(row.force[0]);
    PlainIncrement<double> increment;
    increment.duration = row.duration;
    const HistoryRow& before = &row == &rows.front() ? row : *(&row - 1);
    increment.begin = plain_end(row.begin, before);
    increment.end = plain_end(row.end, row);
    const auto share = [&] { return changes ? dice.between(0.5, 1.0) : 1.0; };
    increment.begin_blend = definition.blend.weight * share();
    increment.begin_stick = definition.stick.value * share();
    increment.begin_wrap_angle = capstan != nullptr ? capstan->wrap_angle * share() : 0.0;
    made.increments.push_back(increment);
  }
  return made;
}

}  // namespace slipbench::test
