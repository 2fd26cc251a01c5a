// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "law/connection/connection_type.hpp"
#include "law/definition/friction_definition.hpp"
#include "law/definition/potential_terms.hpp"
#include "law/friction/law_list.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/law_tables.hpp"

namespace slipbench::test {

/// Sizes of new units in old ones: a length of `length` old units is 1 new one.
struct Units {
  double length = 1.0;
  double force = 1.0;
  double time = 1.0;
};

/// A table with its rows, so that it can be written in other units.
struct TableRows {
  Rows rows;
  int dependents = 1;
  std::vector<law::Independent> independents;
  law::Extrapolation extrapolation = law::Extrapolation::kConstant;

  law::TableFunction build() const {
    return make_function(rows, independents, dependents, extrapolation);
  }
  bool depends_on(law::IndependentKind kind) const {
    return std::any_of(independents.begin(), independents.end(),
                       [&](const law::Independent& i) { return i.kind == kind; });
  }
};

/// A friction definition in terms that can be changed: other units, poison, rotation.
struct DefinitionDescription {
  std::string name;
  bool moment = false;  ///< the slip space is one of moments and angles
  law::SlipSpace slip;
  std::optional<law::Potential> potential;        ///< without one the Euclidean norm
  std::optional<law::Capstan> belt;               ///< in place of a potential
  law::ContactForce contact_force;                ///< weights of tables left at 0
  std::vector<std::optional<TableRows>> weights;  ///< of the terms of a derived component
  std::variant<double, TableRows> internal_contact_force = 0.0;
  std::variant<law::ConstantCoefficient, law::ExponentialDecay, law::GeneralizedViscous,
               law::ModifiedDarmstad, law::Renard, TableRows>
      law;
  double force_limit = law::kNoForceLimit;
  law::StickStiffness stick;
  law::AccumulatedSlipTiming accumulated_slip = law::AccumulatedSlipTiming::kEnd;
  law::SlipRateMeasure slip_rate = law::SlipRateMeasure::kSlip;
  law::CoefficientBlend blend;

  law::FrictionDefinition build() const {
    law::FrictionDefinition definition;
    definition.slip = slip;
    if (potential) definition.criterion = *potential;
    if (belt) definition.criterion = *belt;
    definition.contact_force = contact_force;
    if (auto* g = std::get_if<law::DerivedComponent>(&definition.contact_force)) {
      for (std::size_t t = 0; t < weights.size(); ++t) {
        if (weights[t]) (*g)[t].weight_table = weights[t]->build();
      }
    }
    if (const auto* rows = std::get_if<TableRows>(&internal_contact_force)) {
      definition.internal_contact_force = rows->build();
    } else {
      definition.internal_contact_force = std::get<double>(internal_contact_force);
    }
    definition.law = std::visit(
        [](const auto& one) -> law::FrictionLaw {
          if constexpr (std::is_same_v<decltype(one), const TableRows&>) {
            return law::TabularCoefficient{one.build()};
          } else {
            return one;
          }
        },
        law);
    definition.force_limit = force_limit;
    definition.stick = stick;
    definition.accumulated_slip = accumulated_slip;
    definition.slip_rate = slip_rate;
    definition.blend = blend;
    return definition;
  }

