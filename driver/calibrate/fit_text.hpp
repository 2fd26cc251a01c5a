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

namespace slipbench::driver {

/// The keys that say how the numbers of a data column become those of the case.
template <class Text, class V>
void declare_conversion(V& key) {
  key("unit", &Text::unit, KeyInfo{.text = "Unit of the column.", .default_text = "the case's"});
  key("factor", &Text::factor,
      KeyInfo{.text = "Every number is multiplied by it, after the change of unit; -1 turns the "
                      "sign.",
              .default_text = "1"});
  key("offset", &Text::offset,
      KeyInfo{.text = "Is added to every number, in the case's unit.", .default_text = "0"});
}

/// A column of a data file: its name, or its name and how its numbers are converted.
struct DataColumnText {
  static constexpr bool kIsDeclared = true;
  At<std::string> column, unit;
  At<double> factor = default_of(1.0), offset = default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("column", &DataColumnText::column,
        KeyInfo{.required = true, .text = "Name of the column."});
    declare_conversion<DataColumnText>(key);
  }
};

/// A result column with the data column that belongs to it; the name alone if both are called so.
struct OverColumnText {
  static constexpr bool kIsDeclared = true;
  At<std::string> quantity, column, unit;
  At<double> factor = default_of(1.0), offset = default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("quantity", &OverColumnText::quantity,
        KeyInfo{.required = true, .text = "Result column of a position, such as CP1."});
    key("column", &OverColumnText::column,
        KeyInfo{.text = "The data's column of it.", .default_text = "the one of the same name"});
    declare_conversion<OverColumnText>(key);
  }
};

/// Comparison of one quantity of the result.
struct CompareText {
  static constexpr bool kIsDeclared = true;
  At<std::string> column, unit;
  At<double> factor = default_of(1.0), offset = default_of(0.0), weight = default_of(1.0);
  At<double> sigma, from, to;
  At<OverColumnText> over;

  template <class V>
  static void declare(V& key) {
    key("column", &CompareText::column,
        KeyInfo{.required = true, .text = "The data's column that was measured."});
    declare_conversion<CompareText>(key);
    key("weight", &CompareText::weight,
        KeyInfo{.text = "Weight of its squared residuals.",
                .default_text = "1",
                .bounds = law::kNotNegative});
    key("sigma", &CompareText::sigma,
        KeyInfo{.text = "Standard deviation of the measurement, in the case's unit: residuals are "
                        "counted in it.",
                .default_text = "1",
                .bounds = law::kPositive});
    key("from", &CompareText::from,
        KeyInfo{.text = "First time at which it is compared.",
                .default_text = "the experiment's",
                .dimension = kTime});
    key("to", &CompareText::to,
        KeyInfo{.text = "Last time at which it is compared.",
                .default_text = "the experiment's",
                .dimension = kTime});
    key("over", &CompareText::over,
        KeyInfo{.text = "Compare loops over this position, branch by branch, instead of over time.",
                .default_text = "time"});
  }
};

struct ResampleText {
  static constexpr bool kIsDeclared = true;
  At<double> every;
  At<int> points;

  template <class V>
  static void declare(V& key) {
    key("every", &ResampleText::every,
        KeyInfo{.text = "Time from one row to the next.",
                .default_text = "from points",
                .dimension = kTime,
                .bounds = law::kPositive});
    key("points", &ResampleText::points,
        KeyInfo{.text = "How many rows there are to be.",
                .default_text = "from every",
                .bounds = {.lower = 2, .upper = kMostResampledRows}});
  }
};

struct AverageCyclesText {
  static constexpr bool kIsDeclared = true;
  At<double> period;
  At<int> points = default_of(200);

