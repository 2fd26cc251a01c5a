// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "law/return_mapping.hpp"

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

}  // namespace slipbench::law
