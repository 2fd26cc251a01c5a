// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "driver/calibrate/calibration.hpp"

namespace slipbench::driver::calibrate {

/// The points of a response that are drawn: all, or of many those of thinned_rows, so that
/// the curves, and the residuals before and after, cover the same area as all of them would.
struct DrawnPoints {
  std::vector<double> time;
  std::vector<double> position;  ///< as long; empty if the response has none
  std::vector<double> measured;
  std::vector<double> before;
  std::vector<double> after;
  bool thinned = false;
};

/// Axis of the loops of a response: that it is compared over, else its position.
struct LoopAxis {
  std::string name;  ///< empty: no loop
  std::string unit;
};
LoopAxis loop_axis(const FittedResponse& response);

/// \param limit how many points there may be, about
DrawnPoints drawn_points(const FittedResponse& response, std::size_t limit);

}  // namespace slipbench::driver::calibrate
