// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/experiment_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/base/files/work_crew.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/results/coverage.hpp"

namespace slipbench::driver::calibrate {
namespace {

/// Steps of central differences, as a part of the unknown: the cube root of the rounding.
constexpr double kDifference = 6.0554544523933429e-06;
/// Those of numbers that follow linearly: the wider, the less rounding.
constexpr double kWideDifference = 0.05;
/// Below so many increments in all, threads cost more than they bring.
constexpr std::size_t kWorthThreads = 20000;

/// Returns what an unknown is large against.
double size_of(const fit::UnknownRange& range, double value) {
  if (value != 0.0) return std::abs(value);
  if (range.start != 0.0) return std::abs(range.start);
  const double width = range.upper - range.lower;
  return std::isfinite(width) && width > 0.0 ? width : 1.0;
}

double largest_magnitude(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  return largest > 0.0 ? largest : 1.0;
}

/// Tells whether two lists of slopes are the same but for the rounding of differences.
bool same_slopes(const std::vector<law::NumberSlope>& a, const std::vector<law::NumberSlope>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    constexpr double kRounding = 1e-8;
    return one.number == other.number && one.unknown == other.unknown &&
           std::abs(one.slope - other.slope) <= kRounding * std::abs(one.slope);
  });
}
bool alike(const law::DefinitionSlopes& a, const law::DefinitionSlopes& b) {
  return same_slopes(a.stick, b.stick) && same_slopes(a.force_limit, b.force_limit) &&
         same_slopes(a.law, b.law) &&
         same_slopes(a.internal_contact_force, b.internal_contact_force) &&
         same_slopes(a.contact_weights, b.contact_weights);
}

void append(const law::DefinitionSlopes& some, law::DefinitionSlopes& all) {
  const auto add = [&](std::vector<law::NumberSlope> law::DefinitionSlopes::*list) {
    (all.*list).insert((all.*list).end(), (some.*list).begin(), (some.*list).end());
  };
  add(&law::DefinitionSlopes::stick);
  add(&law::DefinitionSlopes::force_limit);
  add(&law::DefinitionSlopes::law);
  add(&law::DefinitionSlopes::internal_contact_force);
  add(&law::DefinitionSlopes::contact_weights);
}

template <class T>
void keep(std::vector<T>& values, std::span<const std::size_t> kept) {
  if (values.empty()) return;
  std::vector<T> chosen;
  chosen.reserve(kept.size());
  for (const std::size_t i : kept) chosen.push_back(values[i]);
  values = std::move(chosen);
}

}  // namespace

auto ExperimentModel::make(const Fit& fit, const ExperimentFit& experiment,
                           const ModelOptions& options) -> tl::expected<ExperimentModel, Failure> {
  auto varied = VariedCase::open(fit, experiment, options.ordinates);
  if (!varied) {
    return tl::unexpected(Failure{experiment.case_file + ": " + varied.error(), true, false});
  }
  ExperimentModel model(std::move(*varied), experiment, options);
  if (auto ready = model.prepare(); !ready) return tl::unexpected(ready.error());
  return model;
}

