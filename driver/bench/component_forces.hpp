// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "driver/case/case.hpp"
#include "law/base/compensated_sum.hpp"
#include "law/base/component.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::driver::bench {

/// The forces of one component beside friction, in the sign of result columns: in equilibrium
///   CEF + CVF + CSF + CRF - CCF = 0.
struct ComponentForces {
  double elastic = 0.0;   ///< CEF [F], [F L]
  double viscous = 0.0;   ///< CVF
  double reaction = 0.0;  ///< CRF, of a stop
  double applied = 0.0;   ///< CCF, the load of a component that is driven by force
};

/// The forces of all components, and the energies that belong to no friction definition.
struct ConnectorForces {
  std::array<ComponentForces, law::kComponents> component{};
  double elastic_energy = 0.0;              ///< of all springs [F L]
  law::CompensatedSum viscous_dissipation;  ///< of all dampers, since the start [F L]
  double kinetic_energy = 0.0;              ///< of the mass of a dynamic case [F L]
  double external_work = 0.0;    ///< of belt and loads of a dynamic case, since the start [F L]
  double velocity = 0.0;         ///< of its mass, of a driver's relative to it: dCP/dt [L/T]
  double driver_velocity = 0.0;  ///< of its driver [L/T]
  /// Kinetic forces of the free components that a contact force names (Case::kinetic.pressing):
  /// CEF + CVF + CRF - CCF, which in equilibrium is minus the friction of the component.
  law::ConnectorForce pressing;
};

/// Tells whether a case has such forces at all.
bool has_component_forces(const cases::Case& problem);

/// Springs and dampers at the end of an increment: sets CEF and CVF of every component, and the
/// elastic energy; adds the viscous dissipation, the force at the end over the motion of the
/// increment. Not for a SLIPRING, whose tension is its spring's.
/// \param mass the component of a dynamic case, whose forces the dynamics know: of it only the
///        elastic energy is taken; -1 for none
void take_springs_and_dampers(const cases::Case& problem, const law::ConnectorIncrement& increment,
                              ConnectorForces& forces, int mass = -1);

/// "CP1 = 0.3 is beyond the upper stop of component 1 at 0.25" for the first component that is
/// driven by its motion, that is not `solved`, beyond a stop by more than rounding.
std::optional<std::string> beyond_stop(const cases::Case& problem, law::ComponentSet solved,
                                       const law::RelativePosition& position);

}  // namespace slipbench::driver::bench
