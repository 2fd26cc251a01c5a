// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "law/component/kinetic_force.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// The tangent at the connector: how the friction forces of all six components change with the
/// motion at the end of the increment and with the constraint forces at its end. Both are
/// unsymmetric in general: the contact force, table weights and internal contact forces over
/// position, and the angles of a universal joint are all in it.
struct ConnectorTangent {
  Eigen::Matrix<double, kComponents, kComponents> to_motion;  ///< df_i/du_j
  Eigen::Matrix<double, kComponents, kComponents> to_force;   ///< df_i/df_j (constraint force j)
};
ConnectorTangent connector_tangent(const FrictionDefinition& definition,
                                   const ConnectorIncrement& increment,
                                   const FrictionUpdate& update);

/// The slopes dF_c/du_j of the kinetic forces that press (`behavior.pressing`, of components driven
/// by their motion) to the motion at the end of the increment: stiffness, and damping over the
/// duration. Rows of other components are 0. With them the tangent to the motion is
/// to_motion + to_force * slopes.
Eigen::Matrix<double, kComponents, kComponents> kinetic_slopes(
    const KineticBehavior& behavior, const ConnectorIncrement& increment) noexcept;

}  // namespace slipbench::law
