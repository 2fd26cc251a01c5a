// SPDX-License-Identifier: Apache-2.0
#include "law/update/return_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "law/base/slip_vector.hpp"
#include "law/definition/limit_function.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/first_root.hpp"
#include "law/update/penalty_tangent.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/potential_return.hpp"
#include "law/update/snap_back.hpp"
#include "law/update/split_work.hpp"

namespace slipbench::law {
namespace {

/// Extent of what an update computes.
enum class Detail : std::uint8_t { kAll, kForce };

template <int D, Detail kDetail>
FrictionUpdate update_in(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                         const FrictionState& old) noexcept {
  constexpr bool kAll = kDetail == Detail::kAll;
  FrictionUpdate result;
  const bool fixed = definition.stick.mode == StickStiffness::Mode::kStiffness;

  // 1. The motion in the scaled slip space.
  Slip<D> ds;
  for (int i = 0; i < D; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int c = definition.slip.component[k];
    ds[i] = definition.slip.scale[k] * (increment.end.position[c] - increment.begin_position[c]);
  }
  const double motion = norm<D>(ds);
  const LimitFunction limit(definition, increment, old, motion);

  // 2. Predictor: all motion elastic; the limit without slip.
  const Slip<D> elastic = load<D>(old.elastic_slip);
  const Slip<D> y_old = load<D>(old.force);
  const Slip<D> s_trial = elastic + ds;
  const Limit at_rest = limit(0.0);
  result.state.accumulated_slip = old.accumulated_slip;

  const auto report = [&](const Limit& l) {
    result.contact_force = l.contact_force;
    result.normal_force = l.normal_force;
    result.mu = l.mu;
    result.limit = l.force;
    result.slip_rate = l.slip_rate;
    result.wear = l.wear;
  };

  // 3. Nothing to hold on to: start again from a stress-free state (docs/theory, section 11.5).
  //    A coefficient that vanishes only at rest still grips as soon as there is slip.
  if (!(at_rest.force > 0.0) &&
      (!(at_rest.normal_force > 0.0) || !(limit.at(0.0, limit.motion_rate(motion)).force > 0.0))) {
    report(at_rest);
    result.state.regime = Regime::kOpen;
    if constexpr (kAll) result.work = 0.5 * y_old.dot(ds);  // the force falls from y_old to 0
    return result;
  }

  const double kappa_or_g = definition.stick.value;
  Slip<D> y, s_elastic, y_trial;
  Slip<D> n = Slip<D>::Zero();
  Limit l = at_rest;
  double slip = 0.0;
  bool slips = false;
  double trial = 0.0;

  if (fixed) {
    // 4a. Admissibility and return mapping with constant kappa (docs/theory, section 11.4).
    const double kappa = kappa_or_g;
    y_trial = y_old + kappa * ds;
    trial = norm<D>(y_trial);
    slips = trial > at_rest.force * kLimitSlack;
    if (slips) {
      const double slope = limit.slope(at_rest);
      const bool implicit = limit.depends_on_slip();
      if (implicit) {
        slip = first_root(limit, trial, kappa);
        l = limit(slip);
      } else {
        slip = (trial - at_rest.force) / kappa;
        l.slip_rate = limit.rate(slip);
      }
      // The force is put on the limit; with the root at rounding accuracy both agree.
      if constexpr (kAll) {
        result.multiple_roots =
            -slope > kappa || (implicit && has_later_root(limit, trial, kappa, slip));
      }
      n = y_trial / trial;
      y = l.force * n;
      s_elastic = y / kappa;
    } else {
      if constexpr (kAll) {
        result.multiple_roots =
            -limit.slope(at_rest) > kappa ||
            (limit.depends_on_slip() && has_later_root(limit, trial, kappa, 0.0));
      }
      y = y_trial;
      s_elastic = y / kappa;
    }
  } else {
    // 4b. The same with the allowable elastic slip g_c: dL does not depend on F_lim, so the
    //     return is closed (docs/theory, section 11.3).
    const double g = kappa_or_g;
    const double q = norm<D>(s_trial);
    slips = q > g * kLimitSlack;
    if (slips) {
      slip = q - g;
      l = limit(slip);
      n = s_trial / q;
      s_elastic = g * n;
      y = l.force * n;
      trial = q;
    } else {
      s_elastic = s_trial;
      y = (l.force / g) * s_trial;
    }
    y_trial = (l.force / g) * s_trial;
  }

  // 4c. The slip has worn the limit away: the grip is lost at the first slip without limit, and
  //     what follows is no friction any more (docs/theory, section 11.5).
  bool opens = false;
  if (slips && !(l.force > 0.0)) {
    opens = true;
    slip = first_zero(limit, slip);
    y.setZero();
    s_elastic.setZero();
  }

  // 4d. Wear that the spring cannot follow: has the force jumped on its way (theory 11.4)?
  if (slips && may_snap_back(definition)) {
    result.snap_back = largest_snap_back(limit, kappa_or_g, slip);
  }

  // 5. The new state, bookkeeping and energy (docs/theory, section 13).
  report(l);
  store<D>(y, &result.state.force);
  store<D>(s_elastic, &result.state.elastic_slip);
  result.state.regime = opens ? Regime::kOpen : (slips ? Regime::kSlip : Regime::kStick);
  result.slip_increment = slip;
  result.state.accumulated_slip += slip;
  const double p = kAll || !slips ? norm<D>(y) : l.force;
  if constexpr (kAll) {
    result.dissipation = l.force * slip;
    result.stored_energy = 0.5 * y.dot(s_elastic);
    result.work = slips ? split_work<D>(y_old, y_trial, y, ds, l.force, &result.onset)
                        : 0.5 * (y_old + y).dot(ds);
    // Nothing holds at the end: what slipped on the way began at the limit before it.
    if (opens) {
      result.onset = fixed ? limit_fraction<D>(y_old, y_trial, at_rest.force)
                           : limit_fraction<D>(elastic, s_trial, kappa_or_g);
    }
    if (result.snap_back >= 1.0) {
      const double start = y_old.dot(n);
      book_jumps(snap_back_path(limit, kappa_or_g, slip, start, opens), start, trial,
                 0.5 * y_old.squaredNorm() / kappa_or_g, &result);
    }
    result.phi = (slips && fixed && !opens ? trial - kappa_or_g * slip : p) - l.force;
    if (motion > 0.0) store<D>(ds / motion, &result.motion_direction);
  }
  if (!slips && p > 0.0) n = y / p;
  if (slips || p > 0.0) store<D>(n, &result.direction);

  // 6. Consistent tangent (docs/theory, section 12, with wear and the rate of the relative motion).
  if (opens) return result;
  SlipTangent& t = result.tangent;
  const double by_rate = l.to_rate * limit.motion_in_rate();
  if (slips) {
    const double slope = limit.slope(l);
    if (fixed) {
      const double sum = kappa_or_g + slope;
      const double follow = sum != 0.0 ? kappa_or_g / sum : 0.0;
      t.transverse = l.force * kappa_or_g / trial;
      t.radial = slope * follow;
      t.rate = by_rate * follow;
      t.contact = l.to_contact * follow;
    } else {
      t.transverse = l.force / trial;
      t.radial = slope;
      t.rate = by_rate;
      t.contact = l.to_contact;
    }
  } else if (fixed) {
    t.transverse = t.radial = kappa_or_g;
  } else {
    t.transverse = t.radial = l.force / kappa_or_g;
    // y = (F_lim / g_c) s_trial also follows the limit, in proportion to |y| / F_lim.
    const double share = l.force > 0.0 ? p / l.force : 0.0;
    t.rate = by_rate * share;
    t.contact = l.to_contact * share;
  }
  return result;
}

template <Detail kDetail>
FrictionUpdate update_with(const FrictionDefinition& definition,
                           const ConnectorIncrement& increment, const FrictionState& old) noexcept {
  if (definition.formulation) return update_penalty(definition, increment, old);
  switch (definition.criterion.index()) {
    case 1:
      return update_potential(definition, increment, old);
    case 2:
      return update_capstan(definition, increment, old);
    default:
      break;
  }
  switch (definition.slip.dimension) {
    case 1:
      return update_in<1, kDetail>(definition, increment, old);
    case 2:
      return update_in<2, kDetail>(definition, increment, old);
    case 3:
      return update_in<3, kDetail>(definition, increment, old);
    case 4:
      return update_in<4, kDetail>(definition, increment, old);
    case 5:
      return update_in<5, kDetail>(definition, increment, old);
    default:
      return update_in<6, kDetail>(definition, increment, old);
  }
}

}  // namespace

FrictionUpdate update(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                      const FrictionState& old) noexcept {
  return update_with<Detail::kAll>(definition, increment, old);
}

FrictionUpdate update_force(const FrictionDefinition& definition,
                            const ConnectorIncrement& increment,
                            const FrictionState& old) noexcept {
  return update_with<Detail::kForce>(definition, increment, old);
}

namespace {

double magnitude(const FrictionDefinition& definition, const SlipVector& v) noexcept {
  if (definition.slip.dimension == 1) return std::abs(v[0]);
  double sum = 0.0;
  for (int k = 0; k < definition.slip.dimension; ++k) {
    const double entry = v[static_cast<std::size_t>(k)];
    sum += entry * entry;
  }
  return std::sqrt(sum);
}

}  // namespace

double equivalent_force(const FrictionDefinition& definition, const FrictionState& state) noexcept {
  // Shifts give P(0) > 0, but where nothing holds there is no force to speak of.
  if (state.regime == Regime::kOpen) return 0.0;
  const auto* potential = std::get_if<Potential>(&definition.criterion);
  return potential != nullptr ? value(*potential, state.force) : magnitude(definition, state.force);
}

double equivalent_elastic_slip(const FrictionDefinition& definition,
                               const FrictionState& state) noexcept {
  const auto* given = std::get_if<Potential>(&definition.criterion);
  if (given == nullptr) return magnitude(definition, state.elastic_slip);
  Potential potential = *given;
  potential.offset = {};
  for (PotentialLeaf& leaf : potential.leaf) leaf.center = 0.0;
  return value(potential, state.elastic_slip);
}

ConnectorForce friction_force(const FrictionDefinition& definition, const FrictionState& state) {
  ConnectorForce force;
  for (int i = 0; i < definition.slip.dimension; ++i) {
    const auto k = static_cast<std::size_t>(i);
    force[definition.slip.component[k]] = definition.slip.scale[k] * state.force[k];
  }
  return force;
}

}  // namespace slipbench::law
