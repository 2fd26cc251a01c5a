// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "driver/calibrate/cleaning/data_rows.hpp"

namespace slipbench::driver::cleaning {

/// Number of rows on either side of a row that its slope is taken from: enough that the noise of
/// one row does not pass for motion.
inline constexpr int kSlopeReach = 4;

/// The slope of values over time at every row: of the line with the least squares through the row
/// and up to kSlopeReach neighbours on either side.
/// \param time [T], ascending
/// \param values [X], as many
/// \return [X/T]; empty for fewer than two rows
std::vector<double> slopes(std::span<const double> time, std::span<const double> values);

/// The rows whose speed has at least the magnitude `below`, with gaps where others were left out.
/// \param speed of every row
DataRows without_slow_rows(const DataRows& rows, std::span<const double> speed, double below);

}  // namespace slipbench::driver::cleaning
