// SPDX-License-Identifier: Apache-2.0
#include "law/uniqueness.hpp"

#include <algorithm>

namespace slipbench::law {

double stick_stiffness(const FrictionDefinition& definition, double limit) {
  return definition.stick.mode == StickStiffness::Mode::kStiffness ? definition.stick.value
                                                                   : limit / definition.stick.value;
}

SnapBack snap_back(const FrictionDefinition& definition) {
  const auto* wear = std::get_if<TableFunction>(&definition.internal_contact_force);
  if (wear == nullptr || definition.stick.mode != StickStiffness::Mode::kStiffness) return {};
  const int column = wear->column_of(IndependentKind::kAccumulatedSlip);
  if (column < 0) return {};
  SnapBack result{largest_growth(definition.law), -wear->table().steepest_fall(column), 0.0};
  result.ratio = result.growth * result.fall / definition.stick.value;
  return result;
}

bool may_be_negative(const ContactForce& contact) {
  if (std::holds_alternative<ComponentContactForce>(contact)) return true;
  const auto* derived = std::get_if<DerivedComponent>(&contact);
  return derived != nullptr &&
         std::any_of(derived->begin(), derived->end(), [](const DerivedTerm& term) {
           return term.combine == TermOperator::kSum || term.sign < 0.0;
         });
}

double uniqueness_threshold(const FrictionLaw& law, double normal_force, double stiffness) {
  return normal_force * steepest_weakening(law) / stiffness;
}

}  // namespace slipbench::law
