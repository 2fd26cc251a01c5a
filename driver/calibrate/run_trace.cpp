// SPDX-License-Identifier: Apache-2.0
#include "driver/calibrate/run_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "driver/bench/run_case.hpp"
#include "law/base/notation.hpp"

namespace slipbench::driver::calibrate {
namespace {

std::optional<int> component_of(const cases::Case& problem, const results::Column& column) {
  if (!results::is_friction_force(column) || column.definition < 0) return std::nullopt;
  const law::SlipSpace& slip =
      problem.definitions[static_cast<std::size_t>(column.definition)].law.slip;
  return slip.component[static_cast<std::size_t>(column.index)];
}

/// The position of the component whose friction force is the only one that a quantity uses.
std::optional<results::Column> position_column(const cases::Case& problem,
                                               std::span<const results::Column> columns,
                                               const ResponseFit& response) {
  std::optional<int> component;
  for (const std::string& name : response.variables) {
    const auto column = results::find_column(problem, columns, name);
    if (!column) continue;
    const auto here = component_of(problem, *column);
    if (!here || (component && *component != *here)) return std::nullopt;
    component = here;
  }
  if (!component) return std::nullopt;
  const auto is_its_position = [&](const results::Column& column) {
    return results::is_position(column) && column.index == *component &&
           column.name.starts_with("CP");
  };
  const auto found = std::find_if(columns.begin(), columns.end(), is_its_position);
  return found == columns.end() ? std::nullopt : std::optional<results::Column>(*found);
}

/// The text of a quantity that is nothing but a column.
bool is_plain(const ResponseFit& response) {
  std::string_view text = response.quantity.text();
  while (!text.empty() && (text.front() == '=' || text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return response.variables.size() == 1 && text == response.variables.front();
}

}  // namespace

std::optional<ForceResponse> force_response(const cases::Case& problem, const ResponseFit& response,
                                            double scale) {
  const std::vector<results::Column> columns = results::result_columns(problem);
  std::optional<ForceResponse> found;
  std::vector<double> arguments(response.variables.size(), 0.0);
  for (std::size_t i = 0; i < response.variables.size(); ++i) {
    const std::string& name = response.variables[i];
    if (name == "t" || name == "T") return std::nullopt;
    if (const auto column = results::find_column(problem, columns, name)) {
      const auto component = component_of(problem, *column);
      if (!component || found) return std::nullopt;
      found = ForceResponse{*component, i, is_plain(response)};
    } else if (const auto number = problem.parameters.find(name);
               number != problem.parameters.end()) {
      arguments[i] = number->second;
    } else {
      return std::nullopt;
    }
  }
  if (!found || found->plain) return found;
  const auto at = [&](double part) {
    arguments[found->variable] = part * scale;
    const auto value = response.quantity(arguments);
    return value ? *value : std::nan("");
  };
  const double offset = at(0.0);
  const double slope = 0.5 * (at(1.0) - at(-1.0));
  constexpr int kProbes = 41;
  constexpr double kRounding = 1e-12;
  for (int i = 0; i < kProbes; ++i) {
    const double part = -2.0 + 0.1 * i;
    const double line = offset + slope * part;
    const double allowed = kRounding * (std::abs(offset) + std::abs(slope));
    if (!(std::abs(at(part) - line) <= allowed)) return std::nullopt;
  }
  return found;
}

tl::expected<RunTracer, std::string> RunTracer::make(const cases::Case& problem,
                                                     const ExperimentFit& experiment,
                                                     bool with_values) {
  RunTracer tracer(problem);
  const std::vector<results::Column> columns = results::result_columns(problem);
  tracer.expressions_.reserve(experiment.responses.size());  // readers keep references
  for (const ResponseFit& response : experiment.responses) {
    Reader reader;
    if (with_values) {
      tracer.expressions_.push_back(response.quantity);
      auto value = check::RowExpression::make(problem, columns, tracer.expressions_.back(),
                                              response.variables);
      if (!value) return tl::unexpected(value.error());
      reader.value = std::move(*value);
    }
    if (response.over) {
      reader.over = results::find_column(problem, columns, *response.over);
      if (!reader.over) {
        return tl::unexpected("there is no result column '" + *response.over + "'");
      }
    } else {
      reader.position = position_column(problem, columns, response);
    }
    tracer.position_names_.push_back(reader.position ? reader.position->name : std::string());
    tracer.readers_.push_back(std::move(reader));
  }
  tracer.trace_.responses.resize(experiment.responses.size());
  return tracer;
}

tl::expected<void, std::string> RunTracer::take(const bench::Row& row) {
  trace_.time.push_back(row.time);
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    Reader& reader = readers_[i];
    RunTrace::Response& response = trace_.responses[i];
    if (reader.value) {
      const auto value = (*reader.value)(row);
      if (!value) {
        return tl::unexpected(fmt::format("'{}' has no value at time {:.6g}: {}",
                                          reader.value->text(), row.time, value.error().message));
      }
      response.value.push_back(*value);
    }
    if (reader.over) response.over.push_back(results::column_value(*reader.over, *case_, row));
    if (reader.position)
      response.position.push_back(results::column_value(*reader.position, *case_, row));
  }
  return {};
}

tl::expected<RunTrace, std::string> trace_run(const cases::Case& problem,
                                              const ExperimentFit& experiment,
                                              std::vector<std::string>* positions) {
  auto tracer = RunTracer::make(problem, experiment, true);
  if (!tracer) return tl::unexpected(tracer.error());
  if (positions != nullptr) *positions = tracer->position_names();
  tl::expected<void, std::string> taken;
  const auto ended =
      bench::follow_cases({&problem, 1}, [&](std::span<const bench::Simulation> runs) {
        taken = tracer->take(runs.front().row());
        return taken.has_value();
      });
  if (!ended) return tl::unexpected(ended.error().message);
  if (!taken) return tl::unexpected(taken.error());
  return std::move(tracer->trace());
}

bool is_position(const cases::Case& problem, std::string_view name) {
  const auto column = results::find_column(problem, results::result_columns(problem), name);
  return column && results::is_position(*column);
}

}  // namespace slipbench::driver::calibrate
