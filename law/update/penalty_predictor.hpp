// SPDX-License-Identifier: Apache-2.0
// The prediction of a contact penalty before its limit, and its two conventions.
#pragma once

#include "law/definition/formulation.hpp"

namespace slipbench::law {

/// C of a viscous penalty [F T/L] under a normal force [F]:
///   VISF sqrt(2 K m), as coded sqrt(VISF) sqrt(2 K m), or the number given.
struct ViscousCoefficient {
  double value = 0.0;
  double to_normal_force = 0.0;  ///< dC/dF_N [T/L], of a table K(F_N)
  double to_stiffness = 0.0;     ///< dC/dK [T], where K is a table
};
ViscousCoefficient viscous_coefficient(const ViscousPenalty& penalty, Convention convention,
                                       const Ambient& end, double normal_force) noexcept;

/// dF*/ds [F/L] of an increment: C/dt or K_t, as coded alpha K_t.
/// \param viscous C [F T/L]
/// \param duration dt [T]
/// \param alpha of the filter
/// \param motion |ds| [L]
/// \param widest the largest limit, > 0 [F]
double predictor_stiffness(const Formulation& formulation, double viscous, double duration,
                           double alpha, double motion, double widest) noexcept;

/// Tells whether the filter smooths the output: as coded a stiffness penalty scales its increment
/// instead.
bool smooths(const Formulation& formulation) noexcept;

/// As coded an orthotropic stiffness penalty does not return to the closest point.
bool uses_ratio_return(const Formulation& formulation) noexcept;

/// 1/dt; 0 of an increment without duration.
inline double inverse_duration(double duration) { return duration > 0.0 ? 1.0 / duration : 0.0; }

}  // namespace slipbench::law
