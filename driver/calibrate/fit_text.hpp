// SPDX-License-Identifier: Apache-2.0
// A fit as it is written: the structs beside whose members every key of a fit file is declared.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/base/units/parameters.hpp"
#include "driver/calibrate/cleaning/resample.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/read/keys/data_source_text.hpp"
#include "driver/yaml/binding.hpp"
#include "driver/yaml/declare_codec.hpp"

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

template <>
struct EnumWords<fit::Scale> {
  static constexpr std::array<std::string_view, 2> kWords{"linear", "log"};
};
template <>
struct EnumWords<fit::Shape::Monotone> {
  static constexpr std::array<std::string_view, 3> kWords{"free", "increasing", "decreasing"};
};
template <>
struct EnumWords<fit::Shape::Curvature> {
  static constexpr std::array<std::string_view, 3> kWords{"free", "convex", "concave"};
};

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::calibrate {

/// The keys that say how the numbers of a data column become those of the case.
template <class Text, class V>
void declare_conversion(V& key) {
  key("unit", &Text::unit, {.text = "Unit of the column.", .default_text = "the case's"});
  key("factor", &Text::factor,
      {.text = "Every number is multiplied by it, after the change of unit; -1 turns the "
               "sign.",
       .default_text = "1"});
  key("offset", &Text::offset,
      {.text = "Is added to every number, in the case's unit.", .default_text = "0"});
}

/// A column of a data file: its name, or its name and how its numbers are converted.
struct DataColumnText {
  yaml::At<std::string> column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0);

  static void declare(auto& key) {
    key("column", &DataColumnText::column, {.required = true, .text = "Name of the column."});
    declare_conversion<DataColumnText>(key);
  }
};

/// A result column with the data column that belongs to it; the name alone if both are called so.
struct OverColumnText {
  yaml::At<std::string> quantity, column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0);

  static void declare(auto& key) {
    key("quantity", &OverColumnText::quantity,
        {.required = true, .text = "Result column of a position, such as CP1."});
    key("column", &OverColumnText::column,
        {.text = "The data's column of it.", .default_text = "the one of the same name"});
    declare_conversion<OverColumnText>(key);
  }
};

/// Comparison of one quantity of the result.
struct CompareText {
  yaml::At<std::string> column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0),
                   weight = yaml::default_of(1.0);
  yaml::At<double> sigma, from, to;
  yaml::At<OverColumnText> over;

  static void declare(auto& key) {
    key("column", &CompareText::column,
        {.required = true, .text = "The data's column that was measured."});
    declare_conversion<CompareText>(key);
    key("weight", &CompareText::weight,
        {.text = "Weight of its squared residuals.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("sigma", &CompareText::sigma,
        {.text = "Standard deviation of the measurement, in the case's unit: residuals are "
                 "counted in it.",
         .default_text = "1",
         .bounds = law::kPositive});
    key("from", &CompareText::from,
        {.text = "First time at which it is compared.",
         .default_text = "the experiment's",
         .dimension = base::kTime});
    key("to", &CompareText::to,
        {.text = "Last time at which it is compared.",
         .default_text = "the experiment's",
         .dimension = base::kTime});
    key("over", &CompareText::over,
        {.text = "Compare loops over this position, branch by branch, instead of over time.",
         .default_text = "time"});
  }
};

struct ResampleText {
  yaml::At<double> every;
  yaml::At<int> points;

  static void declare(auto& key) {
    key("every", &ResampleText::every,
        {.text = "Time from one row to the next.",
         .default_text = "from points",
         .dimension = base::kTime,
         .bounds = law::kPositive});
    key("points", &ResampleText::points,
        {.text = "How many rows there are to be.",
         .default_text = "from every",
         .bounds = {.lower = 2, .upper = cleaning::kMostResampledRows}});
  }
};

struct AverageCyclesText {
  yaml::At<double> period;
  yaml::At<int> points = yaml::default_of(200);

  static void declare(auto& key) {
    key("period", &AverageCyclesText::period,
        {.required = true,
         .text = "Duration of one cycle.",
         .dimension = base::kTime,
         .bounds = law::kPositive});
    key("points", &AverageCyclesText::points,
        {.text = "How many rows the mean cycle has.",
         .default_text = "200",
         .bounds = {.lower = 4, .upper = 1.0e7}});
  }
};

struct DeadBandText {
  yaml::At<std::string> column, position, unit;
  yaml::At<double> below;

  static void declare(auto& key) {
    key("column", &DeadBandText::column,
        {.text = "The data's column of a speed.", .default_text = "position"});
    key("position", &DeadBandText::position,
        {.text = "The data's column of a position; its slope over time is the speed.",
         .default_text = "column"});
    key("unit", &DeadBandText::unit,
        {.text = "Unit of that column.", .default_text = "the case's"});
    key("below", &DeadBandText::below,
        {.required = true,
         .text = "Rows with a smaller magnitude of the speed are left out; in the case's "
                 "units.",
         .dimension = {0, 1, -1},
         .bounds = law::kPositive,
         .unit = yaml::UnitUse::kNone});
  }
};

