// SPDX-License-Identifier: Apache-2.0
#include "law/definition/admissible_definition.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "law/friction/law_list.hpp"

namespace slipbench::law {
namespace {

bool is_positive(double x) { return x > 0.0 && std::isfinite(x); }
bool is_not_negative(double x) { return x >= 0.0 && std::isfinite(x); }
bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}
bool is_component(int index) { return index >= 0 && index < kComponents; }

/// A table of so many dependents; without rows it has none.
bool has_columns(const TableFunction& function, int dependents) {
  return function.table().rows() > 0 && function.table().dependents() == dependents;
}
bool is_admissible(const std::variant<double, TableFunction>& number_or_table) {
  if (const double* number = std::get_if<double>(&number_or_table)) return is_not_negative(*number);
  return has_columns(std::get<TableFunction>(number_or_table), 1);
}

bool is_admissible(const FrictionLaw& law) {
  return visit_law(
      [](const auto& one) {
        if constexpr (requires { one.table.table(); }) {
          return has_columns(one.table, 1);
        } else if constexpr (requires { one.speed_factor; }) {
          return is_positive(one.speed_factor);
        } else {
          return true;
        }
      },
      law);
}

bool is_admissible(const SlipSpace& slip) {
  if (slip.dimension < 1 || slip.dimension > kComponents) return false;
  std::array<bool, kComponents> used{};
  for (int k = 0; k < slip.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!is_component(slip.component[i]) || !is_positive(slip.scale[i])) return false;
    bool& seen = used[static_cast<std::size_t>(slip.component[i])];
    if (seen) return false;
    seen = true;
  }
  return true;
}

/// Each entry of the slip space belongs to one leaf at most, and only a potential without shifts is
/// homogeneous.
bool is_admissible(const Potential& potential, int dimension) {
  if (!(potential.exponent >= 1.0) || !all_finite(potential.offset)) return false;
  if (!std::isfinite(potential.exponent)) return false;
  const auto shifts = [](double offset) { return offset != 0.0; };
  if (potential.homogeneous &&
      std::any_of(potential.offset.begin(), potential.offset.end(), shifts))
    return false;
  if (potential.parts < 1 || potential.parts > kComponents) return false;
  if (potential.leaves < 1 || potential.leaves > kComponents) return false;
  std::array<bool, kComponents> used{};
  for (int g = 0; g < potential.leaves; ++g) {
    const PotentialLeaf& leaf = potential.leaf[static_cast<std::size_t>(g)];
    if (leaf.part < 0 || leaf.part >= potential.parts) return false;
    if (!is_positive(leaf.factor) || !std::isfinite(leaf.center)) return false;
    if (!all_finite(leaf.direction) || (potential.homogeneous && leaf.center != 0.0)) return false;
    bool any = false;
    for (std::size_t k = 0; k < used.size(); ++k) {
      if (leaf.direction[k] == 0.0) continue;
      if (used[k] || static_cast<int>(k) >= dimension) return false;
      any = used[k] = true;
    }
    if (!any) return false;
  }
  return true;
}

bool is_admissible(const SlipCriterion& criterion, int dimension) {
  if (const auto* belt = std::get_if<Capstan>(&criterion)) {
    return is_not_negative(belt->wrap_angle);
  }
  const auto* potential = std::get_if<Potential>(&criterion);
  return potential == nullptr || is_admissible(*potential, dimension);
}

bool is_admissible(const DerivedTerm& term) {
  if (term.count < 0 || term.count > kComponents || std::abs(term.sign) != 1.0) return false;
  if (!all_finite(term.weight)) return false;
  const bool components =
      std::all_of(term.component.begin(), term.component.begin() + term.count, is_component);
  return components && (!term.weight_table || has_columns(*term.weight_table, term.count));
}

bool is_admissible(const ContactForce& contact) {
  if (const auto* component = std::get_if<ComponentContactForce>(&contact)) {
    return is_component(component->component);
  }
  if (const auto* terms = std::get_if<DerivedComponent>(&contact)) {
    return std::all_of(terms->begin(), terms->end(),
                       [](const DerivedTerm& term) { return is_admissible(term); });
  }
  if (const auto* joint = std::get_if<UniversalJointContact>(&contact)) {
    return (joint->axis == 1 || joint->axis == 3) && is_positive(joint->R_p) &&
           is_not_negative(joint->R_a) && is_not_negative(joint->L_s) && is_positive(joint->L_a);
  }
  return true;
}

bool is_admissible(const Filter& filter) {
  switch (filter.kind) {
    case Filter::Kind::kNone:
      return std::isfinite(filter.value);
    case Filter::Kind::kSimple:
      return is_positive(filter.value) && filter.value <= 1.0;
    default:
      return is_positive(filter.value);
  }
}

bool is_admissible(const Formulation& formulation, int dimension) {
  if (const auto* viscous = std::get_if<ViscousPenalty>(&formulation.penalty)) {
    if (!is_not_negative(viscous->visf) || !is_not_negative(viscous->mass)) return false;
    if (!is_admissible(viscous->stiffness)) return false;
    if (viscous->coefficient && !is_not_negative(*viscous->coefficient)) return false;
  } else if (!is_positive(std::get<StiffnessPenalty>(formulation.penalty).stiffness)) {
    return false;
  }
  if (!is_admissible(formulation.filter)) return false;
  if (!formulation.orthotropy) return true;
  const auto& [x, y] = formulation.orthotropy->first;
  // A unit vector, but for the rounding of its entries.
  return dimension == 2 && std::abs(x * x + y * y - 1.0) < 1e-9 &&
         is_admissible(formulation.orthotropy->second);
}

}  // namespace

bool is_admissible(const FrictionDefinition& definition) {
  const int dimension = definition.slip.dimension;
  const CoefficientBlend& blend = definition.blend;
  return is_admissible(definition.slip) && is_admissible(definition.criterion, dimension) &&
         is_admissible(definition.contact_force) &&
         is_admissible(definition.internal_contact_force) && is_admissible(definition.law) &&
         is_not_negative(blend.start) && blend.weight >= 0.0 && blend.weight <= 1.0 &&
         definition.force_limit > 0.0 && is_positive(definition.stick.value) &&
         (!definition.formulation || is_admissible(*definition.formulation, dimension));
}

}  // namespace slipbench::law
