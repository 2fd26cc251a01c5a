// SPDX-License-Identifier: Apache-2.0
#include "driver/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>
#include <utility>
#include <variant>

#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

SimulationFailure failure(const HistoryError& error) {
  using Kind = SimulationFailure::Kind;
  std::string place = error.file;
  if (error.line > 0) place += fmt::format(":{}", error.line);
  if (error.line > 0 && error.column > 0) place += fmt::format(":{}", error.column);
  if (!place.empty()) place += ": ";
  return {error.kind == HistoryError::Kind::kInput ? Kind::kInput : Kind::kEnvironment,
          place + error.message};
}

bool is_motion(int quantity) { return quantity < kFirstForce; }

law::Ambient ambient_of(const Quantities& quantities, const law::RelativePosition& reference) {
  law::Ambient ambient;
  std::copy_n(quantities.begin() + kFirstMotion, law::kComponents, ambient.position.values.begin());
  ambient.motion = law::constitutive_motion(ambient.position, reference);
  ambient.temperature = quantities[kTemperatureQuantity];
  ambient.fields = std::span(quantities).subspan(kFirstField);
  return ambient;
}

/// The name of the first number of an update that is not finite; null if there is none.
const char* not_finite(const law::FrictionUpdate& update) {
  // A force or an elastic slip that is not finite spoils work and stored energy too. Two short sums
  // run side by side where one long one would wait for itself.
  const double sum =
      (update.limit + update.normal_force + update.mu + update.phi) +
      (update.stored_energy + update.work + update.dissipation + update.state.accumulated_slip);
  // One infinity or NaN spoils the sum: the single numbers are only looked at when it happened.
  if (std::isfinite(sum)) return nullptr;
  const std::array<std::pair<const char*, double>, 8> named{{
      {"normal force", update.normal_force},
      {"coefficient", update.mu},
      {"limit", update.limit},
      {"slip", update.state.accumulated_slip},
      {"dissipation", update.dissipation},
      {"stored energy", update.stored_energy},
      {"work", update.work},
      {"distance to the limit", update.phi},
  }};
  for (const auto& [name, value] : named) {
    if (!std::isfinite(value)) return name;
  }
  for (const double y : update.state.force) {
    if (!std::isfinite(y)) return "friction force";
  }
  for (const double s : update.state.elastic_slip) {
    if (!std::isfinite(s)) return "elastic slip";
  }
  return nullptr;
}

}  // namespace

Simulation::Simulation(const Case& problem) : case_(&problem) {
  row_.definitions.resize(problem.definitions.size());
  std::copy(problem.initial.values.begin(), problem.initial.values.end(),
            row_.quantities.begin() + kFirstMotion);
  row_.begin = problem.initial;
}

tl::expected<Simulation, SimulationFailure> Simulation::start(const Case& problem) {
  Simulation simulation(problem);
  if (auto begun = simulation.start_history(); !begun) return tl::unexpected(begun.error());
  // An update without motion: the initial limits, coefficients and regimes.
  if (auto updated = simulation.update_definitions(); !updated) {
    return tl::unexpected(updated.error());
  }
  return simulation;
}

tl::expected<Simulation, SimulationFailure> Simulation::resume(const Case& problem,
                                                               const SimulationState& state) {
  Simulation simulation(problem);
  if (auto begun = simulation.start_history(); !begun) return tl::unexpected(begun.error());
  while (simulation.row_.index < state.increments) {
    auto advanced = simulation.advance_history();
    if (!advanced) return tl::unexpected(advanced.error());
    if (!*advanced) {
      return tl::unexpected(SimulationFailure{
          SimulationFailure::Kind::kInput,
          fmt::format("the history has {} increments; the state was taken after {}",
                      simulation.row_.index, state.increments)});
    }
  }
  for (std::size_t i = 0; i < state.definitions.size(); ++i) {
    DefinitionRow& definition = simulation.row_.definitions.at(i);
    definition.update.state = state.definitions[i].friction;
    definition.dissipation = state.definitions[i].dissipation;
    definition.work = state.definitions[i].work;
  }
  return simulation;
}

