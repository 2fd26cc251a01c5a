// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "law/definition/limit_function.hpp"
#include "law/update/radial_return.hpp"
#include "law/update/snap_back.hpp"
#include "law/update/split_work.hpp"

namespace slipbench::law {

/// The return of the Euclidean norm. `LimitOf` is LimitFunction or KnownLimit.
template <int D, class LimitOf, Wanted kWants>
struct EuclideanReturn : RadialReturn<EuclideanReturn<D, LimitOf, kWants>, D, LimitOf, kWants> {
  using Base = RadialReturn<EuclideanReturn, D, LimitOf, kWants>;
  using Base::Base, Base::begin, Base::limit, Base::rest, Base::reach;
  using typename Base::End;
  static constexpr bool kSeesSlip = std::is_same_v<LimitOf, LimitFunction>;

  End end(FrictionUpdate* result) noexcept {
    End end = Base::end(result);
    // Wear that the spring cannot follow: has the force jumped on its way (theory 11.4)?
    if constexpr (kSeesSlip) {
      if (end.regime != Regime::kStick && may_snap_back(begin.definition)) {
        result->snap_back = largest_snap_back(limit, begin.stick, end.slip);
      }
    }
    return end;
  }

  void take_work(const End& end, FrictionUpdate* result) const noexcept {
    const Slip<D>& y_old = begin.force;
    if (end.regime == Regime::kStick) {
      result->work = 0.5 * (y_old + end.force).dot(begin.ds);
      return;
    }
    result->work = split_work<D>(y_old, this->trial_force(end.limit), end.force, begin.ds,
                                 end.limit.force, &result->onset);
    const bool opens = end.regime == Regime::kOpen;
    // Nothing holds at the end: what slipped on the way began at the limit before it.
    if (!(end.limit.force > 0.0)) {
      const Slip<D> from = begin.fixed ? y_old : load<D>(begin.old.elastic_slip);
      result->onset = limit_fraction<D>(from, begin.trial, begin.fixed ? rest.force : begin.stick);
    }
    if constexpr (kSeesSlip) {
      if (result->snap_back >= 1.0) {
        const double start = y_old.dot(end.direction);
        book_jumps(snap_back_path(limit, begin.stick, end.slip, start, opens), start, reach,
                   0.5 * y_old.squaredNorm() / begin.stick, result);
      }
    }
  }
};

}  // namespace slipbench::law
