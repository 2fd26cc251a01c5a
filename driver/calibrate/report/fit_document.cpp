// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string_view>

#include "driver/calibrate/estimate_text.hpp"
#include "driver/calibrate/report/drawn_points.hpp"
#include "driver/calibrate/report/fit_report.hpp"
#include "driver/calibrate/report/residual_view.hpp"
#include "driver/calibrate/report/table_view.hpp"
#include "driver/report/json_text.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Points of all responses together that a page draws, as long as each has the fewest.
constexpr std::size_t kPointsOfPage = 24000;
constexpr std::size_t kMostPoints = 3000;
constexpr std::size_t kFewestPoints = 400;
/// Unknowns whose correlations a page shows: of more those with the strongest ones.
constexpr std::size_t kMostCorrelated = 40;

std::int64_t count_of(std::size_t count) { return static_cast<std::int64_t>(count); }

void write_series(report::JsonText& json, std::string_view name, std::span<const double> numbers) {
  json.key(name);
  json.series(numbers);
}

/// An entry of a list that may be shorter, such as that of a bootstrap that was not asked for.
double entry(const std::vector<double>& list, std::size_t i) {
  return i < list.size() ? list[i] : std::nan("");
}
bool flag(const std::vector<char>& list, std::size_t i) { return i < list.size() && list[i] != 0; }

std::string loss_text(const fit::Loss& loss) {
  switch (loss.kind) {
    case fit::Loss::Kind::kSquares:
      return "squares";
    case fit::Loss::Kind::kHuber:
      return fmt::format("Huber, threshold {:.6g}", loss.threshold);
    case fit::Loss::Kind::kSoftL1:
      break;
  }
  return fmt::format("soft L1, threshold {:.6g}", loss.threshold);
}

void write_verdict(report::JsonText& json, const Calibration& calibration, const Fit& fit) {
  const fit::LeastSquaresFit& found = calibration.fit;
  const fit::FitStatistics& statistics = calibration.statistics;
  json.key("verdict");
  json.begin_object();
  json.member("converged", found.converged);
  json.member("sentence", found.stop_sentence);
  json.member("iterations", std::int64_t{found.iterations});
  json.member("start_cost", found.start_cost);
  json.member("cost", found.cost);
  json.member("polished", found.polished);
  json.end_object();
  json.member_texts("notes", calibration.notes);
  json.key("figures");
  json.begin_object();
  json.member("data", count_of(statistics.data));
  json.member("unknowns", count_of(calibration.unknowns.size()));
  json.member("free", count_of(statistics.unknowns));
  json.member("deviation", statistics.deviation);
  json.member("condition", statistics.condition);
  json.member("gradient", found.gradient_norm);
  json.member("runs", std::int64_t{found.residual_evaluations});
  json.member("derivative_runs", std::int64_t{found.derivative_evaluations});
  json.member("derivatives", calibration.derivatives);
  json.member_if("starts", starts_text(found));
  json.member("loss", loss_text(fit.loss));
  json.member("confidence", fit.confidence);
  if (calibration.bootstrap.done > 0 || calibration.bootstrap.wanted > 0) {
    json.member("bootstrap", std::int64_t{calibration.bootstrap.done});
    json.member("bootstrap_wanted", std::int64_t{calibration.bootstrap.wanted});
  }
  json.end_object();
}

void write_unknown(report::JsonText& json, const Calibration& calibration, std::size_t i) {
  const FittedUnknown& unknown = calibration.unknowns[i];
  const fit::FitStatistics& statistics = calibration.statistics;
  json.begin_object();
  json.member("name", unknown.name);
  if (const std::string told = told_name(calibration, i); told != unknown.name) {
    json.member("told", told);
  }
  json.member("unit", unknown.unit);
  json.member("scale", unknown.range.scale == fit::Scale::kLog ? "log" : "linear");
  json.member("start", unknown.range.start);
  json.member("lower", unknown.range.lower);
  json.member("upper", unknown.range.upper);
  json.member("value", unknown.value);
  json.member("error", entry(statistics.standard_error, i));
  json.member("low", entry(statistics.lower, i));
  json.member("high", entry(statistics.upper, i));
  if (calibration.bootstrap.done > 0) {
    json.member("bootstrap_error", entry(calibration.bootstrap.standard_error, i));
    json.member("bootstrap_low", entry(calibration.bootstrap.lower, i));
    json.member("bootstrap_high", entry(calibration.bootstrap.upper, i));
  }
  json.member("seen", word_of(unknown.identifiability));
  json.member_if("why", unknown.why);
  json.member_if("moved_by", unknown.moved_by);
  json.member_if("held_by", unknown.held_by);
  json.member("visits", unknown.visits);
  json.member("to_lower", unknown.distance_to_lower);
  json.member("to_upper", unknown.distance_to_upper);
  json.member("frozen", flag(calibration.fit.frozen, i));
  json.member("at_lower", flag(calibration.fit.at_lower, i));
  json.member("at_upper", flag(calibration.fit.at_upper, i));
  for (std::size_t t = 0; t < calibration.tables.size(); ++t) {
    const FittedTable& table = calibration.tables[t];
    if (i >= table.first_unknown && i < table.first_unknown + table.count) {
      json.member("table", count_of(t));
    }
  }
  json.end_object();
}

