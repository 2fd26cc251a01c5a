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

bool has_increment_thresholds(const FrictionDefinition& definition) {
  return definition.stick.mode == StickStiffness::Mode::kStiffness &&
         definition.slip_rate == SlipRateMeasure::kSlip && depends_on_slip_rate(definition.law);
}

CoefficientBounds coefficient_bounds(const FrictionLaw& law) {
  return {largest(law), std::max(steepest_weakening(law), 0.0)};
}

IncrementThresholds increment_thresholds(const FrictionDefinition& definition,
                                         const CoefficientBounds& bounds, const Ambient& end,
                                         double normal_force, double rate) {
  if (!has_increment_thresholds(definition)) return {};
  const CoefficientPoint point =
      blended(definition.blend,
              evaluate(definition.law, end, {.slip_rate = rate, .contact_force = normal_force}));
  // dF_lim/dmu, and the limit itself, of a belt in the sense in which it is larger.
  const auto* belt = std::get_if<Capstan>(&definition.criterion);
  const double limit = normal_force * (belt == nullptr ? point.mu
                                                       : capstan_limit(point.mu * belt->wrap_angle,
                                                                       FlowSense::kForward));
  if (!(normal_force > 0.0) || limit >= definition.force_limit) return {};
  // dF_lim/dmu over the stiffness. That of a belt grows with the coefficient: the steepest fall of
  // the limit is bounded with the largest.
  const auto per_stiffness = [&](double mu) {
    const double to_mu = belt == nullptr
                             ? normal_force
                             : normal_force * belt->wrap_angle *
                                   capstan_ratio(mu * belt->wrap_angle, FlowSense::kForward);
    return to_mu / definition.stick.value;
  };
  const double weakening = std::max(-point.to_slip_rate, 0.0);
  const double steepest = definition.blend.weight * bounds.steepest_weakening;
  const double largest_mu = blended(definition.blend, {bounds.largest, 0.0, 0.0}).mu;
  return {normal_force, weakening, 2.0 * per_stiffness(point.mu) * weakening,
          per_stiffness(std::max(largest_mu, point.mu)) * steepest};
}

}  // namespace slipbench::law