struct ExperimentText {
  yaml::At<std::string> name, case_file;
  yaml::NamedMap<double> set;
  yaml::At<read::DataSourceText> data;
  yaml::At<DataColumnText> time;
  yaml::At<yaml::NamedMap<CompareText>> compare;
  yaml::At<double> weight = yaml::default_of(1.0);
  yaml::At<double> from, to;
  yaml::At<ResampleText> resample;
  yaml::At<AverageCyclesText> average_cycles;
  yaml::At<DeadBandText> dead_band;

  static void declare(auto& key) {
    key("name", &ExperimentText::name,
        {.text = "Name in tables, pictures and result files.",
         .default_text = "the case's, or the data's"});
    key("case", &ExperimentText::case_file,
        {.required = true, .text = "Case file that is to meet the data."});
    key("set", &ExperimentText::set,
        {.text = "Parameters of the case that have another value in this experiment.",
         .default_text = "none",
         .unit = yaml::UnitUse::kAny,
         .most = base::kMostParameters});
    key("data", &ExperimentText::data, {.required = true, .text = "CSV file of the measurement."});
    key("time", &ExperimentText::time,
        {.required = true, .text = "The data's column that becomes the total time T of the case."});
    key("compare", &ExperimentText::compare,
        {.required = true,
         .text = "What is compared: {CSF1: force}, a result column or an expression "
                 "(\"= CSF1 + 10\") and the data's column.",
         .most = 100});
    key("weight", &ExperimentText::weight,
        {.text = "Weight of all squared residuals of the experiment.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("from", &ExperimentText::from,
        {.text = "Rows before this time are left out.",
         .default_text = "the start",
         .dimension = base::kTime});
    key("to", &ExperimentText::to,
        {.text = "Rows after this time are left out.",
         .default_text = "the end",
         .dimension = base::kTime});
    key("resample", &ExperimentText::resample,
        {.text = "Rows spread evenly in time, in place of the measured ones.",
         .default_text = "none"});
    key("average_cycles", &ExperimentText::average_cycles,
        {.text = "The mean of the whole cycles of a steady loop, in place of the rows.",
         .default_text = "none"});
    key("dead_band", &ExperimentText::dead_band,
        {.text = "Leave out rows near a reversal, where the speed is small.",
         .default_text = "none"});
  }
};

/// An experiment that is scored and never fitted: the same keys.
struct HoldoutText {
  ExperimentText experiment;
};

/// Two numbers; `none` for one that is open.
struct BoundsText {
  std::optional<double> lower, upper;
};

struct VaryText {
  yaml::At<double> start;
  yaml::At<BoundsText> bounds;
  yaml::At<fit::Scale> scale = yaml::default_of(fit::Scale::kLinear);

  static void declare(auto& key) {
    key("start", &VaryText::start,
        {.text = "Where the search begins.",
         .default_text = "the case's value",
         .unit = yaml::UnitUse::kAny});
    key("bounds", &VaryText::bounds,
        {.text = "Lowest and highest value.", .default_text = "none", .unit = yaml::UnitUse::kAny});
    key("scale", &VaryText::scale,
        {.text = "log: searched in the logarithm, for positive numbers of unknown "
                 "magnitude.",
         .default_text = "linear"});
  }
};

struct VariedTableText {
  yaml::At<std::string> free;
  yaml::At<BoundsText> bounds;
  yaml::At<fit::Scale> scale = yaml::default_of(fit::Scale::kLinear);
  yaml::At<fit::Shape::Monotone> monotone;
  yaml::At<fit::Shape::Curvature> shape;
  yaml::At<double> smoothness = yaml::default_of(0.0);

  static void declare(auto& key) {
    key("free", &VariedTableText::free,
        {.text = "Column of the table whose numbers are varied.",
         .default_text = "its first, the dependent one"});
    key("bounds", &VariedTableText::bounds,
        {.text = "Lowest and highest value of every number.", .default_text = "[0, none]"});
    key("scale", &VariedTableText::scale, {.text = "As of a parameter.", .default_text = "linear"});
    key("monotone", &VariedTableText::monotone,
        {.text = "Along the first independent, block by block.", .default_text = "free"});
    key("shape", &VariedTableText::shape,
        {.text = "Along the first independent, block by block.", .default_text = "free"});
    key("smoothness", &VariedTableText::smoothness,
        {.text = "How much bends of the table count against the data: 1e-6 is a hint, 1 a "
                 "command.",
         .default_text = "0",
         .bounds = law::kNotNegative});
  }
};

/// `squares`, {huber: t} or {soft_l1: t}.
struct LossText {
  fit::Loss loss;
};

struct SearchStopText {
  int iterations = fit::SolverOptions{}.most_iterations;
  double step = fit::SolverOptions{}.step_tolerance;
  double gradient = fit::SolverOptions{}.gradient_tolerance;