/// The unknowns whose correlations are shown, in their order.
std::vector<std::size_t> correlated_unknowns(const Calibration& calibration) {
  const std::size_t n = calibration.unknowns.size();
  const std::vector<double>& matrix = calibration.statistics.correlation;
  if (n == 0 || matrix.size() != n * n) return {};
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(matrix[i * n + i])) shown.push_back(i);
  }
  if (shown.size() <= kMostCorrelated) return shown;
  std::vector<double> strongest(n, 0.0);
  for (const std::size_t i : shown) {
    for (const std::size_t k : shown) {
      if (i != k) strongest[i] = std::max(strongest[i], std::abs(matrix[i * n + k]));
    }
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [&](std::size_t a, std::size_t b) { return strongest[a] > strongest[b]; });
  shown.resize(kMostCorrelated);
  std::sort(shown.begin(), shown.end());
  return shown;
}

void write_correlation(report::JsonText& json, const Calibration& calibration) {
  const std::vector<std::size_t> shown = correlated_unknowns(calibration);
  const std::size_t n = calibration.unknowns.size();
  json.key("correlation");
  json.begin_object();
  json.key("unknowns");
  json.begin_array();
  for (const std::size_t i : shown) json.value(count_of(i));
  json.end_array();
  json.key("rows");
  json.begin_array();
  for (const std::size_t i : shown) {
    json.begin_array();
    for (const std::size_t k : shown) json.value(calibration.statistics.correlation[i * n + k], 4);
    json.end_array();
  }
  json.end_array();
  json.end_object();
}

void write_response(report::JsonText& json, const FittedResponse& response, std::size_t limit) {
  const LoopAxis axis = loop_axis(response);
  const DrawnPoints drawn = drawn_points(response, limit);
  const ResidualView left = residual_view(response, response.after);
  json.begin_object();
  json.member("quantity", response.quantity);
  json.member("unit", response.unit);
  json.member("over", response.over);
  json.member("position", axis.name);
  json.member("position_unit", axis.unit);
  json.member("rmse_before", response.rmse_before);
  json.member("rmse_after", response.rmse_after);
  json.member("robust", response.outliers.scale);
  json.member("range", response.range);
  json.member("mean_error", response.mean_error);
  json.member("autocorrelation", response.autocorrelation);
  json.member("points", count_of(response.measured.size()));
  json.member("thinned", drawn.thinned);
  write_series(json, "time", drawn.time);
  write_series(json, "positions", drawn.position);
  write_series(json, "measured", drawn.measured);
  write_series(json, "before", drawn.before);
  write_series(json, "after", drawn.after);
  json.key("left");
  json.begin_object();
  json.member("words", left.words);
  json.key("outliers");
  json.begin_array();
  for (const std::size_t point : left.outliers.points) {
    json.begin_object();
    json.member("time", response.time[point]);
    json.member("residual", left.residuals[point]);
    json.end_object();
  }
  json.end_array();
  json.member("trend", left.trend);
  json.member("mean", left.mean);
  json.member("deviation", left.deviation);
  json.member("lowest", left.lowest);
  json.member("highest", left.highest);
  json.key("counts");
  json.begin_array();
  for (const std::int64_t count : left.counts) json.value(count);
  json.end_array();
  json.key("lags");
  json.begin_array();
  for (const double lag : left.autocorrelation) json.value(lag, 4);
  json.end_array();
  json.member("noise_band", left.noise_band);
  json.end_object();
  json.end_object();
}