  bool rate_independent() const {
    if (const auto* rows = std::get_if<TableRows>(&law)) {
      return !rows->depends_on(law::IndependentKind::kSlipRate);
    }
    return std::holds_alternative<law::ConstantCoefficient>(law);
  }
  /// Tells whether P(-y) = P(y).
  bool symmetric() const {
    if (!potential) return true;
    return std::all_of(potential->leaf.begin(), potential->leaf.begin() + potential->leaves,
                       [](const law::PotentialLeaf& leaf) {
                         return leaf.kind != law::PotentialLeaf::Kind::kHalfLine &&
                                leaf.center == 0.0;
                       });
  }
  bool wears() const {
    const auto* rows = std::get_if<TableRows>(&internal_contact_force);
    return rows != nullptr && rows->depends_on(law::IndependentKind::kAccumulatedSlip);
  }
  std::vector<const TableRows*> tables() const {
    std::vector<const TableRows*> all;
    for (const auto& term : weights) {
      if (term) all.push_back(&*term);
    }
    if (const auto* rows = std::get_if<TableRows>(&internal_contact_force)) all.push_back(rows);
    if (const auto* rows = std::get_if<TableRows>(&law)) all.push_back(rows);
    return all;
  }
};

/// The units of a definition's own quantities.
struct SlipUnits {
  double slip = 1.0;   ///< of s: length or angle
  double force = 1.0;  ///< of y: force or moment
  double time = 1.0;
};
inline SlipUnits slip_units(const DefinitionDescription& d, const Units& u) {
  return d.moment ? SlipUnits{1.0, u.force * u.length, u.time}
                  : SlipUnits{u.length, u.force, u.time};
}
inline double motion_unit(int component, const Units& u) {
  return law::is_rotation(component) ? 1.0 : u.length;
}
inline double force_unit(int component, const Units& u) {
  return law::is_rotation(component) ? u.force * u.length : u.force;
}

/// Writes the independents of a table, and its dependents column by column, in other units.
inline TableRows in_units(TableRows table, const std::vector<double>& dependent_units,
                          const SlipUnits& own, const Units& units) {
  for (auto& row : table.rows) {
    for (std::size_t d = 0; d < dependent_units.size(); ++d) row[d] /= dependent_units[d];
    for (std::size_t k = 0; k < table.independents.size(); ++k) {
      double& x = row[dependent_units.size() + k];
      const law::Independent& independent = table.independents[k];
      switch (independent.kind) {
        case law::IndependentKind::kSlipRate:
          x /= own.slip / own.time;
          break;
        case law::IndependentKind::kContactForce:
          x /= own.force;
          break;
        case law::IndependentKind::kAccumulatedSlip:
          x /= own.slip;
          break;
        case law::IndependentKind::kPosition:
        case law::IndependentKind::kConstitutiveMotion:
          x /= motion_unit(independent.index, units);
          break;
        case law::IndependentKind::kTemperature:
        case law::IndependentKind::kField:
          break;
      }
    }
  }
  return table;
}

/// The same friction, all its numbers in other units.
inline DefinitionDescription in_units(DefinitionDescription d, const Units& units) {
  const SlipUnits own = slip_units(d, units);
  for (int i = 0; i < d.slip.dimension; ++i) {
    const auto k = static_cast<std::size_t>(i);
    d.slip.scale[k] /= force_unit(d.slip.component[k], units) / own.force;
  }
  if (d.potential) {
    for (double& offset : d.potential->offset) offset /= own.force;
    for (law::PotentialLeaf& leaf : d.potential->leaf) leaf.center /= own.force;
  }
  if (auto* g = std::get_if<law::DerivedComponent>(&d.contact_force)) {
    for (std::size_t t = 0; t < g->size(); ++t) {
      law::DerivedTerm& term = (*g)[t];
      std::vector<double> weight_units;
      for (std::size_t j = 0; j < static_cast<std::size_t>(term.count); ++j) {
        weight_units.push_back(own.force / force_unit(term.component[j], units));
        term.weight[j] /= weight_units.back();
      }
      if (t < d.weights.size() && d.weights[t]) {
        d.weights[t] = in_units(*d.weights[t], weight_units, own, units);
      }
    }
  } else if (auto* joint = std::get_if<law::UniversalJointContact>(&d.contact_force)) {
    for (double* length : {&joint->R_p, &joint->R_a, &joint->L_s, &joint->L_a}) {
      *length /= units.length;
    }
  }
  if (auto* rows = std::get_if<TableRows>(&d.internal_contact_force)) {
    *rows = in_units(*rows, {own.force}, own, units);
  } else {
    std::get<double>(d.internal_contact_force) /= own.force;
  }
  if (auto* rows = std::get_if<TableRows>(&d.law)) {
    *rows = in_units(*rows, {1.0}, own, units);
  } else if (auto* decay = std::get_if<law::ExponentialDecay>(&d.law)) {
    decay->decay *= own.slip / own.time;
  } else {
    // An area makes a pressure of forces and of moments alike.
    const double area = units.length * units.length;
    const double pressure = own.force / area;
    const double speed = own.slip / own.time;
    if (auto* viscous = std::get_if<law::GeneralizedViscous>(&d.law)) {
      viscous->c1 *= pressure;
      viscous->c2 *= speed;
      viscous->c3 *= pressure * speed;
      viscous->c4 *= pressure * pressure;
      viscous->c5 *= speed * speed;
      viscous->area = viscous->area.value_or(1.0) / area;
    } else if (auto* darmstad = std::get_if<law::ModifiedDarmstad>(&d.law)) {
      darmstad->c1 *= pressure * pressure;
      darmstad->c3 *= pressure;
      for (double* exponent : {&darmstad->c2, &darmstad->c4, &darmstad->c6}) *exponent *= speed;
      darmstad->area = darmstad->area.value_or(1.0) / area;
    } else if (auto* renard = std::get_if<law::Renard>(&d.law)) {
      renard->speed_factor *= speed;  // the constants stay in their own unit
    }
  }
  d.force_limit /= own.force;
  d.stick.value /=
      d.stick.mode == law::StickStiffness::Mode::kElasticSlip ? own.slip : own.force / own.slip;
  return d;
}

/// A table of random ragged blocks over the given independents.
/// \param low, high range of the ordinates
inline TableRows random_table(Dice* dice, std::vector<law::Independent> independents,
                              int dependents, double low, double high) {
  TableRows table;
  table.dependents = dependents;
  table.independents = std::move(independents);
  table.extrapolation =
      dice->chance(0.3) ? law::Extrapolation::kLinear : law::Extrapolation::kConstant;
  const auto range = [](law::IndependentKind kind) -> std::pair<double, double> {
    switch (kind) {
      case law::IndependentKind::kSlipRate:
      case law::IndependentKind::kAccumulatedSlip:
        return {0.0, 5.0};
      case law::IndependentKind::kContactForce:
        return {0.0, 200.0};
      case law::IndependentKind::kTemperature:
        return {0.0, 100.0};
      default:
        return {-1.0, 1.0};
    }
  };
  std::vector<double> x(table.independents.size());
  const auto fill = [&](const auto& self, std::size_t levels) -> void {
    if (levels == 0) {
      std::vector<double> row;
      for (int c = 0; c < dependents; ++c) row.push_back(dice->between(low, high));
      row.insert(row.end(), x.begin(), x.end());
      table.rows.push_back(row);
      return;
    }
    const std::size_t level = levels - 1;
    const auto [begin, end] = range(table.independents[level].kind);
    const int least = table.extrapolation == law::Extrapolation::kLinear ? 2 : 1;
    const int count = least + dice->pick(3);
    for (int i = 0; i < count; ++i) {
      // One coordinate a slice, so that they ascend and differ.
      x[level] = begin + (end - begin) * (i + dice->between(0.0, 0.9)) / count;
      self(self, level);
    }
  };
  fill(fill, x.size());
  return table;
}

/// Radioss laws with floors, joints and inflections among slip rates of about 1 and contact forces
/// of about 100.
inline law::GeneralizedViscous random_viscous(Dice* dice) {
  const auto some = [&](double size) {
    return dice->chance(0.7) ? dice->between(-size, size) : 0.0;
  };
  law::GeneralizedViscous law;
  law.fric = dice->between(0.05, 0.5);
  law.c1 = some(1e-3);
  law.c2 = some(0.2);
  law.c3 = some(1e-3);
  law.c4 = some(5e-6);
  law.c5 = some(0.05);
  law.area = dice->between(0.5, 2.0);
  return law;
}
inline law::ModifiedDarmstad random_darmstad(Dice* dice) {
  const auto some = [&](double size) {
    return dice->chance(0.7) ? dice->between(-size, size) : 0.0;
  };
  law::ModifiedDarmstad law;
  law.fric = dice->between(0.05, 0.4);
  law.c1 = some(2e-5);
  law.c2 = dice->between(-4.0, 0.003);
  law.c3 = some(2e-3);
  law.c4 = dice->between(-4.0, 0.003);
  law.c5 = some(0.4);
  law.c6 = dice->between(-4.0, 0.003);
  law.area = dice->between(0.5, 2.0);
  return law;
}
inline law::Renard random_renard(Dice* dice) {
  law::Renard law;
  law.c4 = dice->chance(0.1) ? 0.0 : dice->between(0.02, 0.2);
  law.c1 = law.c4 + dice->between(0.0, 0.2);
  law.c2 = law.c4 + (law.c4 > 0.0 && dice->chance(0.1) ? 0.0 : dice->between(0.01, 0.2));
  law.c3 = std::max(law.c1, law.c2) + dice->between(0.0, 0.2);
  law.c5 = dice->between(0.05, 1.0);
  law.c6 = law.c5 + dice->between(0.05, 2.0);
  law.speed_factor = dice->chance(0.5) ? 1.0 : dice->between(0.2, 5.0);
  return law;
}

/// The same for histories of any speed: neither so high that exp(mu alpha) of a belt overflows, nor
/// on the floor, where a limit of 1e-30 F_N lies below the rounding of every force, nor with
/// exponentials that fall below the normal range of doubles.
inline law::GeneralizedViscous sturdy_viscous(Dice* dice) {
  law::GeneralizedViscous law;
  law.fric = dice->between(0.05, 0.5);
  law.c4 = dice->between(0.0, 5e-6);
  law.c5 = dice->between(0.0, 2e-6);
  // Each parabola keeps a third of Fric at its vertex at most.
  law.c1 = dice->between(-1.0, 1.0) * std::sqrt(4.0 / 3.0 * law.fric * law.c4);
  law.c2 = dice->between(-1.0, 1.0) * std::sqrt(4.0 / 3.0 * law.fric * law.c5);
  law.c3 = dice->between(0.0, 1e-6);
  law.area = dice->between(0.5, 2.0);
  return law;
}
inline law::ModifiedDarmstad sturdy_darmstad(Dice* dice) {
  law::ModifiedDarmstad law = random_darmstad(dice);
  for (double* factor : {&law.c1, &law.c3}) *factor = std::abs(*factor);
  for (double* exponent : {&law.c2, &law.c4, &law.c6}) *exponent = dice->between(-0.1, 0.0);
  law.c5 = std::max(law.c5, -0.5 * law.fric);
  return law;
}

/// Up to three different independents out of a list.
inline std::vector<law::Independent> some_of(Dice* dice, std::vector<law::Independent> list) {
  std::vector<law::Independent> chosen;
  const int count = 1 + dice->pick(3);
  for (int i = 0; i < count && !list.empty(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(dice->pick(static_cast<int>(list.size())));
    chosen.push_back(list[static_cast<std::size_t>(at)]);
    list.erase(list.begin() + at);
  }
  return chosen;
}

/// Contents that random definitions may have.
struct DefinitionOptions {
  std::vector<int> table_motions = {1, 2, 3, 4, 5, 6};  ///< components tables may depend on, 1..6
};

/// Kinds of definitions: the checks of all predefined types, then user-defined.
struct DefinitionKind {
  std::string name;
  law::SlipSpace slip;
  law::ContactForce contact_force;
};

/// The checks of all types with predefined friction, with random parameters.
inline std::vector<DefinitionKind> predefined_kinds(Dice* dice) {
  std::vector<DefinitionKind> kinds;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    if constexpr (law::HasPredefinedFriction<Type>) {
      Type type;
      const auto set = [&](auto& member, bool required) {
        if constexpr (std::is_same_v<decltype(member), double&>) {
          member = required || dice->chance(0.8) ? dice->between(0.1, 2.0) : 0.0;
        }
      };
      std::apply([&](const auto&... field) { (set(type.*(field.member), field.required), ...); },
                 Type::fields());
      for (const law::PredefinedFriction& friction : type.predefined()) {
        // Belts have a limit on either side: property/capstan_property_test.
        if (!std::holds_alternative<law::EuclideanPotential>(friction.criterion)) continue;
        kinds.push_back({std::string(Type::kInfo.name) + " " + std::string(friction.suffix),
                         friction.slip, friction.contact_force});
      }
    }
  });
  return kinds;
}
/// The predefined checks (PLANAR and UJOINT have two), user-defined friction, the same with a
/// potential that is not the Euclidean norm.
inline constexpr int kUserKind = 10;
inline constexpr int kPotentialKind = 11;
inline constexpr int kDefinitionKinds = 12;