  template <class V>
  static void declare(V& key) {
    key("period", &AverageCyclesText::period,
        KeyInfo{.required = true,
                .text = "Duration of one cycle.",
                .dimension = kTime,
                .bounds = law::kPositive});
    key("points", &AverageCyclesText::points,
        KeyInfo{.text = "How many rows the mean cycle has.",
                .default_text = "200",
                .bounds = {.lower = 4, .upper = 1.0e7}});
  }
};

struct DeadBandText {
  static constexpr bool kIsDeclared = true;
  At<std::string> column, position, unit;
  At<double> below;

  template <class V>
  static void declare(V& key) {
    key("column", &DeadBandText::column,
        KeyInfo{.text = "The data's column of a speed.", .default_text = "position"});
    key("position", &DeadBandText::position,
        KeyInfo{.text = "The data's column of a position; its slope over time is the speed.",
                .default_text = "column"});
    key("unit", &DeadBandText::unit,
        KeyInfo{.text = "Unit of that column.", .default_text = "the case's"});
    key("below", &DeadBandText::below,
        KeyInfo{.required = true,
                .text = "Rows with a smaller magnitude of the speed are left out; in the case's "
                        "units.",
                .dimension = {0, 1, -1},
                .bounds = law::kPositive,
                .unit = UnitUse::kNone});
  }
};

struct ExperimentText {
  static constexpr bool kIsDeclared = true;
  At<std::string> name, case_file;
  NamedMap<double> set;
  At<DataSourceText> data;
  At<DataColumnText> time;
  At<NamedMap<CompareText>> compare;
  At<double> weight = default_of(1.0);
  At<double> from, to;
  At<ResampleText> resample;
  At<AverageCyclesText> average_cycles;
  At<DeadBandText> dead_band;

