// SPDX-License-Identifier: Apache-2.0
#include "tests/driver/calibrate/report/made_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tests/support/dice.hpp"

namespace slipbench::driver::calibrate {
namespace {

using test::Dice;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The sum of twelve dice has deviation 1.
double noise(Dice& dice, double deviation) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += dice.between(0.0, 1.0);
  return deviation * sum;
}

double root_mean_square(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double next_point_correlation(const std::vector<double>& a, const std::vector<double>& b,
                              double mean) {
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double here = a[i] - b[i] - mean;
    squares += here * here;
    if (i + 1 < a.size()) products += here * (a[i + 1] - b[i + 1] - mean);
  }
  return squares > 0.0 ? products / squares : 0.0;
}

void finish(FittedResponse& response) {
  response.rmse_before = root_mean_square(response.before, response.measured);
  response.rmse_after = root_mean_square(response.after, response.measured);
  const auto [low, high] = std::minmax_element(response.measured.begin(), response.measured.end());
  response.range = *high - *low;
  response.mean_error = 0.0;
  for (std::size_t i = 0; i < response.after.size(); ++i) {
    response.mean_error +=
        (response.after[i] - response.measured[i]) / static_cast<double>(response.after.size());
  }
  response.autocorrelation =
      next_point_correlation(response.after, response.measured, response.mean_error);
}

struct SliderLoop {
  double amplitude = 0.5;
  double limit = 20.0;
  double stiffness = 400.0;
  double limit_before = 30.0;
  double stiffness_before = 200.0;
  double noise = 0.2;
  double trend = 0.0;
  int points = 600;
};

FittedResponse slider_response(const SliderLoop& loop, Dice& dice) {
  FittedResponse response;
  response.quantity = "CSF1";
  response.unit = "N";
  response.position = "CP1";
  response.position_unit = "mm";
  for (int i = 0; i < loop.points; ++i) {
    const double t = 2.5 * i / (loop.points - 1);
    response.time.push_back(t);
    response.positions.push_back(loop.amplitude * std::sin(2.0 * std::numbers::pi * t));
  }
  response.before = slider_force(response.positions, loop.limit_before, loop.stiffness_before);
  response.after = slider_force(response.positions, loop.limit, loop.stiffness);
  for (std::size_t i = 0; i < response.after.size(); ++i) {
    response.measured.push_back(response.after[i] + noise(dice, loop.noise) -
                                loop.trend * std::cos(2.0 * std::numbers::pi * response.time[i]));
  }
  finish(response);
  return response;
}

void add_experiment(MadeFit& made, const std::string& name, FittedResponse response,
                    bool held_out = false) {
  ExperimentFit asked;
  asked.name = name;
  asked.case_file = "cases/" + name + ".yaml";
  asked.data_file = "data/" + name + ".csv";
  asked.held_out = held_out;
  asked.base.units = {"mm", "N", "s", "degC"};
  FittedExperiment one;
  one.index = made.fit.experiments.size();
  one.rows_read = 2 * response.measured.size();
  one.rows_used = response.measured.size();
  one.cleaning = {fmt::format("{} rows outside of the time range 0 .. 2.5 left out.",
                              response.measured.size())};
  one.data_hash = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";
  one.responses.push_back(std::move(response));
  made.fit.experiments.push_back(std::move(asked));
  made.calibration.experiments.push_back(std::move(one));
}

FittedUnknown unknown(const std::string& name, const std::string& unit, fit::UnknownRange range,
                      double value) {
  FittedUnknown one;
  one.name = name;
  one.unit = unit;
  one.range = range;
  one.value = value;
  one.visits = 600;
  const double width = range.upper - range.lower;
  one.distance_to_lower = (value - range.lower) / width;
  one.distance_to_upper = (range.upper - value) / width;
  return one;
}

/// Errors of all unknowns as parts of their values, and correlations that fall with their distance.
void state_errors(MadeFit& made, double part, double correlation) {
  Calibration& calibration = made.calibration;
  const std::size_t n = calibration.unknowns.size();
  fit::FitStatistics& statistics = calibration.statistics;
  for (std::size_t i = 0; i < n; ++i) {
    const FittedUnknown& one = calibration.unknowns[i];
    const bool seen = one.identifiability != Identifiability::kNeverVisited;
    const double error = seen ? part * std::abs(one.value) : kNone;
    statistics.standard_error.push_back(error);
    statistics.lower.push_back(one.value - 2.0 * error);
    statistics.upper.push_back(one.value + 2.0 * error);
    statistics.identifiable.push_back(seen ? 1 : 0);
    statistics.unknowns += seen ? 1 : 0;
    calibration.fit.frozen.push_back(seen ? 0 : 1);
    calibration.fit.at_lower.push_back(0);
    calibration.fit.at_upper.push_back(0);
    calibration.fit.x.push_back(one.value);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto apart = static_cast<double>(i > k ? i - k : k - i);
      const bool both = statistics.identifiable[i] != 0 && statistics.identifiable[k] != 0;
      statistics.correlation.push_back(both ? std::pow(-correlation, apart) : kNone);
    }
  }
}

