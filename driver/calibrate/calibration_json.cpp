// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/calibration_json.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "driver/calibrate/estimate_text.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Of a response with more points not all are written: a file for other programs, no copy of the
/// measurements.
constexpr std::size_t kMostPointsTold = 10000;

base::json::Value list(std::span<const double> values) {
  base::json::Array array;
  array.reserve(values.size());
  for (const double value : values) array.emplace_back(value);
  return array;
}

base::json::Value list(std::span<const std::string> texts) {
  base::json::Array array;
  for (const std::string& text : texts) array.emplace_back(text);
  return array;
}

base::json::Value pair(double lower, double upper) { return base::json::Array{lower, upper}; }

/// Null where there is no such entry.
base::json::Value entry(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? base::json::Value(values[i]) : base::json::Value();
}

base::json::Value interval(const std::vector<double>& lower, const std::vector<double>& upper,
                           std::size_t i) {
  if (i >= lower.size() || i >= upper.size()) return {};
  if (std::isnan(lower[i]) || std::isnan(upper[i])) return {};
  return pair(lower[i], upper[i]);
}

bool holds(const std::vector<char>& flags, std::size_t i) {
  return i < flags.size() && flags[i] != 0;
}

std::string_view word_of(fit::StopReason reason) {
  switch (reason) {
    case fit::StopReason::kStep:
      return "step";
    case fit::StopReason::kGradient:
      return "gradient";
    case fit::StopReason::kCost:
      return "cost";
    case fit::StopReason::kIterations:
      return "iterations";
    case fit::StopReason::kNoProgress:
      return "no_progress";
    case fit::StopReason::kZeroGradient:
      return "zero_gradient";
    case fit::StopReason::kNoIteration:
      return "no_iteration";
    case fit::StopReason::kModelFailure:
      return "model_failure";
    case fit::StopReason::kSilent:
      return "silent";
    case fit::StopReason::kTooFewData:
      break;
  }
  return "too_few_data";
}

std::string_view word_of(fit::Loss::Kind kind) {
  switch (kind) {
    case fit::Loss::Kind::kSquares:
      return "squares";
    case fit::Loss::Kind::kHuber:
      return "huber";
    case fit::Loss::Kind::kSoftL1:
      break;
  }
  return "soft_l1";
}

base::json::Value origin(const Fit& fit, const Calibration& calibration) {
  base::json::Value value;
  value["program"] = "slipbench";
  value["version"] = results::program_version();
  value["fit"] = fit.file_name();
  value["title"] = fit.title;
  value["date"] = fit.date ? base::json::Value(*fit.date) : base::json::Value();
  base::json::Value experiments = base::json::Array{};
  for (const FittedExperiment& fitted : calibration.experiments) {
    const ExperimentFit& experiment = fit.experiments[fitted.index];
    base::json::Value one;
    one["name"] = experiment.name;
    one["case"] = experiment.case_file;
    one["data"] = experiment.data_file;
    one["sha256"] = fitted.data_hash;
    experiments.push_back(one);
  }
  value["experiments"] = experiments;
  return value;
}

base::json::Value result(const Fit& fit, const Calibration& calibration) {
  const fit::LeastSquaresFit& found = calibration.fit;
  base::json::Value value;
  value["converged"] = found.converged;
  value["stop"] = word_of(found.stop);
  value["sentence"] = found.stop_sentence;
  base::json::Value loss;
  loss["kind"] = word_of(fit.loss.kind);
  loss["threshold"] = fit.loss.kind == fit::Loss::Kind::kSquares
                          ? base::json::Value()
                          : base::json::Value(fit.loss.threshold);
  value["loss"] = loss;
  value["start_cost"] = found.start_cost;
  value["cost"] = found.cost;
  value["iterations"] = found.iterations;
  value["residual_evaluations"] = found.residual_evaluations;
  value["derivative_evaluations"] = found.derivative_evaluations;
  value["gradient"] = found.gradient_norm;
  value["polished"] = found.polished;
  value["derivatives"] = calibration.derivatives;
  base::json::Value searches = base::json::Array{};
  for (const fit::SearchTrace& search : found.searches) {
    base::json::Value one;
    one["start"] = list(search.start);
    one["end"] = list(search.end);
    const bool known = has_value(search);
    one["start_cost"] = known ? base::json::Value(search.start_cost) : base::json::Value();
    one["cost"] = known ? base::json::Value(search.cost) : base::json::Value();
    one["iterations"] = search.iterations;
    one["stop"] = word_of(search.stop);
    one["same_minimum"] = found_the_minimum(found, search);
    searches.push_back(one);
  }
  value["searches"] = searches;
  return value;
}