  template <class V>
  static void declare(V& key) {
    key("name", &ExperimentText::name,
        KeyInfo{.text = "Name in tables, pictures and result files.",
                .default_text = "the case's, or the data's"});
    key("case", &ExperimentText::case_file,
        KeyInfo{.required = true, .text = "Case file that is to meet the data."});
    key("set", &ExperimentText::set,
        KeyInfo{.text = "Parameters of the case that have another value in this experiment.",
                .default_text = "none",
                .unit = UnitUse::kAny});
    key("data", &ExperimentText::data,
        KeyInfo{.required = true, .text = "CSV file of the measurement."});
    key("time", &ExperimentText::time,
        KeyInfo{.required = true,
                .text = "The data's column that becomes the total time T of the case."});
    key("compare", &ExperimentText::compare,
        KeyInfo{.required = true,
                .text = "What is compared: {CSF1: force}, a result column or an expression "
                        "(\"= CSF1 + 10\") and the data's column."});
    key("weight", &ExperimentText::weight,
        KeyInfo{.text = "Weight of all squared residuals of the experiment.",
                .default_text = "1",
                .bounds = law::kNotNegative});
    key("from", &ExperimentText::from,
        KeyInfo{.text = "Rows before this time are left out.",
                .default_text = "the start",
                .dimension = kTime});
    key("to", &ExperimentText::to,
        KeyInfo{.text = "Rows after this time are left out.",
                .default_text = "the end",
                .dimension = kTime});
    key("resample", &ExperimentText::resample,
        KeyInfo{.text = "Rows spread evenly in time, in place of the measured ones.",
                .default_text = "none"});
    key("average_cycles", &ExperimentText::average_cycles,
        KeyInfo{.text = "The mean of the whole cycles of a steady loop, in place of the rows.",
                .default_text = "none"});
    key("dead_band", &ExperimentText::dead_band,
        KeyInfo{.text = "Leave out rows near a reversal, where the speed is small.",
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

template <>
struct EnumWords<Scale> {
  static constexpr std::array<std::string_view, 2> kWords{"linear", "log"};
};

struct VaryText {
  static constexpr bool kIsDeclared = true;
  At<double> start;
  At<BoundsText> bounds;
  At<Scale> scale = default_of(Scale::kLinear);

  template <class V>
  static void declare(V& key) {
    key("start", &VaryText::start,
        KeyInfo{.text = "Where the search begins.",
                .default_text = "the case's value",
                .unit = UnitUse::kAny});
    key("bounds", &VaryText::bounds,
        KeyInfo{
            .text = "Lowest and highest value.", .default_text = "none", .unit = UnitUse::kAny});
    key("scale", &VaryText::scale,
        KeyInfo{.text = "log: searched in the logarithm, for positive numbers of unknown "
                        "magnitude.",
                .default_text = "linear"});
  }
};

template <>
struct EnumWords<Shape::Monotone> {
  static constexpr std::array<std::string_view, 3> kWords{"free", "increasing", "decreasing"};
};
template <>
struct EnumWords<Shape::Curvature> {
  static constexpr std::array<std::string_view, 3> kWords{"free", "convex", "concave"};
};

struct VariedTableText {
  static constexpr bool kIsDeclared = true;
  At<std::string> free;
  At<BoundsText> bounds;
  At<Scale> scale = default_of(Scale::kLinear);
  At<Shape::Monotone> monotone;
  At<Shape::Curvature> shape;
  At<double> smoothness = default_of(0.0);

  template <class V>
  static void declare(V& key) {
    key("free", &VariedTableText::free,
        KeyInfo{.text = "Column of the table whose numbers are varied.",
                .default_text = "its first, the dependent one"});
    key("bounds", &VariedTableText::bounds,
        KeyInfo{.text = "Lowest and highest value of every number.", .default_text = "[0, none]"});
    key("scale", &VariedTableText::scale,
        KeyInfo{.text = "As of a parameter.", .default_text = "linear"});
    key("monotone", &VariedTableText::monotone,
        KeyInfo{.text = "Along the first independent, block by block.", .default_text = "free"});
    key("shape", &VariedTableText::shape,
        KeyInfo{.text = "Along the first independent, block by block.", .default_text = "free"});
    key("smoothness", &VariedTableText::smoothness,
        KeyInfo{.text = "How much bends of the table count against the data: 1e-6 is a hint, 1 a "
                        "command.",
                .default_text = "0",
                .bounds = law::kNotNegative});
  }
};

/// `squares`, {huber: t} or {soft_l1: t}.
struct LossText {
  Loss loss;
};

struct SearchStopText {
  static constexpr bool kIsDeclared = true;
  int iterations = SolverOptions{}.most_iterations;
  double step = SolverOptions{}.step_tolerance;
  double gradient = SolverOptions{}.gradient_tolerance;

  template <class V>
  static void declare(V& key) {
    key("iterations", &SearchStopText::iterations,
        KeyInfo{.text = "Most iterations from one start.",
                .default_text = "1000",
                .bounds = {.lower = 1}});
    key("step", &SearchStopText::step,
        KeyInfo{.text = "Converged when a step changes the unknowns by a smaller part.",
                .default_text = "1e-10",
                .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
    key("gradient", &SearchStopText::gradient,
        KeyInfo{.text = "Converged when the scaled gradient is smaller.",
                .default_text = "1e-10",
                .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true}});
  }
};

struct CalibrateText {
  static constexpr bool kIsDeclared = true;
  At<std::vector<At<ExperimentText>>> experiments;
  At<std::vector<At<HoldoutText>>> holdout;
  At<NamedMap<VaryText>> vary;
  At<NamedMap<VariedTableText>> tables;
  LossText loss;
  int multistart = 1;
  int seed = 1;
  SearchStopText stop;
  bool polish = true;
  double confidence = 0.95;
  int bootstrap = 0;
  bool profile = false;
  At<std::string> date;

  template <class V>
  static void declare(V& key) {
    key("experiments", &CalibrateText::experiments,
        KeyInfo{.required = true, .text = "Measurements with the cases that are to meet them."});
    key("holdout", &CalibrateText::holdout,
        KeyInfo{.text = "Experiments that are scored and never fitted; keys as of experiments.",
                .default_text = "none"});
    key("vary", &CalibrateText::vary,
        KeyInfo{.text = "Parameters of the cases that are found; one name is one unknown in all "
                        "cases.",
                .default_text = "tables"});
    key("tables", &CalibrateText::tables,
        KeyInfo{.text = "Tables whose numbers are found: sleeve.coefficient or "
                        "sleeve.internal_contact_force, without the name where a case has one "
                        "definition.",
                .default_text = "vary"});
    key("loss", &CalibrateText::loss,
        KeyInfo{.text = "How residuals count: squares, or beyond a threshold by their magnitude: "
                        "{huber: t}, {soft_l1: t}, t in the residual's unit (in sigmas where "
                        "sigma is given).",
                .default_text = "squares"});
    key("multistart", &CalibrateText::multistart,
        KeyInfo{.text = "Starts: the given one, and others spread over the bounds.",
                .default_text = "1",
                .bounds = {.lower = 1, .upper = 1.0e6}});
    key("seed", &CalibrateText::seed,
        KeyInfo{.text = "Of the other starts and of the bootstrap: the same seed gives the same "
                        "result.",
                .default_text = "1",
                .bounds = law::kNotNegative});
    key("stop", &CalibrateText::stop,
        KeyInfo{.text = "When a search ends.", .default_text = "as below"});
    key("polish", &CalibrateText::polish,
        KeyInfo{.text = "true: a search without derivatives follows, for kinks.",
                .default_text = "true"});
    key("confidence", &CalibrateText::confidence,
        KeyInfo{.text = "Probability of the intervals and bands.",
                .default_text = "0.95",
                .bounds = {.lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true}});
    key("bootstrap", &CalibrateText::bootstrap,
        KeyInfo{.text = "Fits to resampled residuals, for errors without a linear model.",
                .default_text = "0: none",
                .bounds = {.lower = 0, .upper = 1.0e6}});
    key("profile", &CalibrateText::profile,
        KeyInfo{.text = "true: the cost along every parameter, all others fitted again.",
                .default_text = "false"});
    key("date", &CalibrateText::date,
        KeyInfo{.text = "Date of the calibration, YYYY-MM-DD, for its provenance; never taken from "
                        "the clock.",
                .default_text = "none"});
  }
};

struct FitText {
  static constexpr bool kIsDeclared = true;
  At<int> slipbench;
  std::string title;
  At<CalibrateText> calibrate;

  template <class V>
  static void declare(V& key) {
    key("slipbench", &FitText::slipbench,
        KeyInfo{.required = true,
                .text = "Version of the format: 1.",
                .bounds = {.lower = 1, .upper = 1}});
    key("title", &FitText::title,
        KeyInfo{.text = "One line for results and pictures.", .default_text = "the file's name"});
    key("calibrate", &FitText::calibrate, KeyInfo{.required = true, .text = "The calibration."});
  }
};

#define SLIPBENCH_DECLARE_CODEC(Type)                                                         \
  template <>                                                                                 \
  struct Codec<Type> {                                                                        \
    static bool read(Binder& binder, const Node& node, const Path& path, const KeyInfo& info, \
                     Type& out);                                                              \
    static Json schema(const KeyInfo& info);                                                  \
    static std::string wanted(const KeyInfo& info);                                           \
    static void rows(const std::string& path, std::vector<KeyRow>& rows);                     \
  }

SLIPBENCH_DECLARE_CODEC(DataColumnText);
SLIPBENCH_DECLARE_CODEC(OverColumnText);
SLIPBENCH_DECLARE_CODEC(CompareText);
SLIPBENCH_DECLARE_CODEC(HoldoutText);
SLIPBENCH_DECLARE_CODEC(BoundsText);
SLIPBENCH_DECLARE_CODEC(LossText);

#undef SLIPBENCH_DECLARE_CODEC

}  // namespace slipbench::driver
