// SPDX-License-Identifier: Apache-2.0
// A fit as it is written: the structs beside whose members every key of a fit file is declared.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "driver/calibrate/cleaning/resample.hpp"
#include "driver/calibrate/fit/problem.hpp"
#include "driver/read/keys/data_source_text.hpp"
#include "driver/yaml/binding.hpp"

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
  key("unit", &Text::unit,
      yaml::KeyInfo{.text = "Unit of the column.", .default_text = "the case's"});
  key("factor", &Text::factor,
      yaml::KeyInfo{.text =
                        "Every number is multiplied by it, after the change of unit; -1 turns the "
                        "sign.",
                    .default_text = "1"});
  key("offset", &Text::offset,
      yaml::KeyInfo{.text = "Is added to every number, in the case's unit.", .default_text = "0"});
}

/// A column of a data file: its name, or its name and how its numbers are converted.
struct DataColumnText {
  static constexpr bool kIsDeclared = true;
  yaml::At<std::string> column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("column", &DataColumnText::column,
        yaml::KeyInfo{.required = true, .text = "Name of the column."});
    declare_conversion<DataColumnText>(key);
  }
};

/// A result column with the data column that belongs to it; the name alone if both are called so.
struct OverColumnText {
  static constexpr bool kIsDeclared = true;
  yaml::At<std::string> quantity, column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("quantity", &OverColumnText::quantity,
        yaml::KeyInfo{.required = true, .text = "Result column of a position, such as CP1."});
    key("column", &OverColumnText::column,
        yaml::KeyInfo{.text = "The data's column of it.",
                      .default_text = "the one of the same name"});
    declare_conversion<OverColumnText>(key);
  }
};

/// Comparison of one quantity of the result.
struct CompareText {
  static constexpr bool kIsDeclared = true;
  yaml::At<std::string> column, unit;
  yaml::At<double> factor = yaml::default_of(1.0), offset = yaml::default_of(0.0),
                   weight = yaml::default_of(1.0);
  yaml::At<double> sigma, from, to;
  yaml::At<OverColumnText> over;

  template <class V>
  static void declare(V& key) {
    key("column", &CompareText::column,
        yaml::KeyInfo{.required = true, .text = "The data's column that was measured."});
    declare_conversion<CompareText>(key);
    key("weight", &CompareText::weight,
        yaml::KeyInfo{.text = "Weight of its squared residuals.",
                      .default_text = "1",
                      .bounds = law::kNotNegative});
    key("sigma", &CompareText::sigma,
        yaml::KeyInfo{
            .text = "Standard deviation of the measurement, in the case's unit: residuals are "
                    "counted in it.",
            .default_text = "1",
            .bounds = law::kPositive});
    key("from", &CompareText::from,
        yaml::KeyInfo{.text = "First time at which it is compared.",
                      .default_text = "the experiment's",
                      .dimension = base::kTime});
    key("to", &CompareText::to,
        yaml::KeyInfo{.text = "Last time at which it is compared.",
                      .default_text = "the experiment's",
                      .dimension = base::kTime});
    key("over", &CompareText::over,
        yaml::KeyInfo{
            .text = "Compare loops over this position, branch by branch, instead of over time.",
            .default_text = "time"});
  }
};

struct ResampleText {
  static constexpr bool kIsDeclared = true;
  yaml::At<double> every;
  yaml::At<int> points;

  template <class V>
  static void declare(V& key) {
    key("every", &ResampleText::every,
        yaml::KeyInfo{.text = "Time from one row to the next.",
                      .default_text = "from points",
                      .dimension = base::kTime,
                      .bounds = law::kPositive});
    key("points", &ResampleText::points,
        yaml::KeyInfo{.text = "How many rows there are to be.",
                      .default_text = "from every",
                      .bounds = {.lower = 2, .upper = cleaning::kMostResampledRows}});
  }
};

