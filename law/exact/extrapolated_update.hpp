// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "law/exact/path_segment.hpp"
#include "law/exact/regime_change.hpp"
#include "law/update/return_mapping.hpp"

namespace slipbench::law {

/// A straight segment by sub-increments of backward Euler, whose number grows 1, 2, 3, ... and
/// whose results are extrapolated to sub-increments of no length (Aitken and Neville; Deuflhard
/// 1983 for the implicit Euler method), piece by piece: in a piece all of them have one signature
/// (sub_increment.hpp), and where that changes is bisected down to rounding. For laws without a
/// solution by events: Potential, viscous friction. `snap_back` is the largest at the ends of the
/// sub-increments.
/// \param tolerance of force and slip as parts of limit and elastic slip, for each piece
/// \param[out] changes of regime, may be null
FrictionUpdate extrapolated_update(const FrictionDefinition& definition, const PathSegment& segment,
                                   const FrictionState& old, double tolerance,
                                   RegimeChanges* changes) noexcept;

}  // namespace slipbench::law
