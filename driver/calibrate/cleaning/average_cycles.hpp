// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "driver/calibrate/cleaning/data_rows.hpp"

namespace slipbench::driver::cleaning {

/// The mean of several cycles of a steady loop.
struct MeanCycle {
  DataRows rows;                ///< one cycle, over the times of the first
  std::vector<double> scatter;  ///< of each column: rms deviation of the cycles from their mean
};

/// Returns how many whole cycles there are from a first to a last time. A cycle whose end is missed
/// by no more than `step`, the time between two rows, counts: its last row is the one before the
/// next cycle's first.
std::size_t whole_cycles(double first, double last, double period, double step);

/// Interpolates every cycle at the phases 0, 1/points, ..., (points - 1)/points and takes the mean.
/// Phases inside a gap are taken from the cycles that have them, and left out if none has.
/// \param first time at which the first cycle begins [T]
/// \param period of a cycle [T], > 0
/// \param cycles how many there are, see whole_cycles
/// \param points >= 1
MeanCycle mean_cycle(const DataRows& rows, double first, double period, std::size_t cycles,
                     int points);

}  // namespace slipbench::driver::cleaning