struct AverageCyclesText {
  static constexpr bool kIsDeclared = true;
  yaml::At<double> period;
  yaml::At<int> points = yaml::default_of(200);

  template <class V>
  static void declare(V& key) {
    key("period", &AverageCyclesText::period,
        yaml::KeyInfo{.required = true,
                      .text = "Duration of one cycle.",
                      .dimension = base::kTime,
                      .bounds = law::kPositive});
    key("points", &AverageCyclesText::points,
        yaml::KeyInfo{.text = "How many rows the mean cycle has.",
                      .default_text = "200",
                      .bounds = {.lower = 4, .upper = 1.0e7}});
  }
};

struct DeadBandText {
  static constexpr bool kIsDeclared = true;
  yaml::At<std::string> column, position, unit;
  yaml::At<double> below;

  template <class V>
  static void declare(V& key) {
    key("column", &DeadBandText::column,
        yaml::KeyInfo{.text = "The data's column of a speed.", .default_text = "position"});
    key("position", &DeadBandText::position,
        yaml::KeyInfo{.text = "The data's column of a position; its slope over time is the speed.",
                      .default_text = "column"});
    key("unit", &DeadBandText::unit,
        yaml::KeyInfo{.text = "Unit of that column.", .default_text = "the case's"});
    key("below", &DeadBandText::below,
        yaml::KeyInfo{.required = true,
                      .text =
                          "Rows with a smaller magnitude of the speed are left out; in the case's "
                          "units.",
                      .dimension = {0, 1, -1},
                      .bounds = law::kPositive,
                      .unit = yaml::UnitUse::kNone});
  }
};

struct ExperimentText {
  static constexpr bool kIsDeclared = true;
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

