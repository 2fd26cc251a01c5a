// SPDX-License-Identifier: Apache-2.0
// The nearest curves of a wanted shape, for starts that do not have it.
#pragma once

#include <span>
#include <vector>

namespace slipbench::driver::fit {

/// The ascending sequence with the least sum of squared differences: isotonic regression by pooling
/// adjacent violators (Ayer et al. 1955).
std::vector<double> nearest_ascending(std::span<const double> values);

/// The greatest convex minorant of the points over ascending abscissae, raised by the mean
/// difference to them: not the nearest convex sequence, but one close by. Convex sequences are
/// returned as they are; ascending ones stay ascending.
std::vector<double> nearby_convex(std::span<const double> abscissa, std::span<const double> values);

}  // namespace slipbench::driver::fit
