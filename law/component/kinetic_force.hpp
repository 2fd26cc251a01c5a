// SPDX-License-Identifier: Apache-2.0
// Springs and dampers along the free components of a connector: they act beside friction, and press
// where a contact force names a free component (docs/theory, sections 6 and 13.4).
#pragma once

#include <array>
#include <optional>

#include "law/component/damping.hpp"
#include "law/component/elasticity.hpp"
#include "law/contact/contact_force.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::law {

/// Linear springs that join components: CEF_i = sum_j K_ij u_j with K symmetric and positive
/// semidefinite, 0 outside of `components`.
struct CoupledStiffness {
  ComponentSet components;
  std::array<std::array<double, kComponents>, kComponents> stiffness{};  ///< [F/L], [F], [F L]
};

/// The springs and dampers of all components. A component has a spring of its own, or is one of the
/// coupled ones.
struct KineticBehavior {
  std::array<std::optional<Elasticity>, kComponents> elasticity{};
  std::array<std::optional<Damping>, kComponents> damping{};
  CoupledStiffness coupled;
  /// Free components that a contact force of the connector names: their force is wanted. Empty
  /// where no contact force does.
  ComponentSet pressing;

  bool is_elastic(int component) const {
    return elasticity[static_cast<std::size_t>(component)].has_value() ||
           coupled.components.contains(component);
  }
  bool is_damped(int component) const {
    return damping[static_cast<std::size_t>(component)].has_value();
  }
};

/// The elastic force of one component and its slopes dCEF/du_j.
struct ElasticForce {
  double force = 0.0;                       ///< CEF [F], [F L]
  std::array<double, kComponents> slope{};  ///< to the displacement of each component
};
ElasticForce elastic_force(const KineticBehavior& behavior, int component,
                           const Ambient& ambient) noexcept;

/// Returns the energy of one component's springs [F L]; of coupled ones u_i CEF_i/2, so that the
/// sum over the components is that of all springs.
double elastic_energy(const KineticBehavior& behavior, int component,
                      const Ambient& ambient) noexcept;

/// Returns CVF of one component at a velocity [L/T], [1/T], and its slope to it.
ForcePoint viscous_force(const KineticBehavior& behavior, int component, double velocity,
                         const Ambient& ambient) noexcept;

/// Returns the kinetic force CEF + CVF of a component that is driven by its motion: its total force
/// without friction.
double kinetic_force(const KineticBehavior& behavior, int component, double velocity,
                     const Ambient& ambient) noexcept;

/// Returns the mean velocity of a component over an increment [L/T], [1/T]; 0 without a duration.
inline double mean_velocity(const ConnectorIncrement& increment, int component) {
  const double motion = increment.end.position[component] - increment.begin_position[component];
  return increment.duration > 0.0 ? motion / increment.duration : 0.0;
}

/// Sets `increment.force` of the components `which` to their kinetic forces at the end of the
/// increment, at its mean velocity.
void set_kinetic_forces(const KineticBehavior& behavior, ComponentSet which,
                        ConnectorIncrement* increment) noexcept;

/// Returns the components whose force a contact force sees.
ComponentSet components_of(const ContactForce& contact);

}  // namespace slipbench::law