inline DefinitionKind user_kind(Dice* dice) {
  DefinitionKind kind{"user-defined", {}, law::NoContactForce{}};
  kind.slip.dimension = 0;
  while (kind.slip.dimension == 0) {
    for (int c = 0; c < law::kComponents; ++c) {
      if (!dice->chance(0.4)) continue;
      const auto i = static_cast<std::size_t>(kind.slip.dimension++);
      kind.slip.component[i] = c;
      kind.slip.scale[i] = dice->between(0.2, 2.0);
    }
  }
  return kind;
}

/// Potential and slip space over random components, each in one place: lines, half lines, norms,
/// sums of several in one contribution, shifts.
inline void add_potential(Dice* dice, DefinitionDescription* d) {
  using Function = law::ContributionFunction;
  const std::vector<double> exponents = {1.0, 1.0, 1.1, 1.5, 2.0, 3.0, 4.3, 20.0};
  while (!d->potential) {
    std::vector<law::PotentialContribution> contributions;
    int c = 0;
    while (c < law::kComponents) {
      if (dice->chance(0.3)) {
        ++c;
        continue;
      }
      law::PotentialContribution contribution;
      contribution.scale = dice->between(0.2, 2.0);
      contribution.function = dice->chance(0.8) ? Function::kAbs : Function::kMacauley;
      const bool shifted = dice->chance(0.15);
      if (dice->chance(0.5)) {
        contribution.of = c++;
        if (shifted) contribution.shift = dice->between(-3.0, 3.0);
      } else {
        law::DerivedComponent derived;
        const bool sum = dice->chance(0.2);
        const int terms = 1 + dice->pick(2);
        for (int t = 0; t < terms && c < law::kComponents; ++t) {
          law::DerivedTerm term;
          term.combine = sum ? law::TermOperator::kSum
                             : (dice->chance(0.7) ? law::TermOperator::kNorm
                                                  : law::TermOperator::kMacauleySum);
          const int count = 1 + dice->pick(3);
          for (int j = 0; j < count && c < law::kComponents; ++j) {
            const auto k = static_cast<std::size_t>(term.count++);
            term.component[k] = c++;
            term.weight[k] = dice->between(0.2, 2.0) * (dice->chance(0.3) ? -1.0 : 1.0);
          }
          derived.push_back(term);
        }
        contribution.of = derived;
        if (shifted && contribution.function == Function::kMacauley) {
          contribution.shift = dice->between(-3.0, 3.0);
        }
      }
      contributions.push_back(std::move(contribution));
    }
    if (contributions.empty()) continue;
    const law::BuiltPotential built = law::build_potential(
        contributions,
        dice->chance(0.2) ? law::PotentialOperator::kMax : law::PotentialOperator::kSum,
        dice->one_of(exponents));
    if (const auto* potential = std::get_if<law::Potential>(&built.criterion)) {
      d->slip = built.slip;
      d->potential = *potential;
    }
  }
}

