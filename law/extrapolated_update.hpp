// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/path_segment.hpp"
#include "law/regime_change.hpp"
#include "law/return_mapping.hpp"

namespace slipbench::law {

/// A straight segment by sub-increments of `update`, whose number grows 1, 2, 3, ... and whose
/// results are extrapolated to sub-increments of no length (Aitken and Neville; Deuflhard 1983 for
/// the implicit Euler method). Where that does not settle, as around a change of regime, the piece
/// is halved. For laws without a solution by events: Potential, viscous friction.
/// \param tolerance of force and slip as parts of limit and elastic slip, for each piece
/// \param[out] changes of regime, located to within the pieces; may be null
FrictionUpdate extrapolated_update(const FrictionDefinition& definition, const PathSegment& segment,
                                   const FrictionState& old, double tolerance,
                                   RegimeChanges* changes) noexcept;

}  // namespace slipbench::law