  static void declare(auto& key) {
    key("iterations", &SearchStopText::iterations,
        {.text = "Most iterations from one start.",
         .default_text = "1000",
         .bounds = {.lower = 1}});
    key("step", &SearchStopText::step,
        {.text = "Converged when a step changes the unknowns by a smaller part.",
         .default_text = "1e-10",
         .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
    key("gradient", &SearchStopText::gradient,
        {.text = "Converged when the scaled gradient is smaller.",
         .default_text = "1e-10",
         .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
  }
};

/// The most fits to resampled residuals that a user may ask for.
inline constexpr int kMostResamplings = 100'000;

struct CalibrateText {
  yaml::At<std::vector<yaml::At<ExperimentText>>> experiments;
  yaml::At<std::vector<yaml::At<HoldoutText>>> holdout;
  yaml::At<yaml::NamedMap<VaryText>> vary;
  yaml::At<yaml::NamedMap<VariedTableText>> tables;
  LossText loss;
  int multistart = 1;
  int seed = 1;
  SearchStopText stop;
  bool polish = true;
  double confidence = 0.95;
  int bootstrap = 0;
  bool profile = false;
  yaml::At<std::string> date;

  static void declare(auto& key) {
    key("experiments", &CalibrateText::experiments,
        {.required = true, .text = "Measurements with the cases that are to meet them."});
    key("holdout", &CalibrateText::holdout,
        {.text = "Experiments that are scored and never fitted; keys as of experiments.",
         .default_text = "none"});
    key("vary", &CalibrateText::vary,
        {.text = "Parameters of the cases that are found; one name is one unknown in all "
                 "cases.",
         .default_text = "tables",
         .most = 200});
    key("tables", &CalibrateText::tables,
        {.text = "Tables whose numbers are found: sleeve.coefficient or "
                 "sleeve.internal_contact_force, without the name where a case has one "
                 "definition.",
         .default_text = "vary",
         .most = 200});
    key("loss", &CalibrateText::loss,
        {.text = "How residuals count: squares, or beyond a threshold by their magnitude: "
                 "{huber: t}, {soft_l1: t}, t in the residual's unit (in sigmas where "
                 "sigma is given).",
         .default_text = "squares"});
    key("multistart", &CalibrateText::multistart,
        {.text = "Starts: the given one, and others spread over the bounds.",
         .default_text = "1",
         .bounds = {.lower = 1, .upper = 1.0e6}});
    key("seed", &CalibrateText::seed,
        {.text = "Of the other starts and of the bootstrap: the same seed gives the same "
                 "result.",
         .default_text = "1",
         .bounds = law::kNotNegative});
    key("stop", &CalibrateText::stop, {.text = "When a search ends.", .default_text = "as below"});
    key("polish", &CalibrateText::polish,
        {.text = "true: a search without derivatives follows, for kinks.", .default_text = "true"});
    key("confidence", &CalibrateText::confidence,
        {.text = "Probability of the intervals and bands.",
         .default_text = "0.95",
         .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true}});
    key("bootstrap", &CalibrateText::bootstrap,
        {.text = "Fits to resampled residuals, for errors without a linear model.",
         .default_text = "0: none",
         .bounds = {.lower = 0, .upper = kMostResamplings}});
    key("profile", &CalibrateText::profile,
        {.text = "true: the cost along every parameter, all others fitted again.",
         .default_text = "false"});
    key("date", &CalibrateText::date,
        {.text = "Date of the calibration, YYYY-MM-DD, for its provenance; never taken from "
                 "the clock.",
         .default_text = "none"});
  }
};

struct FitText {
  yaml::At<int> slipbench;
  std::string title;
  yaml::At<CalibrateText> calibrate;

  static void declare(auto& key) {
    key("slipbench", &FitText::slipbench,
        {.required = true,
         .text = "Version of the format: 1.",
         .bounds = {.lower = 1, .upper = 1}});
    key("title", &FitText::title,
        {.text = "One line for results and pictures.", .default_text = "the file's name"});
    key("calibrate", &FitText::calibrate, {.required = true, .text = "The calibration."});
  }
};

}  // namespace slipbench::driver::calibrate

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

SLIPBENCH_DECLARE_CODEC(calibrate::DataColumnText);
SLIPBENCH_DECLARE_CODEC(calibrate::OverColumnText);
SLIPBENCH_DECLARE_CODEC(calibrate::CompareText);
SLIPBENCH_DECLARE_CODEC(calibrate::HoldoutText);
SLIPBENCH_DECLARE_CODEC(calibrate::BoundsText);
SLIPBENCH_DECLARE_CODEC(calibrate::LossText);

}  // namespace slipbench::driver::yaml