void state_end(MadeFit& made, bool converged, double start_cost, double cost) {
  Calibration& calibration = made.calibration;
  calibration.fit.converged = converged;
  calibration.fit.start_cost = start_cost;
  calibration.fit.cost = cost;
  calibration.fit.iterations = converged ? 14 : 200;
  calibration.fit.stop = converged ? fit::StopReason::kStep : fit::StopReason::kIterations;
  calibration.fit.stop_sentence =
      converged ? "The steps have become negligible."
                : "The 200 iterations allowed are used up, and the cost was still falling: allow "
                  "more, start nearer, or vary less.";
  calibration.fit.residual_evaluations = 31;
  calibration.fit.derivative_evaluations = 15;
  calibration.fit.gradient_norm = converged ? 3e-9 : 0.02;
  calibration.derivatives = "Derivatives: exact in 2 experiments, by differences in 1.";
  calibration.statistics.deviation = 0.2;
  calibration.statistics.condition = 42.0;
  for (const FittedExperiment& one : calibration.experiments) {
    if (!made.fit.experiments[one.index].held_out) {
      calibration.statistics.data += one.responses.front().measured.size();
    }
  }
  calibration.fit.searches.push_back(
      {{}, calibration.fit.x, start_cost, cost, calibration.fit.iterations, calibration.fit.stop});
}

fit::LikelihoodProfile profile_of(const MadeFit& made, std::size_t unknown, bool open) {
  const Calibration& calibration = made.calibration;
  fit::LikelihoodProfile profile;
  profile.unknown = unknown;
  const double value = calibration.unknowns[unknown].value;
  const double error = calibration.statistics.standard_error[unknown];
  profile.threshold = calibration.fit.cost * 1.02;
  for (int i = -12; i <= 12; ++i) {
    const double away = 0.25 * i;
    const double steep = open && i > 0 ? 0.1 : 1.0;
    profile.value.push_back(value + away * error);
    profile.cost.push_back(calibration.fit.cost * (1.0 + 0.005 * steep * away * away));
  }
  profile.lower = value - 2.0 * error;
  profile.upper = open ? std::numeric_limits<double>::infinity() : value + 2.0 * error;
  profile.open_above = open;
  return profile;
}

VariedTable varied_table(const std::string& name, const std::string& free) {
  VariedTable table;
  table.name = name;
  table.free = free;
  table.lower = 0.0;
  table.upper = 1.0;
  return table;
}

}  // namespace

std::vector<double> slider_force(const std::vector<double>& positions, double limit,
                                 double stiffness) {
  std::vector<double> forces;
  double force = 0.0;
  double last = positions.empty() ? 0.0 : positions.front();
  for (const double position : positions) {
    force = std::clamp(force + stiffness * (position - last), -limit, limit);
    last = position;
    forces.push_back(force);
  }
  return forces;
}

MadeFit made_slider_fit() {
  MadeFit made;
  Dice dice(1);
  made.fit.file = "sleeve.fit.yaml";
  made.fit.title = "Sleeve: friction and stick stiffness from two loops";
  made.fit.date = "2026-11-21";
  add_experiment(made, "slow_loop", slider_response({}, dice));
  add_experiment(made, "wide_loop", slider_response({.amplitude = 1.2}, dice));
  add_experiment(made, "small_loop", slider_response({.amplitude = 0.2, .trend = 0.15}, dice),
                 true);
  made.calibration.experiments[0].share_of_cost = 0.48;
  made.calibration.experiments[1].share_of_cost = 0.52;
  made.calibration.unknowns = {
      unknown("mu", "", {0.3, 0.05, 0.6, fit::Scale::kLinear}, 0.2),
      unknown("stick_stiffness", "N/mm", {200.0, 1.0, 1e4, fit::Scale::kLog}, 400.0),
      unknown("internal_force", "N", {20.0, 0.0}, 24.5)};
  made.calibration.unknowns[2].identifiability = Identifiability::kWeak;
  made.calibration.unknowns[2].why = "only its product with mu is told";
  state_errors(made, 0.03, 0.6);
  made.calibration.statistics.correlation = {1.0,  -0.12,  -0.991, -0.12, 1.0,
                                             0.08, -0.991, 0.08,   1.0};
  state_end(made, true, 5321.5, 24.11);
  made.calibration.notes = {
      "mu and internal_force move together (correlation -0.991): the data tell their product."};
  Calibration& calibration = made.calibration;
  calibration.bootstrap.wanted = 200;
  calibration.bootstrap.done = 198;
  for (std::size_t i = 0; i < 3; ++i) {
    const double error = calibration.statistics.standard_error[i];
    calibration.bootstrap.standard_error.push_back(1.1 * error);
    calibration.bootstrap.lower.push_back(calibration.unknowns[i].value - 1.8 * error);
    calibration.bootstrap.upper.push_back(calibration.unknowns[i].value + 2.5 * error);
  }
  calibration.profiles = {profile_of(made, 0, false), profile_of(made, 1, false),
                          profile_of(made, 2, true)};
  for (int i = 1; i < 8; ++i) {
    calibration.fit.searches.push_back(
        {{0.1 * i, 100.0 * i, 20.0},
         calibration.fit.x,
         900.0 * i,
         i % 3 == 2 ? 310.0 : 24.11,
         10 + i,
         i % 3 == 2 ? fit::StopReason::kNoProgress : fit::StopReason::kStep});
  }
  return made;
}

