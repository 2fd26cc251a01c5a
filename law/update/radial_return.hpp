// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/update/first_root.hpp"
#include "law/update/six_steps.hpp"

namespace slipbench::law {

/// Return to |y| <= F_lim along the trial force: what the Euclidean norm and the belt have in
/// common. `LimitOf` is LimitFunction, KnownLimit or CapstanLimit; `Own` adds
///   take_work(end, &result)    work, onset
template <class Own, int D, class LimitOf, Wanted kWants>
struct RadialReturn : ReturnSteps<Slip<D>, LimitOf, kWants> {
  using Base = ReturnSteps<Slip<D>, LimitOf, kWants>;
  using Base::Base, Base::begin, Base::limit, Base::rest, Base::kWanted;
  using typename Base::Begin, typename Base::End, typename Base::Vector;

  End end(FrictionUpdate* result) noexcept {
    const double stick = begin.stick;
    const bool slips = reach > (begin.fixed ? rest.force : stick) * kLimitSlack;
    End end;
    end.limit = rest;
    Limit& l = end.limit;
    // Constant kappa: dL and F_lim may be implicit in each other (docs/theory, section 11.4). With
    // an elastic slip dL does not depend on F_lim: the return is closed (section 11.3).
    const bool implicit = begin.fixed && limit.depends_on_slip();
    if (slips) {
      end.slip = implicit      ? first_root(limit, reach, stick)
                 : begin.fixed ? (reach - rest.force) / stick
                               : reach - stick;
      if (begin.fixed && !implicit) {
        l.slip_rate = limit.rate(end.slip);
      } else {
        l = limit(end.slip);
      }
    }
    if (kWanted != Wanted::kForce && begin.fixed) {
      result->multiple_roots =
          -limit.slope(rest) > stick || (implicit && has_later_root(limit, reach, stick, end.slip));
    }
    if (!slips) {
      end.force = trial_force(l);
      end.elastic_slip = begin.fixed ? Vector(begin.trial / stick) : begin.trial;
      const double size = norm<D>(end.force);
      end.direction = size > 0.0 ? Vector(end.force / size) : Vector(Vector::Zero());
      return end;
    }
    end.direction = begin.trial / reach;
    if (l.force > 0.0 || slips_without_force(begin.fixed, limit, l, end.slip)) {
      // The force is put on the limit; with the root at rounding accuracy both agree.
      end.regime = Regime::kSlip;
      end.force = l.force * end.direction;
      end.elastic_slip = begin.fixed ? Vector(end.force / stick) : Vector(stick * end.direction);
    } else {
      // The grip is lost at the first slip without limit, and what follows is no friction any more
      // (docs/theory, section 11.5).
      end.regime = Regime::kOpen;
      end.slip = first_zero(limit, end.slip);
      end.force = end.elastic_slip = Vector::Zero();
    }
    return end;
  }

  void take_energies(const End& end, FrictionUpdate* result) const noexcept {
    result->dissipation = end.limit.force * end.slip;
    result->stored_energy = 0.5 * end.force.dot(end.elastic_slip);
    const bool returned = begin.fixed && end.regime == Regime::kSlip;
    result->phi =
        (returned ? reach - begin.stick * end.slip : norm<D>(end.force)) - end.limit.force;
    static_cast<const Own*>(this)->take_work(end, result);
  }

  /// With wear and the rate of the relative motion.
  SlipTangent tangent(const End& end) const noexcept {
    SlipTangent t;
    const Limit& l = end.limit;
    const double by_rate = l.to_rate * limit.motion_in_rate();
    if (end.regime == Regime::kSlip) {
      const double slope = limit.slope(l);
      const double sum = begin.stick + slope;
      const double follow = !begin.fixed ? 1.0 : (sum != 0.0 ? begin.stick / sum : 0.0);
      t.transverse = l.force * (begin.fixed ? begin.stick : 1.0) / reach;
      t.radial = slope * follow;
      t.rate = by_rate * follow;
      t.contact = l.to_contact * follow;
    } else if (begin.fixed) {
      t.transverse = t.radial = begin.stick;
    } else {
      t.transverse = t.radial = l.force / begin.stick;
      // y = (F_lim / g_c) s_trial also follows the limit, by |y| / F_lim = |s_trial| / g_c.
      const double share = reach / begin.stick;
      t.rate = by_rate * share;
      t.contact = l.to_contact * share;
    }
    return t;
  }

  /// y_trial at the limit of the end.
  Vector trial_force(const Limit& l) const noexcept {
    return begin.fixed ? begin.trial : Vector((l.force / begin.stick) * begin.trial);
  }

  const double reach = norm<D>(begin.trial);  ///< |trial|
};

}  // namespace slipbench::law