void write_experiments(report::JsonText& json, const Fit& fit, const Calibration& calibration) {
  std::size_t responses = 0;
  for (const FittedExperiment& one : calibration.experiments) responses += one.responses.size();
  const std::size_t limit =
      std::clamp(kPointsOfPage / std::max<std::size_t>(responses, 1), kFewestPoints, kMostPoints);
  json.key("experiments");
  json.begin_array();
  for (const FittedExperiment& one : calibration.experiments) {
    const ExperimentFit& asked = fit.experiments.at(one.index);
    json.begin_object();
    json.member("name", asked.name);
    json.member("case", asked.case_file);
    json.member("data", asked.data_file);
    json.member("hash", one.data_hash);
    json.member("held_out", asked.held_out);
    json.member("weight", asked.weight);
    json.member("time_unit", asked.base.units.time);
    json.member("rows_read", count_of(one.rows_read));
    json.member("rows_used", count_of(one.rows_used));
    json.member("share", one.share_of_cost);
    json.member_texts("cleaning", one.cleaning);
    json.key("responses");
    json.begin_array();
    for (const FittedResponse& response : one.responses) write_response(json, response, limit);
    json.end_array();
    json.end_object();
  }
  json.end_array();
}

void write_table(report::JsonText& json, const Fit& fit, const Calibration& calibration,
                 const FittedTable& table) {
  const TableView view = table_view(table);
  json.begin_object();
  json.member("name", fit.tables.at(table.index).name);
  json.member("free", fit.tables[table.index].free);
  json.member("unit", calibration.unknowns.at(table.first_unknown).unit);
  json.member("first", count_of(table.first_unknown));
  json.member("count", count_of(table.count));
  json.member("even", view.even);
  json.member("grid", view.grid);
  json.member("cell_grid", view.cell_grid);
  json.key("axes");
  json.begin_array();
  for (const TableView::Axis& axis : view.axes) {
    json.begin_object();
    json.member("name", axis.name);
    json.member("unit", axis.unit);
    write_series(json, "knots", axis.knots);
    json.end_object();
  }
  json.end_array();
  json.key("blocks");
  json.begin_array();
  for (const TableView::Block& block : view.blocks) {
    json.begin_object();
    json.member("label", block.label);
    json.member("first", count_of(block.first));
    write_series(json, "x", block.abscissa);
    write_series(json, "place", block.place);
    json.end_object();
  }
  json.end_array();
  json.key("cells");
  json.begin_array();
  for (const FittedTable::Cell& cell : table.cells) {
    json.begin_object();
    json.member("text", cell.text);
    json.member("visits", cell.visits);
    json.member("visited", cell.visited());
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

void write_searches(report::JsonText& json, const fit::LeastSquaresFit& found) {
  json.key("searches");
  json.begin_array();
  for (const fit::SearchTrace& search : found.searches) {
    json.begin_object();
    const bool known = has_value(search);
    json.member("start_cost", known ? search.start_cost : std::nan(""));
    json.member("cost", known ? search.cost : std::nan(""));
    json.member("found", found_the_minimum(found, search));
    json.member("iterations", std::int64_t{search.iterations});
    json.member("converged", fit::is_convergence(search.stop));
    json.member("stop", fit::stop_text(search.stop));
    write_series(json, "start", search.start);
    write_series(json, "end", search.end);
    json.end_object();
  }
  json.end_array();
}

void write_profile(report::JsonText& json, const fit::LikelihoodProfile& profile) {
  json.begin_object();
  json.member("unknown", count_of(profile.unknown));
  write_series(json, "value", profile.value);
  write_series(json, "cost", profile.cost);
  json.member("threshold", profile.threshold);
  json.member("low", profile.lower);
  json.member("high", profile.upper);
  json.member("open_below", profile.open_below);
  json.member("open_above", profile.open_above);
  json.end_object();
}

}  // namespace

std::string fit_document(const Fit& fit, const Calibration& calibration) {
  report::JsonText json;
  json.begin_object();
  json.member("schema", std::int64_t{1});
  json.member("title", fit.title.empty() ? fit.file : fit.title);
  json.member("file", fit.file);
  json.member("generator", "slipbench " + std::string(results::program_version()));
  if (fit.date) json.member("date", *fit.date);
  write_verdict(json, calibration, fit);
  json.key("unknowns");
  json.begin_array();
  for (std::size_t i = 0; i < calibration.unknowns.size(); ++i) write_unknown(json, calibration, i);
  json.end_array();
  write_correlation(json, calibration);
  write_experiments(json, fit, calibration);
  json.key("tables");
  json.begin_array();
  for (const FittedTable& table : calibration.tables) write_table(json, fit, calibration, table);
  json.end_array();
  write_searches(json, calibration.fit);
  json.key("profiles");
  json.begin_array();
  for (const fit::LikelihoodProfile& profile : calibration.profiles) write_profile(json, profile);
  json.end_array();
  json.end_object();
  return json.take();
}

}  // namespace slipbench::driver::calibrate