MadeFit made_table_fit() {
  MadeFit made;
  Dice dice(2);
  made.fit.file = "pad_table.yaml";
  made.fit.title = "Brake pad: coefficient over slip rate and temperature";
  made.fit.tables.push_back(varied_table("pad.coefficient", "mu"));
  add_experiment(made, "cold", slider_response({.limit = 18.0}, dice));
  add_experiment(made, "hot", slider_response({.limit = 15.0, .noise = 0.4}, dice));
  FittedTable table;
  table.columns = {"slip_rate", "temperature"};
  table.units = {"mm/s", "degC"};
  const std::vector<double> rates{0.0, 10.0, 50.0, 200.0, 1000.0};
  const std::vector<double> temperatures{20.0, 100.0, 250.0, 400.0};
  const auto seen = [](std::size_t r, std::size_t t) { return r < 4 && t != 3; };
  for (std::size_t t = 0; t < temperatures.size(); ++t) {
    for (std::size_t r = 0; r < rates.size(); ++r) {
      table.points.push_back({rates[r], temperatures[t]});
      const auto far = static_cast<double>(t);
      const double value = 0.42 - 0.03 * static_cast<double>(r) + 0.05 * far - 0.03 * far * far;
      FittedUnknown one =
          unknown(fmt::format("pad.coefficient[{}].mu", table.points.size() - 1), "",
                  {0.35, 0.0, 1.0, fit::Scale::kLinear}, seen(r, t) ? value : 0.35);
      if (!seen(r, t)) {
        one.identifiability = Identifiability::kNeverVisited;
        one.why = "not identifiable: never visited";
        one.visits = 0;
      }
      made.calibration.unknowns.push_back(one);
    }
  }
  for (std::size_t t = 0; t + 1 < temperatures.size(); ++t) {
    for (std::size_t r = 0; r + 1 < rates.size(); ++r) {
      const bool in = seen(r + 1, t + 1);
      table.cells.push_back({fmt::format("slip_rate {} .. {}, temperature {} .. {}", rates[r],
                                         rates[r + 1], temperatures[t], temperatures[t + 1]),
                             in ? static_cast<std::int64_t>(40 * (r + 1) * (t + 2)) : 0});
    }
  }
  table.count = table.points.size();
  made.calibration.tables.push_back(table);
  state_errors(made, 0.02, 0.5);
  state_end(made, true, 800.0, 61.0);
  made.calibration.notes = {"8 of 20 ordinates of pad.coefficient were never visited."};
  return made;
}

MadeFit made_curve_fit() {
  MadeFit made;
  Dice dice(3);
  made.fit.file = "force_over_position.yaml";
  VariedTable asked = varied_table("rod.internal_contact_force", "force");
  asked.use = VariedTable::Use::kInternalContactForce;
  asked.upper = 200.0;
  made.fit.tables.push_back(asked);
  add_experiment(made, "stroke", slider_response({}, dice));
  FittedTable table;
  table.columns = {"CP1"};
  table.units = {"mm"};
  for (int i = 0; i < 9; ++i) {
    table.points.push_back({-0.8 + 0.2 * i});
    FittedUnknown one = unknown(fmt::format("rod.internal_contact_force[{}].force", i), "N",
                                {60.0, 0.0, 200.0, fit::Scale::kLinear}, 60.0 + 6.0 * i);
    if (i == 0 || i == 8) {
      one.identifiability = Identifiability::kNeverVisited;
      one.why = "not identifiable: never visited";
      one.visits = 0;
      one.value = 60.0;
    }
    made.calibration.unknowns.push_back(one);
    if (i > 0) {
      table.cells.push_back({fmt::format("CP1 {:.1f} .. {:.1f}", -1.0 + 0.2 * i, -0.8 + 0.2 * i),
                             i == 1 || i == 8 ? 0 : 75});
    }
  }
  table.count = table.points.size();
  made.calibration.tables.push_back(table);
  state_errors(made, 0.05, 0.3);
  state_end(made, true, 300.0, 12.2);
  return made;
}

