// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/calibrate/fit/objective.hpp"

namespace slipbench::driver::fit {

/// Nelder and Mead's simplex (GSL's nmsimplex2) from a point where the gradient is of no use: a
/// kink. It begins with the edges of the Gauss-Newton step's size and is limited to 50 moves per
/// free coordinate; problems of more than 8 are left alone.
/// \return whether the cost fell, by more than rounding; `point` is then the lower one, with its
///         derivatives
bool simplex_polish(Objective& objective, SearchPoint& point);

}  // namespace slipbench::driver::fit