tl::expected<bool, SimulationFailure> Simulation::advance() {
  auto advanced = advance_history();
  if (!advanced || !*advanced) return advanced;
  if (auto updated = update_definitions(); !updated) return tl::unexpected(updated.error());
  return true;
}

SimulationState Simulation::state() const {
  SimulationState state;
  state.increments = row_.index;
  for (const DefinitionRow& definition : row_.definitions) {
    state.definitions.push_back({definition.update.state, definition.dissipation, definition.work});
  }
  return state;
}

tl::expected<void, SimulationFailure> Simulation::start_history() {
  if (case_->measured) {
    auto opened = MeasuredHistory::open(*case_->measured);
    if (!opened) return tl::unexpected(failure(opened.error()));
    measured_ = std::move(*opened);
    auto read = measured_->advance();
    if (!read) return tl::unexpected(failure(read.error()));
    take_measured_row();
    // A measured path starts where its first row says.
    std::copy_n(row_.quantities.begin() + kFirstMotion, law::kComponents,
                row_.begin.values.begin());
    row_.time = row_.step_time = measured_->time();
    return {};
  }
  if (case_->steps.empty()) return {};
  if (auto begun = begin_step(); !begun) return begun;
  // Motions start where the connector is; whatever else is driven has its first value.
  const Step& step = case_->steps.front();
  for (std::size_t i = 0; i < step.drives.size(); ++i) {
    const int quantity = step.drives[i].quantity;
    if (!is_motion(quantity)) {
      row_.quantities[static_cast<std::size_t>(quantity)] = cursors_[i].start_value();
    }
  }
  return {};
}

void Simulation::take_measured_row() {
  const auto values = measured_->values();
  const auto& columns = case_->measured->columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    row_.quantities[columns[i].quantity] = values[i];
  }
}

tl::expected<bool, SimulationFailure> Simulation::advance_measured() {
  auto read = measured_->advance();
  if (!read) return tl::unexpected(failure(read.error()));
  if (!*read) return false;
  std::copy_n(row_.quantities.begin() + kFirstMotion, law::kComponents, row_.begin.values.begin());
  take_measured_row();
  const double time = measured_->time();
  row_.duration = time - row_.time;
  row_.time = row_.step_time = time;
  ++row_.index;
  return true;
}

/// Opens the profiles of the current step and begins its first pass.
tl::expected<void, SimulationFailure> Simulation::begin_step() {
  const Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  cursors_.clear();
  for (const Drive& drive : step.drives) {
    auto cursor = ProfileCursor::open(drive.profile);
    if (!cursor) return tl::unexpected(failure(cursor.error()));
    cursors_.push_back(std::move(*cursor));
  }
  row_.pass = 0;
  return begin_pass();
}

tl::expected<void, SimulationFailure> Simulation::begin_pass() {
  const Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  pass_start_ = row_.time;
  grid_ = StepGrid(step.duration, step.increments);
  varying_.clear();
  for (std::size_t i = 0; i < step.drives.size(); ++i) {
    const int quantity = step.drives[i].quantity;
    const double current = row_.quantities[static_cast<std::size_t>(quantity)];
    auto begun = cursors_[i].begin({step.duration, current, pass_start_});
    if (!begun) {
      SimulationFailure fault = failure(begun.error());
      fault.message =
          fmt::format("step '{}', {}: {}", step.name, quantity_name(quantity), fault.message);
      return tl::unexpected(std::move(fault));
    }
    if (is_motion(quantity)) note_jump(quantity, current, cursors_[i].start_value());
    if (!is_motion(quantity) && std::holds_alternative<Constant>(step.drives[i].profile)) {
      row_.quantities[static_cast<std::size_t>(quantity)] = cursors_[i].start_value();
    } else {
      varying_.push_back(i);
    }
  }
  breakpoint_ = next_breakpoint(cursors_, 0.0);
  in_step_ = true;
  return {};
}

void Simulation::note_jump(int component, double from, double to) {
  // Below this part of the positions passed so far, the difference is the rounding of a path that
  // was meant to go on (a sine of whole periods ends beside 0).
  constexpr double kRounding = 1e-9;
  const double extent = extent_[static_cast<std::size_t>(component)];
  if (std::abs(to - from) <= kRounding * std::max({std::abs(from), std::abs(to), extent})) return;
  if (jumps_.size() < kMostJumps) {
    const Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
    jumps_.push_back({component, to - from, row_.time, step.name});
  }
}