tl::expected<void, ExperimentModel::Failure> ExperimentModel::prepare() {
  // Data and run do not need one another.
  tl::expected<Measurements, base::HistoryError> read;
  tl::expected<RunTrace, std::string> traced;
  std::vector<std::string> positions;
  const auto read_data = [&] { read = read_measurements(*experiment_, options_.with_hash); };
  const auto run_case = [&] {
    RunTrace trace;
    try_replay(trace, positions);
    if (replay_) {
      traced = std::move(trace);
    } else {
      traced = trace_run(experiment_->base, *experiment_, &positions);
    }
  };
  base::for_each_index(2, options_.threads,
                       [&](std::size_t i) { i == 0 ? run_case() : read_data(); });
  if (!read) {
    const base::HistoryError& error = read.error();
    std::string place = error.file;
    if (error.line > 0) place += fmt::format(":{}:{}", error.line, std::max(error.column, 1));
    return tl::unexpected(Failure{place + (place.empty() ? "" : ": ") + error.message,
                                  error.kind == base::HistoryError::Kind::kEnvironment, false});
  }
  if (!traced) {
    return tl::unexpected(
        Failure{fmt::format("{}: at the start values: {}", experiment_->case_file, traced.error()),
                false, true});
  }
  measurements_ = std::move(*read);
  measurements_.rows_used = 0;
  run_rows_ = traced->time.size();
  for (std::size_t r = 0; r < experiment_->responses.size(); ++r) {
    ComparedResponse compared;
    compared.measured = std::move(measurements_.responses[r]);
    measurements_.responses[r] = {};
    compared.first = points_;
    Observations found = observe(compared.measured, r, *traced);
    const std::string name =
        fmt::format("{}, {}", experiment_->name, experiment_->responses[r].quantity_text);
    if (!found.fault.empty()) {
      return tl::unexpected(Failure{fmt::format("{}: {}", name, found.fault), false, false});
    }
    const std::size_t measured = compared.measured.time.size();
    if (found.kept.size() < measured) {
      notes_.push_back(
          fmt::format("{}: {} of {} measured points lie outside of the run and were "
                      "left out",
                      name, measured - found.kept.size(), measured));
    }
    keep(compared.measured.time, found.kept);
    keep(compared.measured.value, found.kept);
    keep(compared.measured.over, found.kept);
    keep(compared.measured.line, found.kept);
    const RunTrace::Response& trace = traced->responses[r];
    if (!trace.position.empty()) {
      compared.position = positions[r];
      compared.positions.resize(found.points.size());
      read_points(trace.position, found.points, compared.positions);
    }
    points_ += found.points.size();
    measurements_.rows_used = std::max(measurements_.rows_used, found.points.size());
    where_.push_back(std::move(found.points));
    responses_.push_back(std::move(compared));
  }
  if (replay_ && !check_lines()) replay_.reset();
  if (replay_) {
    for (std::size_t r = 0; r < responses_.size(); ++r) {
      read_.push_back({.component = forces_[r].component, .factor = 1.0, .points = where_[r]});
    }
    where_.clear();
  }
  choose_derivatives();
  return {};
}

Observations ExperimentModel::observe(const MeasuredSeries& measured, std::size_t response,
                                      const RunTrace& trace) const {
  if (!experiment_->responses[response].over) return observe_times(trace.time, measured.time);
  return observe_positions(trace.time, trace.responses[response].over, measured);
}

void ExperimentModel::try_replay(RunTrace& trace, std::vector<std::string>& positions) {
  const cases::Case& problem = experiment_->base;
  const auto refuse = [&](std::string because) { because_ = std::move(because); };
  if (options_.whole_runs) return refuse("another run did not repeat the history");
  for (const ResponseFit& response : experiment_->responses) {
    const auto force = force_response(problem, response, 1.0);
    if (!force) {
      return refuse(fmt::format("'{}' is more than a friction force", response.quantity_text));
    }
    if (response.over && !is_position(problem, *response.over)) {
      return refuse(fmt::format("'{}' follows from the run", *response.over));
    }
    forces_.push_back(*force);
  }
  auto tracer = RunTracer::make(problem, *experiment_, false);
  if (!tracer) return refuse(tracer.error());
  auto replay = Replay::record(problem, [&](const bench::Row& row) {
    // Without values, nothing can fail.
    static_cast<void>(tracer->take(row));
  });
  if (!replay) return refuse(replay.error());
  // Also what no response reads has to run: a calibrated case is there to be run.
  std::vector<law::FrictionDefinition> definitions;
  for (const cases::CaseDefinition& definition : problem.definitions) {
    definitions.push_back(definition.law);
  }
  if (!replay->show(definitions)) return refuse("it cannot be run at the start values");
  replay_ = std::move(*replay);
  if (std::string why = dependent_history(); !why.empty()) {
    replay_.reset();
    return refuse(std::move(why));
  }
  trace = std::move(tracer->trace());
  positions = tracer->position_names();
}

std::string ExperimentModel::dependent_history() const {
  if (varied_.parameters() == 0) return {};
  const std::vector<double> start = starts();
  // All parameters at once: that their effects cancel to the last bit is not to be expected.
  std::vector<double> moved = start;
  for (std::size_t i = 0; i < varied_.parameters(); ++i) {
    const std::size_t u = varied_.unknowns()[i];
    const fit::UnknownRange& range = options_.unknowns[u];
    const double step = 1e-3 * (1.0 + 0.1 * static_cast<double>(i)) * size_of(range, start[u]);
    moved[u] += moved[u] + step < range.upper ? step : -step;
  }
  const auto changed = varied_.case_at(moved);
  if (!changed) return "the case cannot be read beside the start values: " + changed.error();
  if (replay_->same_history(*changed)) return {};
  std::string names;
  for (std::size_t i = 0; i < varied_.parameters(); ++i) {
    const std::size_t u = varied_.unknowns()[i];
    std::vector<double> one = start;
    one[u] = moved[u];
    const auto other = varied_.case_at(one);
    if (other && replay_->same_history(*other)) continue;
    names += (names.empty() ? "" : ", ") + varied_.parameter_name(i);
  }
  return "the history depends on " + (names.empty() ? "what is varied" : names);
}

