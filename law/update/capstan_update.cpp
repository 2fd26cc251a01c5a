// SPDX-License-Identifier: Apache-2.0
#include "law/update/capstan_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/definition/capstan_limit.hpp"
#include "law/update/radial_return.hpp"

namespace slipbench::law {
namespace {

/// Work of a force that rises along a straight line from y0 to `trial` over the motion ds and stops
/// at the limit z L, to be y1 at the end: the trapezoids of its two pieces.
/// \param[out] onset the part of the motion that is over when it meets its limit
double split_work(double y0, double trial, double y1, double ds, double z, double limit,
                  double* onset) {
  const double rise = z * (trial - y0);
  const double lambda = rise > 0.0 ? std::clamp((limit - z * y0) / rise, 0.0, 1.0) : 0.0;
  const double split = y0 + lambda * (trial - y0);
  *onset = lambda;
  return 0.5 * ds * (lambda * (y0 + split) + (1.0 - lambda) * (split + y1));
}

/// The return of a belt: the predictor's sign picks the side of the band.
struct BeltReturn : RadialReturn<BeltReturn, 1, CapstanLimit, Wanted::kAll> {
  using RadialReturn::RadialReturn;

  static CapstanLimit limit_of(const Begin& b) noexcept {
    return {b.definition, b.increment, b.motion,
            b.trial[0] < 0.0 ? FlowSense::kBackward : FlowSense::kForward};
  }

  void take_work(const End& end, FrictionUpdate* result) const noexcept {
    const bool slips = end.regime != Regime::kStick;
    const double y_old = begin.force[0];
    const double s_old = begin.old.elastic_slip[0];
    const double trial = begin.trial[0];
    const double z = trial < 0.0 ? -1.0 : 1.0;
    const double y_trial = trial_force(end.limit)[0];
    const double y = end.force[0];
    if (!begin.fixed && s_old * trial < 0.0) {
      // Through zero the elastic slip changes its stiffness: the force goes to zero on the old
      // side's line and rises on the new one's.
      double onset = 0.0;
      result->work =
          0.5 * y_old * -s_old + split_work(0.0, y_trial, y, trial, z, end.limit.force, &onset);
      if (slips) result->onset = (trial * onset - s_old) / begin.ds[0];
    } else if (slips) {
      result->work = split_work(y_old, y_trial, y, begin.ds[0], z, end.limit.force, &result->onset);
    } else {
      result->work = 0.5 * (y_old + y) * begin.ds[0];
    }
    // A force of 0 does not tell where its slip began.
    if (slips && !begin.fixed && !(end.limit.force > 0.0)) {
      result->onset = std::clamp((z * begin.stick - s_old) / begin.ds[0], 0.0, 1.0);
    }
  }
};

}  // namespace

FrictionUpdate update_capstan(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment,
                              const FrictionState& old) noexcept {
  return in_six_steps<BeltReturn>(definition, increment, old);
}

FrictionUpdate judge_capstan(const FrictionDefinition& definition,
                             const ConnectorIncrement& increment, double tension_behind) noexcept {
  FrictionUpdate result;
  // A slack belt carries nothing, however negative the tension that is asked of it.
  const double tension =
      std::max(evaluate(definition.contact_force, increment.force, increment.end), 0.0);
  const double y = tension_behind - tension;
  const CapstanLimit limit(definition, increment, 0.0,
                           y < 0.0 ? FlowSense::kBackward : FlowSense::kForward);
  const Limit l = limit(0.0);
  report(l, &result);
  result.state.force[0] = y;
  result.phi = std::abs(y) - l.force;
  if (y != 0.0) result.direction[0] = y < 0.0 ? -1.0 : 1.0;
  const double wrap_angle = std::get_if<Capstan>(&definition.criterion)->wrap_angle;
  const bool no_friction = !(l.force > 0.0) && y == 0.0;
  if (no_friction || (!(tension > 0.0) && !(tension_behind > 0.0))) {
    result.state.regime = Regime::kOpen;
  } else {
    const bool sticks = capstan_utilisation(result, wrap_angle) < 1.0;
    result.state.regime = sticks ? Regime::kStick : Regime::kSlip;
  }
  return result;
}

double capstan_utilisation(const FrictionUpdate& update, double wrap_angle) noexcept {
  const double tension = update.contact_force;
  const double change = update.state.force[0];
  if (change == 0.0) return 0.0;
  const double mu_alpha = update.mu * wrap_angle;
  // ln(f_bc / f_ab) = log1p(y / T), accurate where both tensions are nearly equal.
  if (!(tension > 0.0) || !(tension + change > 0.0) || !(mu_alpha > 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  const double by_angle = std::abs(std::log1p(change / tension)) / mu_alpha;
  // A force limit below the band holds less than the angle would.
  const FlowSense sense = change < 0.0 ? FlowSense::kBackward : FlowSense::kForward;
  if (!(update.limit < tension * capstan_limit(mu_alpha, sense))) return by_angle;
  return std::max(by_angle, std::abs(change) / update.limit);
}

double tension_behind(const FrictionUpdate& update) noexcept {
  return std::max(std::max(update.contact_force, 0.0) + update.state.force[0], 0.0);
}

}  // namespace slipbench::law
