// SPDX-License-Identifier: Apache-2.0
#include "law/update/capstan_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/definition/capstan_limit.hpp"
#include "law/update/first_root.hpp"

namespace slipbench::law {
namespace {

/// Work of a force over a motion, and the part of the motion that is over when it meets its limit.
struct SplitWork {
  double work = 0.0;
  double onset = 0.0;
};

/// Of a force that rises along a straight line from y0 to `trial` over the motion ds and stops at
/// the limit z L, to be y1 at the end: the trapezoids of its two pieces.
SplitWork split_work(double y0, double trial, double y1, double ds, double z, double limit) {
  const double rise = z * (trial - y0);
  const double lambda = rise > 0.0 ? std::clamp((limit - z * y0) / rise, 0.0, 1.0) : 0.0;
  const double split = y0 + lambda * (trial - y0);
  return {0.5 * ds * (lambda * (y0 + split) + (1.0 - lambda) * (split + y1)), lambda};
}

void report(const Limit& limit, FrictionUpdate* result) {
  result->contact_force = limit.contact_force;
  result->normal_force = limit.normal_force;
  result->mu = limit.mu;
  result->limit = limit.force;
  result->slip_rate = limit.slip_rate;
}

}  // namespace

FrictionUpdate update_capstan(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment,
                              const FrictionState& old) noexcept {
  FrictionUpdate result;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;
  const double stick = definition.stick.value;  // kappa or g_c

  // 1. The flow over the ring.
  const int c = definition.slip.component[0];
  const double ds = increment.end.position[c] - increment.begin_position[c];
  const double y_old = old.force[0];
  const double s_old = old.elastic_slip[0];

  // 2. Predictor: all flow elastic. Its sign picks the side of the band.
  const double s_trial = s_old + ds;
  const double predictor = fixed ? y_old + stick * ds : s_trial;
  const double z = predictor < 0.0 ? -1.0 : 1.0;
  const CapstanLimit limit(definition, increment, std::abs(ds),
                           z > 0.0 ? FlowSense::kForward : FlowSense::kBackward);
  const Limit at_rest = limit(0.0);
  result.state.accumulated_slip = old.accumulated_slip;

  // 3. A slack belt, or no friction: nothing to hold on to. A coefficient that vanishes only at
  // rest
  //    still grips as soon as there is flow.
  if (!(at_rest.force > 0.0) && (!(at_rest.normal_force > 0.0) ||
                                 !(limit.at(0.0, limit.motion_rate(std::abs(ds))).force > 0.0))) {
    report(at_rest, &result);
    result.state.regime = Regime::kOpen;
    result.work = 0.5 * y_old * ds;  // the force falls from y_old to 0
    return result;
  }

  // 4. Admissibility and return to the limit of this side.
  Limit l = at_rest;
  double reach = std::abs(predictor);  // |y_trial|, or |s_trial| with an elastic slip
  const bool slips = reach > (fixed ? at_rest.force : stick) * kLimitSlack;
  double slip = 0.0;
  double y = 0.0;
  double s_elastic = 0.0;
  if (fixed) {
    const bool implicit = limit.depends_on_slip();
    if (slips && implicit) {
      slip = first_root(limit, reach, stick);
      l = limit(slip);
    } else if (slips) {
      slip = (reach - at_rest.force) / stick;
      l.slip_rate = limit.rate(slip);
    }
    result.multiple_roots =
        -limit.slope(at_rest) > stick || (implicit && has_later_root(limit, reach, stick, slip));
    y = slips ? z * l.force : predictor;
    s_elastic = y / stick;
  } else {
    if (slips) {
      slip = reach - stick;
      l = limit(slip);
    }
    s_elastic = slips ? z * stick : s_trial;
    y = slips ? z * l.force : (l.force / stick) * s_trial;
  }
  const double y_trial = fixed ? predictor : (l.force / stick) * s_trial;

  // 4b. A coefficient that vanishes at some rate of slip: the grip is lost (docs/theory,
  // section 11.5).
  const bool opens = slips && !(l.force > 0.0);
  if (opens) {
    slip = first_zero(limit, slip);
    y = s_elastic = 0.0;
  }

  // 5. The new state, bookkeeping and energy (docs/theory, section 13).
  report(l, &result);
  result.state.force[0] = y;
  result.state.elastic_slip[0] = s_elastic;
  result.state.regime = opens ? Regime::kOpen : (slips ? Regime::kSlip : Regime::kStick);
  result.state.accumulated_slip += slip;
  result.slip_increment = slip;
  result.dissipation = l.force * slip;
  result.stored_energy = 0.5 * y * s_elastic;
  if (!fixed && s_old * s_trial < 0.0) {
    // Through zero the elastic slip changes its stiffness: the force goes to zero on the old side's
    // line and rises on the new one's.
    const SplitWork rise = split_work(0.0, y_trial, y, s_trial, z, l.force);
    result.work = 0.5 * y_old * -s_old + rise.work;
    if (slips) result.onset = (s_trial * rise.onset - s_old) / ds;
  } else if (slips) {
    const SplitWork rise = split_work(y_old, y_trial, y, ds, z, l.force);
    result.work = rise.work;
    result.onset = rise.onset;
  } else {
    result.work = 0.5 * (y_old + y) * ds;
  }
  result.phi = (slips && fixed && !opens ? reach - stick * slip : std::abs(y)) - l.force;
  if (slips || y != 0.0) result.direction[0] = z;
  if (ds != 0.0) result.motion_direction[0] = ds < 0.0 ? -1.0 : 1.0;

  // 6. Consistent tangent: that of docs/theory, section 12, with the slopes of this side's limit.
  if (opens) return result;
  SlipTangent& t = result.tangent;
  const double by_rate = l.to_rate * limit.motion_in_rate();
  if (slips) {
    const double slope = limit.slope(l);
    const double sum = stick + slope;
    const double follow = !fixed ? 1.0 : (sum != 0.0 ? stick / sum : 0.0);
    t.transverse = l.force * (fixed ? stick : 1.0) / reach;
    t.radial = slope * follow;
    t.rate = by_rate * follow;
    t.contact = l.to_contact * follow;
  } else if (fixed) {
    t.transverse = t.radial = stick;
  } else {
    t.transverse = t.radial = l.force / stick;
    // y = (limit / g_c) s_trial also follows the limit, in proportion to |y| / limit.
    const double share = l.force > 0.0 ? std::abs(y) / l.force : 0.0;
    t.rate = by_rate * share;
    t.contact = l.to_contact * share;
  }
  return result;
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