bool ExperimentModel::check_lines() {
  plain_ = true;
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    if (forces_[r].plain) continue;
    plain_ = false;
    const double scale = largest_magnitude(responses_[r].measured.value);
    if (force_response(experiment_->base, experiment_->responses[r], scale)) continue;
    because_ =
        fmt::format("'{}' is not linear in its force", experiment_->responses[r].quantity_text);
    return false;
  }
  return true;
}

void ExperimentModel::choose_derivatives() {
  const std::span<const std::size_t> unknowns = varied_.unknowns();
  if (!replay_) {
    by_differences_.assign(unknowns.begin(), unknowns.end());
    return;
  }
  const cases::Case& problem = experiment_->base;
  relevant_.assign(problem.definitions.size(), 0);
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    const law::SlipSpace& slip = problem.definitions[d].law.slip;
    for (int k = 0; k < slip.dimension; ++k) {
      for (const ForceResponse& force : forces_) {
        if (slip.component[static_cast<std::size_t>(k)] == force.component) relevant_[d] = 1;
      }
    }
  }
  const std::vector<double> start = starts();
  // Somewhere else, for what is the same everywhere.
  std::vector<double> moved = start;
  for (std::size_t i = 0; i < varied_.parameters(); ++i) {
    const std::size_t u = unknowns[i];
    moved[u] = sides(start, u, 0.1 + 0.01 * static_cast<double>(i)).second;
  }
  const std::size_t count = problem.definitions.size();
  constant_slopes_.resize(count);
  for (const std::size_t u : unknowns) {
    const std::size_t column = exact_.size();
    std::vector<law::DefinitionSlopes> here(count);
    std::vector<law::DefinitionSlopes> there(count);
    if (!add_slopes(start, u, column, kWideDifference, here)) {
      by_differences_.push_back(u);
      continue;
    }
    exact_.push_back(u);
    // Ordinates enter as they are.
    const bool constant =
        u >= varied_.first_ordinate() ||
        (!options_.slopes_anew && add_slopes(moved, u, column, kDifference, there) &&
         std::equal(here.begin(), here.end(), there.begin(), alike));
    constant_.push_back(constant ? 1 : 0);
    if (!constant) continue;
    for (std::size_t d = 0; d < count; ++d) append(here[d], constant_slopes_[d]);
  }
}

bool ExperimentModel::keeps_slopes(std::span<const double> x) const {
  const std::vector<double> start = starts();
  for (std::size_t column = 0; column < exact_.size(); ++column) {
    const std::size_t u = exact_[column];
    if (constant_[column] == 0 || u >= varied_.first_ordinate()) continue;
    std::vector<law::DefinitionSlopes> at_start(relevant_.size());
    std::vector<law::DefinitionSlopes> here(relevant_.size());
    if (!add_slopes(start, u, column, kWideDifference, at_start) ||
        !add_slopes(x, u, column, kDifference, here) ||
        !std::equal(here.begin(), here.end(), at_start.begin(), alike)) {
      return false;
    }
  }
  return true;
}

std::vector<double> ExperimentModel::starts() const {
  std::vector<double> start;
  for (const fit::UnknownRange& range : options_.unknowns) start.push_back(range.start);
  return start;
}

std::pair<double, double> ExperimentModel::sides(std::span<const double> x, std::size_t u,
                                                 double step) const {
  const fit::UnknownRange& range = options_.unknowns[u];
  const double width = step * size_of(range, x[u]);
  return {std::max(x[u] - width, std::min(range.lower, x[u])),
          std::min(x[u] + width, std::max(range.upper, x[u]))};
}

bool ExperimentModel::add_slopes(std::span<const double> x, std::size_t unknown, std::size_t column,
                                 double step, std::vector<law::DefinitionSlopes>& slopes) const {
  std::vector<double> moved(x.begin(), x.end());
  auto [below, above] = sides(x, unknown, step);
  const auto definitions_with = [&](double& value) {
    moved[unknown] = value;
    auto definitions = varied_.definitions_at(moved);
    if (definitions) return definitions;
    // What lies beside may be nothing that a case can have.
    moved[unknown] = value = x[unknown];
    return varied_.definitions_at(moved);
  };
  const auto lower = definitions_with(below);
  const auto upper = definitions_with(above);
  if (!lower || !upper || !(above > below)) return false;
  for (std::size_t d = 0; d < slopes.size(); ++d) {
    if (relevant_[d] == 0) continue;
    if (!law::add_slopes((*lower)[d], (*upper)[d], above - below, column, &slopes[d])) return false;
  }
  return true;
}

