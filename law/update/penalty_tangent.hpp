// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "law/definition/friction_definition.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// Consistent tangent of `update_penalty` in the scaled slip space, filter and clipping included;
/// rows and columns beyond its dimension are 0.
struct PenaltyTangent {
  Eigen::Matrix<double, kComponents, kComponents> to_slip;      ///< dy/ds [F/L]
  Eigen::Matrix<double, kComponents, 1> to_contact;             ///< dy/d(F_C + F_int) [1]
  Eigen::Matrix<double, kComponents, kComponents> to_position;  ///< dy_i/du_c through a table K(u)
};
/// \param update what `update_penalty` returned for this increment
PenaltyTangent penalty_tangent(const FrictionDefinition& definition,
                               const ConnectorIncrement& increment,
                               const FrictionUpdate& update) noexcept;

}  // namespace slipbench::law