base::json::Value statistics_of(const Fit& fit, const Calibration& calibration) {
  const fit::FitStatistics& statistics = calibration.statistics;
  base::json::Value value;
  value["points"] = statistics.data;
  value["unknowns"] = statistics.unknowns;
  value["deviation"] = statistics.deviation;
  value["confidence"] = fit.confidence;
  value["condition"] = statistics.condition;
  if (calibration.bootstrap.wanted > 0) {
    base::json::Value bootstrap;
    bootstrap["wanted"] = calibration.bootstrap.wanted;
    bootstrap["done"] = calibration.bootstrap.done;
    bootstrap["block"] = calibration.bootstrap.block;
    value["bootstrap"] = bootstrap;
  }
  return value;
}

base::json::Value unknown_of(const Calibration& calibration, std::size_t u) {
  const FittedUnknown& unknown = calibration.unknowns[u];
  const fit::FitStatistics& statistics = calibration.statistics;
  base::json::Value value;
  value["name"] = unknown.name;
  value["unit"] = unknown.unit;
  value["value"] = unknown.value;
  value["standard_error"] = entry(statistics.standard_error, u);
  value["interval"] = interval(statistics.lower, statistics.upper, u);
  value["start"] = unknown.range.start;
  value["bounds"] = pair(unknown.range.lower, unknown.range.upper);
  value["scale"] = unknown.range.scale == fit::Scale::kLog ? "log" : "linear";
  value["at_bound"] = holds(calibration.fit.at_lower, u)   ? base::json::Value("lower")
                      : holds(calibration.fit.at_upper, u) ? base::json::Value("upper")
                                                           : base::json::Value();
  value["distance_to_lower"] = unknown.distance_to_lower;
  value["distance_to_upper"] = unknown.distance_to_upper;
  value["identifiability"] = word_of(unknown.identifiability);
  value["why"] = unknown.why;
  value["moved_by"] = unknown.moved_by;
  value["held_by"] = unknown.held_by;
  value["points"] = unknown.visits;
  value["frozen"] = holds(calibration.fit.frozen, u);
  if (calibration.bootstrap.done > 0) {
    base::json::Value bootstrap;
    bootstrap["standard_error"] = entry(calibration.bootstrap.standard_error, u);
    bootstrap["interval"] = interval(calibration.bootstrap.lower, calibration.bootstrap.upper, u);
    value["bootstrap"] = bootstrap;
  }
  return value;
}

/// Row by row; null if it is not known.
base::json::Value matrix(const std::vector<double>& values, std::size_t n) {
  if (n == 0 || values.size() != n * n) return {};
  base::json::Value rows = base::json::Array{};
  for (std::size_t i = 0; i < n; ++i) rows.push_back(list(std::span(values).subspan(i * n, n)));
  return rows;
}

base::json::Value table_of(const Fit& fit, const Calibration& calibration,
                           const FittedTable& fitted) {
  const VariedTable& varied = fit.tables[fitted.index];
  base::json::Value value;
  value["name"] = varied.name;
  value["free"] = varied.free;
  value["independents"] = list(fitted.columns);
  value["units"] = list(fitted.units);
  value["smoothness"] = varied.smoothness;
  base::json::Value rows = base::json::Array{};
  for (std::size_t r = 0; r < fitted.count; ++r) {
    base::json::Value row;
    row["unknown"] = fitted.first_unknown + r;
    row["at"] = list(fitted.points[r]);
    row["value"] = calibration.unknowns[fitted.first_unknown + r].value;
    row["standard_error"] = entry(calibration.statistics.standard_error, fitted.first_unknown + r);
    rows.push_back(row);
  }
  value["rows"] = rows;
  base::json::Value cells = base::json::Array{};
  for (const FittedTable::Cell& cell : fitted.cells) {
    base::json::Value one;
    one["cell"] = cell.text;
    one["increments"] = cell.visits;
    one["visited"] = cell.visited();
    cells.push_back(one);
  }
  value["cells"] = cells;
  return value;
}

/// The points whose values are written: all, or of very many every n-th and the last one.
std::vector<std::size_t> told_points(std::size_t count) {
  const std::size_t step = (count + kMostPointsTold - 1) / kMostPointsTold;
  std::vector<std::size_t> told;
  for (std::size_t i = 0; i < count; i += step) told.push_back(i);
  if (count > 0 && told.back() + 1 != count) told.push_back(count - 1);
  return told;
}

base::json::Value some_of(const std::vector<double>& values, const std::vector<std::size_t>& some) {
  base::json::Array array;
  array.reserve(some.size());
  for (const std::size_t i : some) array.push_back(entry(values, i));
  return array;
}