auto ExperimentModel::lines_at(std::span<const double> x) const
    -> std::optional<std::vector<Line>> {
  std::vector<Line> lines(responses_.size());
  if (plain_) return lines;
  const auto numbers = varied_.numbers_at(x);
  if (!numbers) return std::nullopt;
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    if (forces_[r].plain) continue;
    const ResponseFit& response = experiment_->responses[r];
    // A copy: evaluations are not for several threads.
    const base::Expression quantity = response.quantity;
    std::vector<double> arguments;
    for (const std::string& name : response.variables) {
      const auto number = numbers->find(name);
      arguments.push_back(number == numbers->end() ? 0.0 : number->second);
    }
    const auto at = [&](double force) {
      arguments[forces_[r].variable] = force;
      const auto value = quantity(arguments);
      return value ? *value : std::numeric_limits<double>::quiet_NaN();
    };
    const double scale = largest_magnitude(responses_[r].measured.value);
    lines[r] = {(at(scale) - at(-scale)) / (2.0 * scale), at(0.0)};
    if (!std::isfinite(lines[r].gain + lines[r].offset)) return std::nullopt;
  }
  return lines;
}

bool ExperimentModel::values(std::span<const double> x, std::span<double> values) const {
  return replay_ ? values_by_replay(x, values) : values_by_run(x, values);
}

void ExperimentModel::count_cells(std::span<const double> x, const cases::Case& problem,
                                  results::Coverage& coverage) const {
  if (replay_) {
    const auto definitions = varied_.definitions_at(x);
    if (!definitions) return;
    bool initial = true;  // row 0 is no increment
    replay_->show(*definitions, [&](const law::Ambient& end, auto updates) {
      if (!std::exchange(initial, false)) coverage.add(end, updates);
    });
    return;
  }
  // Rows behind one that fails are not visited.
  static_cast<void>(bench::run_case(problem, [&](const bench::Row& row) {
    if (row.index > 0) coverage.add(row);
  }));
}

bool ExperimentModel::values_by_replay(std::span<const double> x, std::span<double> values) const {
  const auto definitions = varied_.definitions_at(x);
  if (!definitions || !replay_->run(*definitions, read_, values)) return false;
  if (plain_) return true;
  const auto lines = lines_at(x);
  if (!lines) return false;
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    for (double& value : values.subspan(responses_[r].first, read_[r].points.size())) {
      value = (*lines)[r].gain * value + (*lines)[r].offset;
    }
  }
  return true;
}

bool ExperimentModel::values_by_run(std::span<const double> x, std::span<double> values) const {
  const auto problem = varied_.case_at(x);
  if (!problem) return false;
  const auto trace = trace_run(*problem, *experiment_);
  if (!trace || trace->time.empty()) return false;
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    const ComparedResponse& compared = responses_[r];
    // The history may have changed: the points are looked for again.
    const std::size_t count = compared.measured.time.size();
    const Observations found = observe(compared.measured, r, *trace);
    std::vector<Replay::Point> points = where_[r];
    if (found.points.size() == count) {
      points = found.points;
    } else if (trace->time.size() != run_rows_) {
      return false;
    } else {
      // Those that it does not reach now are met where they were.
      for (std::size_t i = 0; i < found.kept.size(); ++i) points[found.kept[i]] = found.points[i];
    }
    read_points(trace->responses[r].value, points, values.subspan(compared.first, count));
  }
  return true;
}

bool ExperimentModel::derivatives(std::span<const double> x, std::span<double> values,
                                  std::span<double> jacobian) const {
  const std::size_t n = x.size();
  if (exact_.size() < n) std::fill(jacobian.begin(), jacobian.end(), 0.0);
  if (exact_.empty()) {
    if (!this->values(x, values)) return false;
  } else if (!exact_derivatives(x, values, jacobian)) {
    return false;
  }
  return by_differences_.empty() || add_differences(x, by_differences_, values, jacobian);
}