  template <class V>
  static void declare(V& key) {
    key("name", &ExperimentText::name,
        yaml::KeyInfo{.text = "Name in tables, pictures and result files.",
                      .default_text = "the case's, or the data's"});
    key("case", &ExperimentText::case_file,
        yaml::KeyInfo{.required = true, .text = "Case file that is to meet the data."});
    key("set", &ExperimentText::set,
        yaml::KeyInfo{.text = "Parameters of the case that have another value in this experiment.",
                      .default_text = "none",
                      .unit = yaml::UnitUse::kAny});
    key("data", &ExperimentText::data,
        yaml::KeyInfo{.required = true, .text = "CSV file of the measurement."});
    key("time", &ExperimentText::time,
        yaml::KeyInfo{.required = true,
                      .text = "The data's column that becomes the total time T of the case."});
    key("compare", &ExperimentText::compare,
        yaml::KeyInfo{.required = true,
                      .text = "What is compared: {CSF1: force}, a result column or an expression "
                              "(\"= CSF1 + 10\") and the data's column."});
    key("weight", &ExperimentText::weight,
        yaml::KeyInfo{.text = "Weight of all squared residuals of the experiment.",
                      .default_text = "1",
                      .bounds = law::kNotNegative});
    key("from", &ExperimentText::from,
        yaml::KeyInfo{.text = "Rows before this time are left out.",
                      .default_text = "the start",
                      .dimension = base::kTime});
    key("to", &ExperimentText::to,
        yaml::KeyInfo{.text = "Rows after this time are left out.",
                      .default_text = "the end",
                      .dimension = base::kTime});
    key("resample", &ExperimentText::resample,
        yaml::KeyInfo{.text = "Rows spread evenly in time, in place of the measured ones.",
                      .default_text = "none"});
    key("average_cycles", &ExperimentText::average_cycles,
        yaml::KeyInfo{
            .text = "The mean of the whole cycles of a steady loop, in place of the rows.",
            .default_text = "none"});
    key("dead_band", &ExperimentText::dead_band,
        yaml::KeyInfo{.text = "Leave out rows near a reversal, where the speed is small.",
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
  static constexpr bool kIsDeclared = true;
  yaml::At<double> start;
  yaml::At<BoundsText> bounds;
  yaml::At<fit::Scale> scale = yaml::default_of(fit::Scale::kLinear);

  template <class V>
  static void declare(V& key) {
    key("start", &VaryText::start,
        yaml::KeyInfo{.text = "Where the search begins.",
                      .default_text = "the case's value",
                      .unit = yaml::UnitUse::kAny});
    key("bounds", &VaryText::bounds,
        yaml::KeyInfo{.text = "Lowest and highest value.",
                      .default_text = "none",
                      .unit = yaml::UnitUse::kAny});
    key("scale", &VaryText::scale,
        yaml::KeyInfo{.text = "log: searched in the logarithm, for positive numbers of unknown "
                              "magnitude.",
                      .default_text = "linear"});
  }
};

struct VariedTableText {
  static constexpr bool kIsDeclared = true;
  yaml::At<std::string> free;
  yaml::At<BoundsText> bounds;
  yaml::At<fit::Scale> scale = yaml::default_of(fit::Scale::kLinear);
  yaml::At<fit::Shape::Monotone> monotone;
  yaml::At<fit::Shape::Curvature> shape;
  yaml::At<double> smoothness = yaml::default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("free", &VariedTableText::free,
        yaml::KeyInfo{.text = "Column of the table whose numbers are varied.",
                      .default_text = "its first, the dependent one"});
    key("bounds", &VariedTableText::bounds,
        yaml::KeyInfo{.text = "Lowest and highest value of every number.",
                      .default_text = "[0, none]"});
    key("scale", &VariedTableText::scale,
        yaml::KeyInfo{.text = "As of a parameter.", .default_text = "linear"});
    key("monotone", &VariedTableText::monotone,
        yaml::KeyInfo{.text = "Along the first independent, block by block.",
                      .default_text = "free"});
    key("shape", &VariedTableText::shape,
        yaml::KeyInfo{.text = "Along the first independent, block by block.",
                      .default_text = "free"});
    key("smoothness", &VariedTableText::smoothness,
        yaml::KeyInfo{.text =
                          "How much bends of the table count against the data: 1e-6 is a hint, 1 a "
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
  static constexpr bool kIsDeclared = true;
  int iterations = fit::SolverOptions{}.most_iterations;
  double step = fit::SolverOptions{}.step_tolerance;
  double gradient = fit::SolverOptions{}.gradient_tolerance;

  template <class V>
  static void declare(V& key) {
    key("iterations", &SearchStopText::iterations,
        yaml::KeyInfo{.text = "Most iterations from one start.",
                      .default_text = "1000",
                      .bounds = {.lower = 1}});
    key("step", &SearchStopText::step,
        yaml::KeyInfo{.text = "Converged when a step changes the unknowns by a smaller part.",
                      .default_text = "1e-10",
                      .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
    key("gradient", &SearchStopText::gradient,
        yaml::KeyInfo{.text = "Converged when the scaled gradient is smaller.",
                      .default_text = "1e-10",
                      .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
  }
};

struct CalibrateText {
  static constexpr bool kIsDeclared = true;
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

  template <class V>
  static void declare(V& key) {
    key("experiments", &CalibrateText::experiments,
        yaml::KeyInfo{.required = true,
                      .text = "Measurements with the cases that are to meet them."});
    key("holdout", &CalibrateText::holdout,
        yaml::KeyInfo{
            .text = "Experiments that are scored and never fitted; keys as of experiments.",
            .default_text = "none"});
    key("vary", &CalibrateText::vary,
        yaml::KeyInfo{.text =
                          "Parameters of the cases that are found; one name is one unknown in all "
                          "cases.",
                      .default_text = "tables"});
    key("tables", &CalibrateText::tables,
        yaml::KeyInfo{.text =
                          "Tables whose numbers are found: sleeve.coefficient or "
                          "sleeve.internal_contact_force, without the name where a case has one "
                          "definition.",
                      .default_text = "vary"});
    key("loss", &CalibrateText::loss,
        yaml::KeyInfo{.text =
                          "How residuals count: squares, or beyond a threshold by their magnitude: "
                          "{huber: t}, {soft_l1: t}, t in the residual's unit (in sigmas where "
                          "sigma is given).",
                      .default_text = "squares"});
    key("multistart", &CalibrateText::multistart,
        yaml::KeyInfo{.text = "Starts: the given one, and others spread over the bounds.",
                      .default_text = "1",
                      .bounds = {.lower = 1, .upper = 1.0e6}});
    key("seed", &CalibrateText::seed,
        yaml::KeyInfo{.text =
                          "Of the other starts and of the bootstrap: the same seed gives the same "
                          "result.",
                      .default_text = "1",
                      .bounds = law::kNotNegative});
    key("stop", &CalibrateText::stop,
        yaml::KeyInfo{.text = "When a search ends.", .default_text = "as below"});
    key("polish", &CalibrateText::polish,
        yaml::KeyInfo{.text = "true: a search without derivatives follows, for kinks.",
                      .default_text = "true"});
    key("confidence", &CalibrateText::confidence,
        yaml::KeyInfo{
            .text = "Probability of the intervals and bands.",
            .default_text = "0.95",
            .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true}});
    key("bootstrap", &CalibrateText::bootstrap,
        yaml::KeyInfo{.text = "Fits to resampled residuals, for errors without a linear model.",
                      .default_text = "0: none",
                      .bounds = {.lower = 0, .upper = 1.0e6}});
    key("profile", &CalibrateText::profile,
        yaml::KeyInfo{.text = "true: the cost along every parameter, all others fitted again.",
                      .default_text = "false"});
    key("date", &CalibrateText::date,
        yaml::KeyInfo{
            .text = "Date of the calibration, YYYY-MM-DD, for its provenance; never taken from "
                    "the clock.",
            .default_text = "none"});
  }
};

struct FitText {
  static constexpr bool kIsDeclared = true;
  yaml::At<int> slipbench;
  std::string title;
  yaml::At<CalibrateText> calibrate;

  template <class V>
  static void declare(V& key) {
    key("slipbench", &FitText::slipbench,
        yaml::KeyInfo{.required = true,
                      .text = "Version of the format: 1.",
                      .bounds = {.lower = 1, .upper = 1}});
    key("title", &FitText::title,
        yaml::KeyInfo{.text = "One line for results and pictures.",
                      .default_text = "the file's name"});
    key("calibrate", &FitText::calibrate,
        yaml::KeyInfo{.required = true, .text = "The calibration."});
  }
};

}  // namespace slipbench::driver::calibrate

// Specialisations belong to the namespace of their template.
namespace slipbench::driver::yaml {

#define SLIPBENCH_DECLARE_CODEC(Type)                                                         \
  template <>                                                                                 \
  struct Codec<Type> {                                                                        \
    static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info, \
                     Type& out);                                                              \
    static Json schema(const KeyInfo& info);                                                  \
    static std::string wanted(const KeyInfo& info);                                           \
    static void rows(const std::string& path, std::vector<KeyRow>& rows);                     \
  }

SLIPBENCH_DECLARE_CODEC(calibrate::DataColumnText);
SLIPBENCH_DECLARE_CODEC(calibrate::OverColumnText);
SLIPBENCH_DECLARE_CODEC(calibrate::CompareText);
SLIPBENCH_DECLARE_CODEC(calibrate::HoldoutText);
SLIPBENCH_DECLARE_CODEC(calibrate::BoundsText);
SLIPBENCH_DECLARE_CODEC(calibrate::LossText);

#undef SLIPBENCH_DECLARE_CODEC

}  // namespace slipbench::driver::yaml

namespace slipbench::driver::calibrate {}  // namespace slipbench::driver::calibrate
