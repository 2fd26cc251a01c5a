// SPDX-License-Identifier: Apache-2.0
// A fit file, read and checked: what is varied, against which measurements, and how.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/base/units/units.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::calibrate {

/// A column of a measured file: which, and how its numbers become those of the case:
///   value = factor * conversion(number) + offset.
struct DataColumn {
  std::string name;
  base::UnitConversion conversion;
  double factor = 1.0;  ///< [1]; -1 turns the sign
  double offset = 0.0;  ///< in the case's unit
};

/// One compared quantity of an experiment.
struct ResponseFit {
  std::string quantity_text;  ///< as the fit names it: "CSF1", "= -TF1"
  base::Expression quantity;  ///< over t, T, result columns and parameters of the case
  /// Names that `quantity` uses, in this order: t, T, a result column, or else a parameter of the
  /// case, whose value is that of the case at the unknowns (an offset may be fitted so).
  std::vector<std::string> variables;
  std::optional<base::Dimension> dimension =
      {};  ///< of a plain result column; unknown of an expression
  DataColumn column = {};
  double weight = 1.0;  ///< of the squared residual, >= 0
  /// Standard deviation of the measurement, in the case's unit, > 0.
  std::optional<double> sigma = {};
  std::optional<double> from = {};  ///< only rows with measured time in [from, to]
  std::optional<double> to = {};
  /// Result column that is compared over instead of time: loops against position, branch by branch.
  std::optional<std::string> over = {};
  DataColumn over_column = {};  ///< the data's column of it
  base::Dimension over_dimension = base::kLength;
};

/// Rows spread evenly in time, by linear interpolation.
struct Resampling {
  std::optional<double> every;  ///< time from one row to the next [T], > 0
  std::optional<int> points;    ///< or how many rows, >= 2
};
/// The mean of the whole cycles of a steady loop, as one cycle from the first whole one's start.
struct CycleAveraging {
  double period = 0.0;  ///< [T], > 0
  int points = 200;     ///< rows of the mean cycle
};
/// Rows at which a speed is below a threshold are left out.
struct DeadBand {
  DataColumn column;         ///< a speed [L/T], or a position when `of_position`
  bool of_position = false;  ///< the speed is the slope of a position over time
  double below = 0.0;        ///< speed, > 0
  base::Dimension speed = {.length = 1, .time = -1};
};

/// One measured history with the case that is to meet it.
struct ExperimentFit {
  std::string name;
  std::string case_file;  ///< as the user named it, relative to the fit's folder
  std::filesystem::path case_path;
  /// Of parameters of the case that are not varied; the last of a name counts. --set included.
  std::vector<base::ParameterText> settings;
  std::string data_file;  ///< as the user named it
  std::filesystem::path data_path;
  base::CsvFormat data_format = {};
  DataColumn time;
  std::vector<ResponseFit> responses;
  double weight = 1.0;         ///< of all squared residuals of the experiment, >= 0
  std::optional<double> from;  ///< only rows with measured time in [from, to], case's unit
  std::optional<double> to;
  std::optional<Resampling> resample;
  std::optional<CycleAveraging> average_cycles;
  std::optional<DeadBand> dead_band;
  bool held_out = false;  ///< scored, never fitted
  cases::Case base;       ///< the case at the start values
  base::SourcePosition where;
};

/// A parameter of the cases that is varied.
struct VariedParameter {
  std::string name;
  fit::UnknownRange range;  ///< start, bounds, scale
  base::SourcePosition where;
};

/// A table whose ordinates are varied.
struct VariedTable {
  std::string name;  ///< "sleeve.coefficient", as the fit names it
  enum class Use : std::uint8_t { kCoefficient, kInternalContactForce } use = Use::kCoefficient;
  std::string definition;   ///< name of the friction definition
  std::string free;         ///< the dependent column whose ordinates are varied: "mu", "force"
  fit::Shape shape;         ///< monotone, convex
  double smoothness = 0.0;  ///< >= 0, see docs/theory, section 17
  double lower = 0.0;       ///< bounds of every ordinate
  double upper = std::numeric_limits<double>::infinity();
  fit::Scale scale = fit::Scale::kLinear;
  base::SourcePosition where;
};

/// Input of `slipbench calibrate`.
struct Fit {
  std::string file;  ///< as the user typed it
  std::string title;
  std::filesystem::path folder;
  std::vector<ExperimentFit> experiments;  ///< fitted ones first, then those held out
  std::vector<VariedParameter> vary;
  std::vector<VariedTable> tables;
  fit::Loss loss;
  fit::SolverOptions solver;
  double confidence = 0.95;         ///< of intervals and bands, in (0, 1)
  int bootstrap = 0;                ///< resamplings; 0: none
  bool profile = false;             ///< profile likelihood of every parameter
  std::optional<std::string> date;  ///< as the user gave it, for the provenance

  std::string file_name() const { return std::filesystem::path(file).filename().string(); }
};

}  // namespace slipbench::driver::calibrate
