// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/definition/friction_definition.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// One increment of a definition with a formulation. Pure, nothing is allocated, nothing is thrown.
///   viscous penalty    F* = C v,                 F = F* returned to the limit;
///   stiffness penalty  F* = F_prev + K_t v dt,   F = F* returned to the limit, F_prev = F;
/// then the filter of the output. The limit min(mu F_N, force limit) is that of V = |v|, or of V_1
/// and V_2 along the axes of an orthotropic law, with the normal force of the end of the increment
/// and an internal contact force of the slip at its start. The state's `elastic_slip` is
/// F/K_t before the filter, the stick memory; its `force` is what the contact gives behind it.
///
/// Where the limit vanishes the contact is open: force, memory and filter start again from 0; where
/// only the coefficient does, a filter just forgets.
/// An increment without duration has no speed, so its limit is that of V = 0. A viscous penalty
/// then holds the force it has, down to the limit; motion in no time puts it on the limit.
///
/// Slip is the plastic part of the motion, (F* - F)/K_t; as coded a filter leaves the rest, (1 -
/// alpha) of the motion, to no solver, and the work is not what is stored and dissipated. Under a
/// viscous penalty all motion is slip, and the regime says whether the force is on the limit.
/// `dissipation` is the power of the force before the filter, `work` that of the force behind it:
/// of a viscous force the product of its end, of a filtered one the trapezoid, else as `update`
/// takes it.
///
/// An orthotropic law reports the effective coefficient and limit in the direction of the force
/// before the filter (of the motion where there is none). A force limit bounds both axes; a
/// CoefficientBlend blends both coefficients from one start.
/// \param[out] detail may be null
FrictionUpdate update_penalty(const FrictionDefinition& definition,
                              const ConnectorIncrement& increment, const FrictionState& old,
                              PenaltyDetail* detail = nullptr) noexcept;

/// |F|/F_lim of a definition with a formulation, with two directions sqrt((F_1/a_1)^2 +
/// (F_2/a_2)^2), a_i = mu_i F_N, of the force given out: above 1 only behind a filter that smooths.
/// 0 where there is no force, infinity where there is one and its limit is 0.
/// \param detail of the same update
double limit_use(const FrictionDefinition& definition, const FrictionUpdate& update,
                 const PenaltyDetail& detail) noexcept;

}  // namespace slipbench::law
