// SPDX-License-Identifier: Apache-2.0
// One search for the least cost, from one start.
#pragma once

#include "driver/calibrate/fit/objective.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/calibrate/fit/trust_region.hpp"

namespace slipbench::driver::fit {

struct SearchEnd {
  SearchPoint point;  ///< the best one found
  double start_cost = 0.0;
  double offset = 0.0;      ///< see Linearisation, at the point
  int iterations = 0;       ///< that lowered the cost or the offset
  bool degenerate = false;  ///< some unknown, or a combination, has no effect at the point
  bool polished = false;
  bool at_kink = false;    ///< a minimum for any step, with a gradient that is not quite zero
  double step_left = 0.0;  ///< if > 0: below so much, in standard errors, is the step that is left
  StopReason stop = StopReason::kNoIteration;
  StopReason reached = StopReason::kNoIteration;  ///< `stop`, but for kNoIteration
};

/// Trust region with changing scalings, steps by QR, bounds taken up and given back, and a polish
/// without derivatives; until the point is a minimum by its own test, or nothing helps any more.
/// \param start coordinates of the map
/// \param scaling of the first round
/// \param at_start the start with its derivatives, if they are known; is used up
SearchEnd search(Evaluator& evaluator, const UnknownMap& map, std::span<const double> start,
                 const SolverOptions& options, TrustScaling scaling = TrustScaling::kMore,
                 SearchPoint* at_start = nullptr);

}  // namespace slipbench::driver::fit