tl::expected<bool, SimulationFailure> Simulation::advance_history() {
  if (measured_) return advance_measured();
  if (!in_step_) return false;
  const Step* step = &case_->steps[static_cast<std::size_t>(row_.step)];
  if (grid_.at_end()) {
    if (row_.pass + 1 < step->repeat) {
      ++row_.pass;
      if (auto begun = begin_pass(); !begun) return tl::unexpected(begun.error());
    } else if (static_cast<std::size_t>(row_.step) + 1 < case_->steps.size()) {
      ++row_.step;
      if (auto begun = begin_step(); !begun) return tl::unexpected(begun.error());
      step = &case_->steps[static_cast<std::size_t>(row_.step)];
    } else {
      return false;
    }
  }
  const double from = grid_.time();
  if (from + kSameTime * step->duration >= breakpoint_) {
    breakpoint_ = next_breakpoint(cursors_, from);
  }
  const double to = grid_.advance(breakpoint_);
  std::copy_n(row_.quantities.begin() + kFirstMotion, law::kComponents, row_.begin.values.begin());
  double sum = 0.0;
  for (const std::size_t i : varying_) {
    const double value = cursors_[i].value(to);
    const auto quantity = static_cast<std::size_t>(step->drives[i].quantity);
    row_.quantities[quantity] = value;
    if (quantity < extent_.size()) extent_[quantity] = std::max(extent_[quantity], std::abs(value));
    sum += value;
  }
  if (!std::isfinite(sum)) {
    for (const std::size_t i : varying_) {
      const int quantity = step->drives[i].quantity;
      const auto where = fmt::format("step '{}', t = {}, {}: ", step->name, format_number(to),
                                     quantity_name(quantity));
      if (const auto& error = cursors_[i].error()) {
        SimulationFailure fault = failure(*error);
        fault.message = where + fault.message;
        return tl::unexpected(std::move(fault));
      }
      if (!std::isfinite(row_.quantities[static_cast<std::size_t>(quantity)])) {
        return tl::unexpected(
            SimulationFailure{SimulationFailure::Kind::kInput, where + "is not a finite number"});
      }
    }
  }
  row_.step_time = to;
  row_.time = pass_start_ + to;
  row_.duration = to - from;
  ++row_.index;
  return true;
}

tl::expected<void, SimulationFailure> Simulation::update_definitions() {
  law::ConnectorIncrement increment;
  increment.duration = row_.duration;
  increment.begin_position = row_.begin;
  increment.end = ambient_of(row_.quantities, case_->reference);
  std::copy_n(row_.quantities.begin() + kFirstForce, law::kComponents,
              increment.force.values.begin());
  for (std::size_t i = 0; i < row_.definitions.size(); ++i) {
    DefinitionRow& here = row_.definitions[i];
    const law::FrictionState old = here.update.state;
    // In place: an assignment would build the result elsewhere and copy its 400 bytes.
    static_assert(std::is_trivially_destructible_v<law::FrictionUpdate>);
    ::new (&here.update)
        law::FrictionUpdate(law::update(case_->definitions[i].law, increment, old));
    here.dissipation += here.update.dissipation;
    here.work += here.update.work;
    if (const char* what = not_finite(here.update)) {
      return tl::unexpected(numerical_failure(i, what));
    }
  }
  return {};
}

SimulationFailure Simulation::numerical_failure(std::size_t definition, const char* what) const {
  const std::string step =
      measured_ ? fmt::format("row {} of the measured history", row_.index + 1)
                : fmt::format("step '{}', t = {}",
                              case_->steps.empty()
                                  ? std::string()
                                  : case_->steps[static_cast<std::size_t>(row_.step)].name,
                              format_number(row_.step_time));
  return {SimulationFailure::Kind::kNumerical,
          fmt::format("{} (total time {}): definition '{}': the {} is not finite", step,
                      format_number(row_.time), case_->definitions[definition].name, what)};
}

}  // namespace slipbench::driver