/// Weights or contact component of a user-defined definition.
inline void add_user_contact(Dice* dice, const DefinitionOptions& options,
                             DefinitionDescription* d) {
  const int choice = dice->pick(4);
  if (choice == 0) return;
  if (choice == 1) {
    d->contact_force = law::ComponentContactForce{(d->moment ? 3 : 0) + dice->pick(3)};
    return;
  }
  law::DerivedComponent g;
  const bool sums = dice->chance(0.3);
  const int terms = 1 + dice->pick(3);
  std::vector<law::Independent> motions;
  for (const int number : options.table_motions) {
    motions.push_back(over_position(number));
    motions.push_back(over_motion(number));
  }
  motions.push_back(kOverTemperature);
  motions.push_back(over_field(1));
  for (int t = 0; t < terms; ++t) {
    law::DerivedTerm term;
    term.combine =
        sums ? law::TermOperator::kSum
             : (dice->chance(0.5) ? law::TermOperator::kNorm : law::TermOperator::kMacauleySum);
    term.sign = sums && dice->chance(0.5) ? -1.0 : 1.0;
    for (int c = 0; c < law::kComponents; ++c) {
      if (!dice->chance(0.5)) continue;
      const auto j = static_cast<std::size_t>(term.count++);
      term.component[j] = c;
      term.weight[j] = dice->between(-1.0, 1.0);
    }
    d->weights.emplace_back();
    if (term.count > 0 && dice->chance(0.4)) {
      d->weights.back() = random_table(dice, some_of(dice, motions), term.count, -1.0, 1.0);
    }
    g.push_back(term);
  }
  d->contact_force = g;
}

