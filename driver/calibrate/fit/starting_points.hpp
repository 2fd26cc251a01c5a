// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/calibrate/fit/problem.hpp"

namespace slipbench::driver::fit {

/// Starts besides the given one: a low-discrepancy set (GSL's Sobol sequence up to 40 directions,
/// reverse Halton beyond), shifted modulo 1 by random numbers of the seed.
///
/// Between two finite bounds evenly, in the logarithm where the scale is one; otherwise by a factor
/// from 1/10 to 10 on the start's distance from its single bound, or from 0. The ordinates of a
/// block share one direction: nearly constant curves, at the height of some ordinate within its
/// bounds, tilted by 2 % the way the shape wants.
/// \return count starts
std::vector<std::vector<double>> starting_points(const ResidualProblem& problem, int count,
                                                 std::uint64_t seed);

}  // namespace slipbench::driver::fit
