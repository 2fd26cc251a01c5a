// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/definition/friction_definition.hpp"
#include "law/definition/increment.hpp"
#include "law/update/ellipse_return.hpp"

namespace slipbench::law {

/// The two limits of an orthotropic law along its axes.
struct AxisLimits {
  PlaneVector motion{};                          ///< ds along the axes [L]
  PlaneVector speed{};                           ///< V_1, V_2 [L/T]
  PlaneVector mu{};                              ///< [1]
  PlaneVector bound{};                           ///< a_i [F]
  PlaneVector to_contact{};                      ///< da_i/d(F_C + F_int)
  PlaneVector to_speed{};                        ///< da_i/dV_i [F T/L]
  std::array<PlaneVector, 2> speed_to_motion{};  ///< dV_i/d(ds_j) [1/T]
};

/// The limits of an orthotropic definition in an increment.
/// \param ds0, ds1 the motion in the slip space [L], \param contact_force F_C + F_int, signed [F]
AxisLimits axis_limits(const FrictionDefinition& definition, const ConnectorIncrement& increment,
                       double ds0, double ds1, double contact_force) noexcept;

/// Entries of the slip space along the axes d1, d2, and back. An entry of the size of the rounding
/// counts as none: along an axis that hardly holds anything it would be far outside.
PlaneVector along_axes(const PlaneVector& d, double x, double y) noexcept;
PlaneVector from_axes(const PlaneVector& d, const PlaneVector& v) noexcept;

}  // namespace slipbench::law
