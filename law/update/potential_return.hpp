// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// `update` for a definition whose criterion is a Potential: the associated return
///   y = y_tr - kappa dL dP/dy,   P(y) = F_lim(dL),
/// in both stick modes; with an elastic slip kappa = F_lim/g_c and the equivalent elastic slip is
/// measured by the potential itself (docs/theory, section 11.7). Where F_lim does not
/// exceed P(0) the force-free state is not admissible and the definition is open.
FrictionUpdate update_potential(const FrictionDefinition& definition,
                                const ConnectorIncrement& increment,
                                const FrictionState& old) noexcept;

/// Consistent tangent of `update_potential` in the scaled slip space, by implicit differentiation;
/// rows and columns beyond its dimension are 0 or not to be used.
struct PotentialTangent {
  Eigen::Matrix<double, kComponents, kComponents> to_slip;  ///< dy/ds [F/L]
  Eigen::Matrix<double, kComponents, 1> to_contact;         ///< dy/dF_C [1]
};
/// \param update what `update_potential` returned: its state, direction, slip and SlipTangent
PotentialTangent potential_tangent(const FrictionDefinition& definition,
                                   const FrictionUpdate& update) noexcept;

}  // namespace slipbench::law