/// The points that do not belong to the noise of the others.
base::json::Value outliers_of(const FittedResponse& response) {
  const Outliers& outliers = response.outliers;
  base::json::Value points = base::json::Array{};
  for (std::size_t i = 0; i < outliers.points.size(); ++i) {
    const std::size_t point = outliers.points[i];
    base::json::Value one;
    one["time"] = response.time[point];
    one["line"] =
        i < response.lines.size() ? base::json::Value(response.lines[i]) : base::json::Value();
    one["measured"] = response.measured[point];
    one["after"] = response.after[point];
    one["sigmas"] = (response.after[point] - response.measured[point]) / outliers.scale;
    points.push_back(one);
  }
  return points;
}

base::json::Value experiment_of(const Fit& fit, const FittedExperiment& fitted) {
  const ExperimentFit& experiment = fit.experiments[fitted.index];
  base::json::Value value;
  value["name"] = experiment.name;
  value["held_out"] = experiment.held_out;
  value["rows_read"] = fitted.rows_read;
  value["rows_used"] = fitted.rows_used;
  value["cleaning"] = list(fitted.cleaning);
  value["weight"] = experiment.weight;
  value["share_of_cost"] = fitted.share_of_cost;
  base::json::Value responses = base::json::Array{};
  for (const FittedResponse& response : fitted.responses) {
    base::json::Value one;
    one["quantity"] = response.quantity;
    one["unit"] = response.unit;
    one["over"] = response.over.empty() ? "time" : response.over;
    one["points"] = response.measured.size();
    one["rmse_before"] = response.rmse_before;
    one["rmse_after"] = response.rmse_after;
    one["range"] = response.range;
    one["robust_scale"] = response.outliers.scale;
    one["mean_error"] = response.mean_error;
    one["autocorrelation"] = response.autocorrelation;
    one["outlier_limit"] = response.outliers.limit;
    one["outliers"] = outliers_of(response);
    const std::vector<std::size_t> told = told_points(response.measured.size());
    one["points_told"] = told.size();
    one["time"] = some_of(response.time, told);
    if (!response.over.empty()) {
      one["over_unit"] = response.over_unit;
      one["abscissa"] = some_of(response.abscissa, told);
    }
    one["measured"] = some_of(response.measured, told);
    one["before"] = some_of(response.before, told);
    one["after"] = some_of(response.after, told);
    responses.push_back(one);
  }
  value["responses"] = responses;
  return value;
}

base::json::Value profile_of(const Calibration& calibration,
                             const fit::LikelihoodProfile& profile) {
  base::json::Value value;
  value["unknown"] = calibration.unknowns[profile.unknown].name;
  value["value"] = list(profile.value);
  value["cost"] = list(profile.cost);
  value["threshold"] = profile.threshold;
  value["interval"] = pair(profile.lower, profile.upper);
  value["open_below"] = profile.open_below;
  value["open_above"] = profile.open_above;
  return value;
}

}  // namespace

base::json::Value calibration_json(const Fit& fit, const Calibration& calibration) {
  const std::size_t n = calibration.unknowns.size();
  base::json::Value document;
  document["provenance"] = origin(fit, calibration);
  document["result"] = result(fit, calibration);
  document["statistics"] = statistics_of(fit, calibration);
  base::json::Value unknowns = base::json::Array{};
  for (std::size_t u = 0; u < n; ++u) unknowns.push_back(unknown_of(calibration, u));
  document["unknowns"] = unknowns;
  document["correlation"] = matrix(calibration.statistics.correlation, n);
  document["covariance"] = matrix(calibration.statistics.covariance, n);
  base::json::Value tables = base::json::Array{};
  for (const FittedTable& table : calibration.tables) {
    tables.push_back(table_of(fit, calibration, table));
  }
  document["tables"] = tables;
  base::json::Value experiments = base::json::Array{};
  for (const FittedExperiment& fitted : calibration.experiments) {
    experiments.push_back(experiment_of(fit, fitted));
  }
  document["experiments"] = experiments;
  base::json::Value profiles = base::json::Array{};
  for (const fit::LikelihoodProfile& profile : calibration.profiles) {
    profiles.push_back(profile_of(calibration, profile));
  }
  document["profiles"] = profiles;
  document["notes"] = list(calibration.notes);
  return document;
}

base::FileMark calibration_mark(const Fit& fit) {
  const std::string name = fit.file_name();
  return {"a result of " + name, "{\n  \"provenance\": {\n    \"program\": \"slipbench\",",
          "\"fit\": " + base::json::Value(name).dump() + ","};
}

}  // namespace slipbench::driver::calibrate
