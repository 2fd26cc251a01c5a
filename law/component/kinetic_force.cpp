// SPDX-License-Identifier: Apache-2.0
#include "law/component/kinetic_force.hpp"

namespace slipbench::law {

ElasticForce elastic_force(const KineticBehavior& behavior, int component,
                           const Ambient& ambient) noexcept {
  ElasticForce result;
  const auto i = static_cast<std::size_t>(component);
  if (const auto& own = behavior.elasticity[i]) {
    const ForcePoint point = own->value(ambient.motion[component], ambient);
    result.force = point.force;
    result.slope[i] = point.slope;
  } else if (behavior.coupled.components.contains(component)) {
    result.slope = behavior.coupled.stiffness[i];
    for (int j = 0; j < kComponents; ++j) {
      result.force += result.slope[static_cast<std::size_t>(j)] * ambient.motion[j];
    }
  }
  return result;
}

double elastic_energy(const KineticBehavior& behavior, int component,
                      const Ambient& ambient) noexcept {
  const double u = ambient.motion[component];
  if (const auto& own = behavior.elasticity[static_cast<std::size_t>(component)]) {
    return own->energy(u, ambient);
  }
  return 0.5 * u * elastic_force(behavior, component, ambient).force;
}

ForcePoint viscous_force(const KineticBehavior& behavior, int component, double velocity,
                         const Ambient& ambient) noexcept {
  const auto& damping = behavior.damping[static_cast<std::size_t>(component)];
  return damping ? damping->value(velocity, ambient) : ForcePoint{};
}

double kinetic_force(const KineticBehavior& behavior, int component, double velocity,
                     const Ambient& ambient) noexcept {
  return elastic_force(behavior, component, ambient).force +
         viscous_force(behavior, component, velocity, ambient).force;
}

void set_kinetic_forces(const KineticBehavior& behavior, ComponentSet which,
                        ConnectorIncrement* increment) noexcept {
  for (int c = 0; c < kComponents; ++c) {
    if (!which.contains(c)) continue;
    increment->force[c] = kinetic_force(behavior, c, mean_velocity(*increment, c), increment->end);
  }
}

ComponentSet components_of(const ContactForce& contact) {
  ComponentSet set;
  if (const auto* component = std::get_if<ComponentContactForce>(&contact)) {
    set.insert(component->component);
  } else if (const auto* derived = std::get_if<DerivedComponent>(&contact)) {
    for (const DerivedTerm& term : *derived) {
      for (int j = 0; j < term.count; ++j) set.insert(term.component[static_cast<std::size_t>(j)]);
    }
  } else if (std::holds_alternative<UniversalJointContact>(contact)) {
    set = ComponentSet::of(1, 2, 3, 5);
  }
  return set;
}

}  // namespace slipbench::law