MadeFit made_unconverged_fit() {
  MadeFit made;
  Dice dice(4);
  made.fit.file = "brake.yaml";
  made.fit.title = "Band brake, cycles 3 and 4";
  made.fit.loss = {fit::Loss::Kind::kHuber, 2.0};
  add_experiment(made, "brake", slider_response({.stiffness = 250.0, .trend = 3.0}, dice));
  made.calibration.unknowns = {unknown("mu", "", {0.3}, 0.21),
                               unknown("stick_stiffness", "N/mm", {200.0, 0.0}, 250.0),
                               unknown("offset", "N", {0.0, -1.0, 1.0, fit::Scale::kLinear}, 1.0)};
  state_errors(made, 0.0, 0.5);
  fit::FitStatistics& statistics = made.calibration.statistics;
  statistics.standard_error.assign(3, kNone);
  statistics.lower.assign(3, kNone);
  statistics.upper.assign(3, kNone);
  statistics.correlation.assign(9, kNone);
  made.calibration.fit.at_upper[2] = 1;
  made.calibration.unknowns[2].identifiability = Identifiability::kWeak;
  made.calibration.unknowns[2].why = "its interval is wider than its bounds";
  state_end(made, false, 5600.0, 3100.0);
  made.calibration.notes = {"offset ended at its upper bound 1: widen it, or ask why."};
  return made;
}

MadeFit made_large_fit() {
  MadeFit made;
  Dice dice(5);
  made.fit.file = "many.yaml";
  made.fit.title =
      "Twenty unknowns of a connector with a long name, fitted to one long measurement on the rig";
  FittedResponse response = slider_response({.amplitude = 0.9, .points = 20000}, dice);
  response.quantity = "= CSF1 + offset_of_the_load_cell_at_the_lower_end";
  response.over = "CP1";
  response.over_unit = "mm";
  response.abscissa = std::exchange(response.positions, {});
  response.position.clear();
  response.position_unit.clear();
  add_experiment(made, "a_measurement_with_a_very_long_name_on_the_test_rig_number_seventeen_b",
                 std::move(response));
  for (int i = 0; i < 20; ++i) {
    made.calibration.unknowns.push_back(
        unknown(fmt::format("coefficient_of_the_outer_sleeve_at_the_position_{}", i),
                i % 2 ? "N mm" : "", {0.3, 0.0, 1.0, fit::Scale::kLinear}, 0.1 + 0.035 * i));
  }
  state_errors(made, 0.04, 0.97);
  state_end(made, true, 1e6, 412.0);
  return made;
}

MadeFit made_hostile_fit() {
  MadeFit made = made_slider_fit();
  const std::string nasty = "<b>bold</b><script>window.broken = 1</script>\"'&</script>{{chart}}";
  made.fit.title = nasty;
  made.fit.file = nasty;
  made.fit.date = nasty;
  for (ExperimentFit& one : made.fit.experiments) {
    one.name += nasty;
    one.case_file = one.data_file = nasty;
  }
  Calibration& calibration = made.calibration;
  for (FittedUnknown& one : calibration.unknowns) one.name += nasty;
  for (FittedExperiment& one : calibration.experiments) {
    one.cleaning = {nasty};
    one.responses.front().quantity = one.responses.front().unit = nasty;
    one.responses.front().position = one.responses.front().position_unit = nasty;
  }
  calibration.notes = {nasty};
  calibration.fit.stop_sentence = nasty;
  calibration.derivatives = nasty;
  calibration.unknowns[2].why = nasty;
  const MadeFit curve = made_curve_fit();
  made.fit.tables = curve.fit.tables;
  made.fit.tables[0].name = made.fit.tables[0].free = nasty;
  calibration.tables = curve.calibration.tables;
  FittedTable& table = calibration.tables[0];
  table.columns = {nasty};
  table.points = {{0.0}, {1.0}, {2.0}};
  table.count = 3;
  table.cells = {{nasty, 0}, {nasty, 3}};
  return made;
}

std::vector<NamedFit> made_fits() {
  return {{"slider", made_slider_fit}, {"table", made_table_fit},
          {"curve", made_curve_fit},   {"unconverged", made_unconverged_fit},
          {"large", made_large_fit},   {"hostile", made_hostile_fit}};
}

}  // namespace slipbench::driver::calibrate
