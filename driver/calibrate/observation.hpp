// SPDX-License-Identifier: Apache-2.0
// Places of a run where a measurement is met.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "driver/calibrate/measurements.hpp"
#include "driver/calibrate/replay.hpp"

namespace slipbench::driver::calibrate {

/// The places of a run that measured points are compared with.
struct Observations {
  std::string fault;                  ///< why there are none; empty if there are
  std::vector<std::size_t> kept;      ///< of the measured points, those that the run reaches
  std::vector<Replay::Point> points;  ///< as many: where the run meets them
};

/// The rows of a run with total times `run` that have the measured times between them.
/// Points before the first row and behind the last one, but for rounding, are left out.
Observations observe_times(std::span<const double> run, std::span<const double> measured);

/// The same for loops: a measured point is met where the run has its position on the same monotone
/// branch. Branches are matched in order (driver/check/curves/branches.hpp); turns by no more than
/// 1e-3 of the range are noise of the measured positions, and so are a first or last branch of no
/// more than 2 % of the range where the numbers of branches differ otherwise. That noise only
/// decides what is a turn: branches end at the very row of the extreme position, and rows behind it
/// belong to the next one. Of the run, only the time between the first and the last measured point
/// counts.
///
/// Left out are points beyond the end of their branch, those before the start of the first branch
/// or behind the end of the last one, and those of which nothing tells on which side of a turn they
/// were measured: at a measured turn that is no turn of the run, or as near to one as the measured
/// positions go back inside their branches, unless the run has that very position at their time.
///
/// \param time, position of the rows of the run
///
/// Faults: different numbers of branches, opposite directions.
Observations observe_positions(std::span<const double> time, std::span<const double> position,
                               const MeasuredSeries& measured);

/// The values of a column of a run at some points.
void read_points(std::span<const double> column, std::span<const Replay::Point> points,
                 std::span<double> values);

}  // namespace slipbench::driver::calibrate
