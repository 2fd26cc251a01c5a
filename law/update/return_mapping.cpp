// SPDX-License-Identifier: Apache-2.0
#include "law/update/return_mapping.hpp"

#include <cmath>

#include "law/update/capstan_update.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/potential_return.hpp"
#include "law/update/radial_return.hpp"
#include "law/update/snap_back.hpp"
#include "law/update/split_work.hpp"

namespace slipbench::law {
namespace {

/// The return of the Euclidean norm.
template <int D, bool kAll>
struct EuclideanReturn : RadialReturn<EuclideanReturn<D, kAll>, D, LimitFunction, kAll> {
  using Base = RadialReturn<EuclideanReturn, D, LimitFunction, kAll>;
  using Base::Base, Base::begin, Base::limit, Base::rest, Base::reach;
  using typename Base::End;

  End end(FrictionUpdate* result) noexcept {
    End end = Base::end(result);
    // Wear that the spring cannot follow: has the force jumped on its way (theory 11.4)?
    if (end.regime != Regime::kStick && may_snap_back(begin.definition)) {
      result->snap_back = largest_snap_back(limit, begin.stick, end.slip);
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
    if (opens) {
      const Slip<D> from = begin.fixed ? y_old : load<D>(begin.old.elastic_slip);
      result->onset = limit_fraction<D>(from, begin.trial, begin.fixed ? rest.force : begin.stick);
    }
    if (result->snap_back >= 1.0) {
      const double start = y_old.dot(end.direction);
      book_jumps(snap_back_path(limit, begin.stick, end.slip, start, opens), start, reach,
                 0.5 * y_old.squaredNorm() / begin.stick, result);
    }
  }
};

template <bool kAll>
FrictionUpdate update_with(const FrictionDefinition& definition,
                           const ConnectorIncrement& increment, const FrictionState& old) noexcept {
  if (definition.formulation) return update_penalty(definition, increment, old);
  switch (definition.criterion.index()) {
    case 1:
      return update_potential(definition, increment, old);
    case 2:
      return update_capstan(definition, increment, old);
    default:
      return in_dimension(definition.slip.dimension, [&](auto d) {
        return in_six_steps<EuclideanReturn<d, kAll>>(definition, increment, old);
      });
  }
}

double magnitude(const FrictionDefinition& definition, const SlipVector& v) noexcept {
  return definition.slip.dimension == 1 ? std::abs(v[0]) : std::sqrt(dot(v, v));
}

}  // namespace

FrictionUpdate update(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                      const FrictionState& old) noexcept {
  return update_with<true>(definition, increment, old);
}

FrictionUpdate update_force(const FrictionDefinition& definition,
                            const ConnectorIncrement& increment,
                            const FrictionState& old) noexcept {
  return update_with<false>(definition, increment, old);
}

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
