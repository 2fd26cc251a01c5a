// SPDX-License-Identifier: Apache-2.0
#include "law/update/return_mapping.hpp"

#include <cmath>

#include "law/update/capstan_update.hpp"
#include "law/update/euclidean_return.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/potential_return.hpp"

namespace slipbench::law {
namespace {

template <Wanted kWants>
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
        return in_six_steps<EuclideanReturn<d, LimitFunction, kWants>>(definition, increment, old);
      });
  }
}

double magnitude(const FrictionDefinition& definition, const SlipVector& v) noexcept {
  return definition.slip.dimension == 1 ? std::abs(v[0]) : std::sqrt(dot(v, v));
}

}  // namespace

FrictionUpdate update(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                      const FrictionState& old) noexcept {
  return update_with<Wanted::kAll>(definition, increment, old);
}

FrictionUpdate update_force(const FrictionDefinition& definition,
                            const ConnectorIncrement& increment,
                            const FrictionState& old) noexcept {
  return update_with<Wanted::kForce>(definition, increment, old);
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
