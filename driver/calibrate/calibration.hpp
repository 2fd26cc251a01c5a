// SPDX-License-Identifier: Apache-2.0
// Findings of a calibration: everything that is printed, drawn and written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "driver/calibrate/fit.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/calibrate/fit/statistics.hpp"
#include "driver/calibrate/outliers.hpp"

namespace slipbench::driver::calibrate {

/// Measured and modelled values of one compared quantity, at the compared points.
struct FittedResponse {
  std::string quantity;
  std::string unit;  ///< of the quantity, empty if the case states none
  std::string over;  ///< result column the loops are compared over; empty: time
  std::string over_unit;
  std::vector<double> time;      ///< [T]
  std::vector<double> abscissa;  ///< of loops, as long; empty over time
  std::vector<double> measured;
  std::vector<double> before;  ///< the model at the start values
  std::vector<double> after;   ///< and at the optimum
  double rmse_before = 0.0;    ///< in the quantity's unit
  double rmse_after = 0.0;
  double range = 0.0;       ///< of the measured values
  double mean_error = 0.0;  ///< of `after`: a bias
  /// Correlation of the residual from one point to the next, without outliers; near 0 is noise.
  double autocorrelation = 0.0;
  Outliers outliers;               ///< of `after`
  std::vector<std::size_t> lines;  ///< of the data file, as many as outliers; empty if not known
  /// For the picture of a loop where the comparison is over time: a result column with the motion
  /// of the force, and the model's values of it at the compared points; empty if there is none.
  std::string position;
  std::string position_unit;
  std::vector<double> positions;
};

struct FittedExperiment {
  std::size_t index = 0;  ///< in Fit::experiments
  std::size_t rows_read = 0;
  std::size_t rows_used = 0;
  std::vector<std::string> cleaning;  ///< what was done to the data, a sentence each
  std::string data_hash;              ///< SHA-256 of the data file, hexadecimal
  double share_of_cost = 0.0;         ///< [1]
  std::vector<FittedResponse> responses;
};

/// Power of the data to tell an unknown's value.
enum class Identifiability : std::uint8_t {
  kGood,
  kWeak,         ///< the interval is wider than the value, or its bounds; or lost in a combination
  kNeverVisited  ///< no compared point depends on it: kept at its start, or moved by others
};

/// One unknown: a parameter, or an ordinate of a table.
struct FittedUnknown {
  std::string name;  ///< "mu", or "sleeve.coefficient[3].mu"
  std::string unit;
  fit::UnknownRange range;
  double value = 0.0;
  Identifiability identifiability = Identifiability::kGood;
  std::string why;          ///< a sentence where it is not kGood
  std::int64_t visits = 0;  ///< compared points that depend on it
  bool tied = false;        ///< to others by smoothness
  std::string moved_by;     ///< without any data: "`monotone: decreasing`"; empty if it was not
  std::string
      held_by;  ///< against the data: the shape that leaves it no room; empty if it has some
  double distance_to_lower = 0.0;  ///< as a part of the range of the bounds; infinite without one
  double distance_to_upper = 0.0;
};

/// A fitted table.
struct FittedTable {
  std::size_t index = 0;          ///< in Fit::tables
  std::size_t first_unknown = 0;  ///< its ordinates are consecutive unknowns, in the rows' order
  std::size_t count = 0;
  fit::Shape shape = {};                    ///< that its blocks are to have
  std::vector<std::string> columns;         ///< independents' names, fastest first
  std::vector<std::string> units = {};      ///< theirs; empty texts where none is stated
  std::vector<std::vector<double>> points;  ///< independents of each row
  struct Cell {
    std::string text;         ///< "slip_rate 0 .. 10, temperature 20 .. 90"
    std::int64_t visits = 0;  ///< increments of the fitted experiments
    /// These only ran along its edge: an ordinate at one of its corners is unseen.
    bool edge_only = false;
    bool visited() const { return visits > 0 && !edge_only; }
  };
  std::vector<Cell> cells;
};

struct Calibration {
  std::vector<FittedUnknown> unknowns;  ///< parameters in the fit's order, then tables' ordinates
  std::vector<FittedTable> tables;
  std::vector<FittedExperiment> experiments;  ///< in the fit's order, those held out last
  fit::ResidualProblem problem;               ///< refers to the calibration's models
  fit::LeastSquaresFit fit;
  fit::FitStatistics statistics;
  fit::Bootstrap bootstrap;                      ///< done = 0 if not asked for
  std::vector<fit::LikelihoodProfile> profiles;  ///< empty if not asked for
  std::string derivatives;                       ///< how they were found, a sentence
  std::vector<std::string> notes;                ///< what the user should look at, a sentence each
  double seconds = 0.0;
};

}  // namespace slipbench::driver::calibrate