bool ExperimentModel::exact_derivatives(std::span<const double> x, std::span<double> values,
                                        std::span<double> jacobian) const {
  const std::size_t n = x.size();
  const std::size_t count = exact_.size();
  std::vector<law::DefinitionSlopes> slopes = constant_slopes_;
  std::vector<std::size_t> lost;
  for (std::size_t column = 0; column < count; ++column) {
    if (constant_[column] != 0) continue;
    if (!add_slopes(x, exact_[column], column, kDifference, slopes)) {
      lost.push_back(exact_[column]);
    }
  }
  for (law::DefinitionSlopes& of : slopes) of.unknowns = count;
  const auto definitions = varied_.definitions_at(x);
  if (!definitions) return false;
  if (count == n && plain_) {
    if (!replay_->run(*definitions, slopes, n, read_, values, jacobian)) return false;
  } else {
    std::vector<double> columns(points_ * count);
    if (!replay_->run(*definitions, slopes, count, read_, values, columns)) return false;
    for (std::size_t row = 0; row < points_; ++row) {
      for (std::size_t c = 0; c < count; ++c) {
        jacobian[row * n + exact_[c]] = columns[row * count + c];
      }
    }
    if (!plain_ && !take_lines(x, values, jacobian)) return false;
  }
  return lost.empty() || add_differences(x, lost, values, jacobian);
}

bool ExperimentModel::take_lines(std::span<const double> x, std::span<double> values,
                                 std::span<double> jacobian) const {
  const std::size_t n = x.size();
  const auto lines = lines_at(x);
  if (!lines) return false;
  // gain' force + offset' of the parameters that the quantity itself uses.
  std::vector<std::vector<Line>> slopes;
  std::vector<double> moved(x.begin(), x.end());
  for (std::size_t i = 0; i < varied_.parameters(); ++i) {
    const std::size_t u = varied_.unknowns()[i];
    const auto [below, above] = sides(x, u, kDifference);
    moved[u] = below;
    const auto lower = lines_at(moved);
    moved[u] = above;
    const auto upper = lines_at(moved);
    moved[u] = x[u];
    if (!lower || !upper || !(above > below)) return false;
    std::vector<Line> slope(lines->size());
    for (std::size_t r = 0; r < slope.size(); ++r) {
      slope[r] = {((*upper)[r].gain - (*lower)[r].gain) / (above - below),
                  ((*upper)[r].offset - (*lower)[r].offset) / (above - below)};
    }
    slopes.push_back(std::move(slope));
  }
  for (std::size_t r = 0; r < responses_.size(); ++r) {
    const Line& line = (*lines)[r];
    for (std::size_t i = 0; i < read_[r].points.size(); ++i) {
      const std::size_t row = responses_[r].first + i;
      for (double& slope : jacobian.subspan(row * n, n)) slope *= line.gain;
      for (std::size_t k = 0; k < slopes.size(); ++k) {
        jacobian[row * n + varied_.unknowns()[k]] +=
            slopes[k][r].gain * values[row] + slopes[k][r].offset;
      }
      values[row] = line.gain * values[row] + line.offset;
    }
  }
  return true;
}

bool ExperimentModel::add_differences(std::span<const double> x,
                                      std::span<const std::size_t> unknowns,
                                      std::span<const double> values,
                                      std::span<double> jacobian) const {
  const std::size_t n = x.size();
  std::vector<double> beside(2 * unknowns.size() * points_);
  std::vector<double> steps(2 * unknowns.size());
  const auto run = [&](std::size_t i) {
    const std::size_t u = unknowns[i / 2];
    const auto [below, above] = sides(x, u, kDifference);
    std::vector<double> moved(x.begin(), x.end());
    moved[u] = i % 2 == 0 ? below : above;
    const auto here = std::span(beside).subspan(i * points_, points_);
    steps[i] = moved[u] - x[u];
    if (steps[i] != 0.0 && this->values(moved, here)) return;
    // What lies beside may be nothing that a case can have.
    steps[i] = 0.0;
    std::copy(values.begin(), values.end(), here.begin());
  };
  const bool worth = steps.size() * std::max(run_rows_, points_) >= kWorthThreads;
  base::for_each_index(steps.size(), worth ? options_.threads : 1, run);
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double width = steps[2 * k + 1] - steps[2 * k];
    if (!(width > 0.0)) return false;
    const double* below = beside.data() + 2 * k * points_;
    const double* above = below + points_;
    for (std::size_t row = 0; row < points_; ++row) {
      jacobian[row * n + unknowns[k]] = (above[row] - below[row]) / width;
    }
  }
  return true;
}

}  // namespace slipbench::driver::calibrate
