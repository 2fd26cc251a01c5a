// SPDX-License-Identifier: Apache-2.0
#include "law/update/uniqueness.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "law/friction/law_list.hpp"
#include "law/update/snap_back.hpp"

namespace slipbench::law {
namespace {

/// mu before its floor over the rates from 0 (t = 0) to `rate` (t = 1), of a law that tells its
/// curve; such a law that is not bounded has no denominator.
ExponentialSum curve_over_rates(const FrictionLaw& law, double contact_force, double rate) {
  const SlipLine line{.end = rate, .rate_per_slip = 1.0, .force = contact_force};
  return visit_law(
      [&](const auto& l) {
        if constexpr (requires { l.along(line).numerator; }) return l.along(line).numerator;
        return ExponentialSum{};
      },
      law);
}

constexpr std::size_t kScanned = 65;

/// Returns rates from 0 to one, denser near 0.
std::array<double, kScanned> rates_up_to(double rate) {
  std::array<double, kScanned> rates{};
  for (std::size_t i = 0; i < kScanned; ++i) {
    const double part = static_cast<double>(i) / (kScanned - 1);
    rates[i] = part * part * part * rate;
  }
  return rates;
}

/// Returns true if all that is known of a law's bounds is what a scan finds.
bool has_scanned_bounds(const FrictionLaw& law) {
  return visit_law(
      [](const auto& l) {
        return !requires { l.largest(); };
      },
      law);
}

}  // namespace

double stick_stiffness(const FrictionDefinition& definition, double limit) {
  return definition.stick.mode == StickStiffness::Mode::kStiffness ? definition.stick.value
                                                                   : limit / definition.stick.value;
}

namespace {

CellRange cell_from(const Table& table, int independent, double begin) {
  const std::span<const double> knots = table.knots(independent);
  const auto next = std::upper_bound(knots.begin(), knots.end(), begin);
  return {begin, next == knots.end() ? begin : *next};
}

/// Returns the least |dP/dy|^2: that of one contribution alone is at least 1; where several slip
/// together, each takes part of P.
double least_square_of_normal(const FrictionDefinition& definition) {
  const auto* potential = std::get_if<Potential>(&definition.criterion);
  if (potential == nullptr) return 1.0;
  if (potential->combine == PotentialOperator::kMax) return 1.0 / potential->parts;
  return std::pow(potential->parts, std::min(2.0 / potential->exponent - 1.0, 0.0));
}

}  // namespace

SnapBack snap_back(const FrictionDefinition& definition) {
  if (definition.formulation || !may_snap_back(definition)) return {};
  SnapBack result;
  const auto& wear = std::get<TableFunction>(definition.internal_contact_force);
  const int column = wear.column_of(IndependentKind::kAccumulatedSlip);
  double slip = 0.0;
  result.fall = -wear.table().steepest_fall(column, 0, &slip);
  result.slip = cell_from(wear.table(), column, slip);
  result.along = least_square_of_normal(definition);
  return changed_snap_back(result, definition.law, definition.stick.value);
}

SnapBack changed_snap_back(const SnapBack& before, const FrictionLaw& law, double stiffness) {
  SnapBack result = before;
  result.growth = largest_growth(law);
  result.contact.reset();
  if (const auto* tabular = std::get_if<TabularCoefficient>(&law)) {
    const int contact = tabular->table.column_of(IndependentKind::kContactForce);
    if (contact >= 0) {
      double force = 0.0;
      tabular->table.table().largest_growth(contact, 0, &force);
      result.contact = cell_from(tabular->table.table(), contact, force);
    }
  }
  const bool bounded = std::isfinite(result.growth);
  result.ratio = bounded ? result.growth * result.fall / (result.along * stiffness) : 0.0;
  return result;
}

bool has_increment_thresholds(const FrictionDefinition& definition, const FrictionLaw& law) {
  return definition.stick.mode == StickStiffness::Mode::kStiffness &&
         definition.slip_rate == SlipRateMeasure::kSlip && depends_on_slip_rate(law);
}

CoefficientBounds coefficient_bounds(const FrictionLaw& law) {
  return {largest(law), std::max(steepest_weakening(law), 0.0)};
}

CoefficientBounds coefficient_bounds(const FrictionLaw& law, const Ambient& ambient,
                                     double contact_force, double rate) {
  CoefficientBounds found;
  if (has_scanned_bounds(law)) {
    const auto point = [&](double at) {
      return evaluate(law, ambient, {.slip_rate = at, .contact_force = contact_force});
    };
    const std::array<double, kScanned> places = rates_up_to(rate);
    found.largest = scanned_maximum(places, [&](double at) { return point(at).mu; });
    found.steepest_weakening =
        std::max(scanned_maximum(places, [&](double at) { return -point(at).to_slip_rate; }), 0.0);
    return found;
  }
  const CoefficientBounds over_all = coefficient_bounds(law);
  if (std::isfinite(over_all.largest) && std::isfinite(over_all.steepest_weakening)) {
    return over_all;
  }
  const auto look = [&](double at) {
    const CoefficientPoint point =
        evaluate(law, ambient, {.slip_rate = at, .contact_force = contact_force});
    if (!std::isfinite(point.mu)) return;
    found.largest = std::max(found.largest, point.mu);
    found.steepest_weakening = std::max(found.steepest_weakening, -point.to_slip_rate);
  };
  look(0.0);
  look(rate);
  // Between the ends the extremes of mu and of its slope lie where their slopes change sign, and
  // just before a fall ends on the floor.
  const ExponentialSum mu = curve_over_rates(law, contact_force, rate);
  const ExponentialSum slope = derivative(mu);
  ExponentialSum above_floor = mu;
  above_floor.add(polynomial({1.0}), -kCoefficientFloor);
  for (const ExponentialSum& sum : {slope, derivative(slope), above_floor}) {
    const SignChanges changes = sign_changes(sum, 0.0, 1.0);
    for (int i = 0; i < changes.count; ++i) {
      const double at = changes.at[static_cast<std::size_t>(i)] * rate;
      look(at * (1.0 - 1e-9));
    }
  }
  return found;
}

IncrementThresholds increment_thresholds(const FrictionDefinition& definition,
                                         const CoefficientBounds& bounds, const Ambient& end,
                                         double normal_force, double rate) {
  if (!has_increment_thresholds(definition, definition.law)) return {};
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
  CoefficientBounds here = bounds;
  if (!std::isfinite(bounds.largest) || !std::isfinite(bounds.steepest_weakening)) {
    const CoefficientBounds up_to = coefficient_bounds(definition.law, end, normal_force, rate);
    if (!std::isfinite(here.largest)) here.largest = up_to.largest;
    if (!std::isfinite(here.steepest_weakening)) here.steepest_weakening = up_to.steepest_weakening;
  }
  const double weakening = std::max(-point.to_slip_rate, 0.0);
  const double steepest = definition.blend.weight * here.steepest_weakening;
  const double largest_mu = blended(definition.blend, {here.largest, 0.0, 0.0}).mu;
  return {normal_force, weakening, 2.0 * per_stiffness(point.mu) * weakening,
          per_stiffness(std::max(largest_mu, point.mu)) * steepest};
}

}  // namespace slipbench::law