/// A random friction definition of the given kind (0 .. kDefinitionKinds-1).
inline DefinitionDescription random_definition(Dice* dice, int kind,
                                               const DefinitionOptions& options = {}) {
  DefinitionDescription d;
  const bool user = kind >= kUserKind;
  const DefinitionKind base =
      user ? user_kind(dice) : predefined_kinds(dice).at(static_cast<std::size_t>(kind));
  d.name = base.name;
  d.slip = base.slip;
  d.contact_force = base.contact_force;
  if (kind == kPotentialKind) {
    d.name = "potential";
    add_potential(dice, &d);
  }
  // A slip space is one of moments if it has no translation; CYLINDRICAL measures its moment as
  // the force m1/R.
  d.moment = std::all_of(d.slip.component.begin(), d.slip.component.begin() + d.slip.dimension,
                         [](int c) { return law::is_rotation(c); });
  if (user) add_user_contact(dice, options, &d);

  std::vector<law::Independent> internal = {kOverAccumulatedSlip, kOverAccumulatedSlip,
                                            kOverTemperature, over_field(0)};
  for (const int number : options.table_motions) {
    internal.push_back(over_position(number));
    internal.push_back(over_motion(number));
  }
  internal.erase(internal.begin());
  switch (dice->pick(3)) {
    case 0:
      d.internal_contact_force = user ? dice->between(1.0, 80.0) : 0.0;
      break;
    case 1:
      d.internal_contact_force = dice->between(0.0, 80.0);
      break;
    default:
      d.internal_contact_force =
          random_table(dice, some_of(dice, internal), 1, dice->chance(0.2) ? 0.0 : 20.0, 120.0);
  }
  switch (dice->pick(6)) {
    case 0:
      d.law = law::ConstantCoefficient{dice->chance(0.05) ? 0.0 : dice->between(0.05, 0.9)};
      break;
    case 1: {
      const double kinetic = dice->between(0.0, 0.4);
      d.law = law::ExponentialDecay{kinetic + dice->between(0.0, 0.3), kinetic,
                                    dice->between(0.0, 2.0)};
      break;
    }
    case 2:
      d.law = sturdy_viscous(dice);
      break;
    case 3:
      d.law = sturdy_darmstad(dice);
      break;
    case 4:
      d.law = random_renard(dice);
      break;
    default:
      d.law = random_table(dice,
                           some_of(dice, {kOverSlipRate, kOverContactForce, kOverTemperature,
                                          over_field(0), over_field(1)}),
                           1, 0.05, 0.6);
  }
  if (dice->chance(0.25)) d.force_limit = dice->between(1.0, 30.0);
  d.stick = dice->chance(0.5) ? law::StickStiffness{law::StickStiffness::Mode::kElasticSlip,
                                                    dice->between(0.002, 0.1)}
                              : law::StickStiffness{law::StickStiffness::Mode::kStiffness,
                                                    dice->between(200.0, 5000.0)};
  if (dice->chance(0.4)) d.accumulated_slip = law::AccumulatedSlipTiming::kStart;
  if (dice->chance(0.4)) d.slip_rate = law::SlipRateMeasure::kRelativeMotion;
  if (dice->chance(0.2)) d.blend = {dice->between(0.0, 0.6), dice->between(0.0, 1.0)};
  return d;
}

/// A random belt over a ring; the tension is the force of component 1.
inline DefinitionDescription random_belt(Dice* dice) {
  DefinitionDescription d = random_definition(dice, 0);
  d.name = "belt";
  d.moment = false;
  d.slip = law::slip_space({2});
  d.contact_force = law::ComponentContactForce{0};
  d.weights.clear();
  d.internal_contact_force = 0.0;
  // A coefficient of hundreds, as linear extrapolation may give, has no finite exponential.
  if (auto* table = std::get_if<TableRows>(&d.law)) {
    table->extrapolation = law::Extrapolation::kConstant;
  }
  d.belt =
      law::Capstan{dice->chance(0.05) ? 0.0 : dice->between(0.0, dice->chance(0.2) ? 20.0 : 4.0)};
  return d;
}

}  // namespace slipbench::test
