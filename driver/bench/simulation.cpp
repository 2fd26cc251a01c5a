// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/belt_motion.hpp"
#include "driver/bench/component_forces.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/bench/dead_zone.hpp"
#include "driver/bench/dynamics.hpp"
#include "driver/bench/equilibrium.hpp"
#include "driver/bench/exact_integration.hpp"
#include "driver/bench/slip_direction.hpp"
#include "law/update/capstan_update.hpp"
#include "law/update/penalty_update.hpp"

namespace slipbench::driver::bench {
namespace {

/// The positions CP1 .. CPR3.
std::span<const double, history::kPositions> position_of(const Quantities& quantities) {
  return std::span(quantities).first<history::kPositions>();
}

bool is_motion(int quantity) { return quantity < cases::kFirstForce; }
bool is_node(int quantity) { return quantity >= cases::kFirstNode; }

/// The name of the first number of an update that is not finite; null if there is none.
const char* not_finite(const law::FrictionUpdate& update) {
  if (law::all_finite(update)) return nullptr;
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

/// Tells whether a coefficient of the definition is kept above a floor at some time.
bool has_floor(const cases::Case& problem, std::size_t index) {
  const law::FrictionDefinition& definition = problem.definitions[index].law;
  bool found =
      law::has_floor(definition.law) ||
      (definition.formulation && definition.formulation->orthotropy &&
       law::has_floor(definition.formulation->orthotropy->second)) ||
      (problem.definitions[index].backward && law::has_floor(*problem.definitions[index].backward));
  for (const cases::Step& step : problem.steps) {
    for (const cases::FrictionChange& change : step.friction_changes) {
      found = found || (change.definition == index && law::has_floor(change.law));
    }
  }
  return found;
}

/// "the exponent C4 V of its coefficient passes 700 at V = 800", or nothing.
std::optional<std::string> overflow(const law::FrictionDefinition& definition,
                                    const DefinitionRow& row) {
  const auto words = [](const law::FrictionLaw& law, double speed) -> std::optional<std::string> {
    const std::string_view name = law::overflow(law, speed);
    if (name.empty()) return std::nullopt;
    return fmt::format(
        "the exponent {} V of the coefficient passes 700 at V = {}: exp({} V) is "
        "beyond any friction",
        name, base::format_number(speed), name);
  };
  if (!definition.formulation || !definition.formulation->orthotropy) {
    return words(definition.law, row.update.slip_rate);
  }
  if (auto first = words(definition.law, row.penalty.speeds[0])) return first;
  return words(definition.formulation->orthotropy->second, row.penalty.speeds[1]);
}

}  // namespace

SimulationFailure to_failure(const base::HistoryError& error) {
  using Kind = SimulationFailure::Kind;
  std::string place = error.file;
  if (error.line > 0) place += fmt::format(":{}", error.line);
  if (error.line > 0 && error.column > 0) place += fmt::format(":{}", error.column);
  if (!place.empty()) place += ": ";
  return {error.kind == base::HistoryError::Kind::kInput ? Kind::kInput : Kind::kEnvironment,
          place + error.message};
}

Simulation::Simulation(const cases::Case& problem) : case_(&problem) {
  row_.definitions.resize(problem.definitions.size());
  for (const cases::CaseDefinition& definition : problem.definitions) {
    definitions_.push_back(definition.law);
    const std::size_t index = definitions_.size() - 1;
    row_.definitions[index].behind.flow = problem.initial[1];
    if (has_floor(problem, index)) with_floor_.push_back(index);
    if (definition.dead_zone) row_.definitions[index].play = definition.dead_zone->start;
    if (definition.backward) {
      other_law_.resize(problem.definitions.size());
      other_law_[index] = *definition.backward;
    }
    has_options_ = has_options_ || definition.dead_zone || definition.backward;
  }
  for (std::size_t i = 0; i < definitions_.size(); ++i) note_falling(i);
  std::copy(problem.initial.values.begin(), problem.initial.values.end(),
            row_.quantities.begin() + cases::kFirstMotion);
  row_.begin = problem.initial;
  begin_ = row_.quantities;
  if (problem.dynamics) dynamics_ = std::make_unique<Dynamics>(problem);
  has_forces_ = has_component_forces(problem);
  if (!problem.force_driven.empty()) equilibrium_ = std::make_unique<Equilibrium>(problem);
  if (problem.integration.method == cases::IntegrationMethod::kExact &&
      !(problem.belt && problem.belt->both_tensions)) {
    exact_ = std::make_unique<ExactIntegration>(problem);
  }
  if (problem.belt && problem.belt->nodes) {
    auto coordinate = row_.quantities.begin() + cases::kFirstNode;
    for (const law::Point& node : *problem.belt->nodes) {
      coordinate = std::copy(node.begin(), node.end(), coordinate);
    }
  }
  plain_ = is_plain();
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

tl::expected<Simulation, SimulationFailure> Simulation::start(const cases::Case& problem) {
  Simulation simulation(problem);
  if (auto begun = simulation.start_history(); !begun) return tl::unexpected(begun.error());
  // An update without motion: the initial limits, coefficients and regimes.
  if (auto updated = simulation.update_definitions(); !updated) {
    return tl::unexpected(updated.error());
  }
  return simulation;
}

tl::expected<Simulation, SimulationFailure> Simulation::resume(const cases::Case& problem,
                                                               const SimulationState& state) {
  // Where motions follow from the law, the walk needs it.
  const bool solved = problem.dynamics || !problem.force_driven.empty();
  Simulation simulation(problem);
  if (auto begun = simulation.start_history(); !begun) return tl::unexpected(begun.error());
  if (solved) {
    if (auto done = simulation.update_definitions(); !done) return tl::unexpected(done.error());
  }
  while (simulation.row_.index < state.increments) {
    auto advanced = solved ? simulation.advance() : simulation.advance_history();
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
    definition.lost = state.definitions[i].lost;
    definition.jumps = state.definitions[i].jumps;
    definition.update.mu = state.definitions[i].mu;
    definition.play = state.definitions[i].play;
    definition.behind = state.definitions[i].behind;
    // The walk knew no coefficients, so not what a change of friction in progress set out from.
    law::CoefficientBlend& blend = simulation.definitions_[i].blend;
    if (blend.weight != 1.0) blend.start = state.definitions[i].mu_start;
  }
  return simulation;
}

tl::expected<void, SimulationFailure> Simulation::walk(
    const cases::Case& problem, const std::function<void(const Row&)>& watch) {
  Simulation simulation(problem);
  if (auto begun = simulation.start_history(); !begun) return begun;
  while (true) {
    if (simulation.has_forces_) {
      if (auto taken = simulation.take_forces(); !taken) return taken;
    }
    watch(simulation.row_);
    const auto advanced = simulation.advance_history();
    if (!advanced) return tl::unexpected(advanced.error());
    if (!*advanced) return {};
  }
}

tl::expected<bool, SimulationFailure> Simulation::advance() {
  auto advanced = advance_history();
  if (!advanced || !*advanced) return advanced;
  if (auto updated = update_definitions(); !updated) {
    if (!measured_) updated.error().step = row_.step;
    return tl::unexpected(std::move(updated.error()));
  }
  note_thresholds(row_);
  return true;
}

SimulationState Simulation::state() const {
  SimulationState state;
  state.increments = row_.index;
  for (std::size_t i = 0; i < row_.definitions.size(); ++i) {
    const DefinitionRow& definition = row_.definitions[i];
    state.definitions.push_back({definition.update.state, definition.dissipation, definition.work,
                                 definition.lost, definition.jumps, definition.update.mu,
                                 definitions_[i].blend.start, definition.play, definition.behind});
  }
  return state;
}

tl::expected<void, SimulationFailure> Simulation::start_history() {
  if (case_->measured) {
    auto opened = history::MeasuredHistory::open(*case_->measured);
    if (!opened) return tl::unexpected(to_failure(opened.error()));
    measured_ = std::move(*opened);
    force_driven_ = case_->force_driven;
    auto read = measured_->advance();
    if (!read) return tl::unexpected(to_failure(read.error()));
    take_measured_row(row_, row_);
    earlier_.assign(measured_->values().begin(), measured_->values().end());
    // A measured path starts where its first row says.
    std::copy_n(row_.quantities.begin() + cases::kFirstMotion, law::kComponents,
                row_.begin.values.begin());
    row_.duration = 0.0;
    return move_belt();
  }
  if (case_->steps.empty()) return move_belt();
  if (auto begun = begin_step(); !begun) return begun;
  // Motions start where the connector is; whatever else is driven has its first value.
  const cases::Step& step = case_->steps.front();
  for (std::size_t i = 0; i < step.drives.size(); ++i) {
    const int quantity = step.drives[i].quantity;
    if (!is_motion(quantity) && !is_node(quantity)) {
      row_.quantities[static_cast<std::size_t>(quantity)] = cursors_[i].start_value();
    }
  }
  return move_belt();
}

tl::expected<void, SimulationFailure> Simulation::move_belt() {
  if (!case_->belt) return {};
  if (auto fault = driver::bench::move_belt(*case_, row_)) {
    return tl::unexpected(
        SimulationFailure{SimulationFailure::Kind::kInput, place() + ": " + *std::move(fault)});
  }
  return {};
}

void Simulation::take_measured_row(const Row& before, Row& row) {
  std::copy_n(before.quantities.begin() + cases::kFirstMotion, law::kComponents,
              row.begin.values.begin());
  const auto values = measured_->values();
  const auto& columns = case_->measured->columns;
  for (std::size_t i = 0; i < columns.size(); ++i) row.quantities[columns[i].quantity] = values[i];
  row.duration = measured_->time() - before.time;
  row.time = row.step_time = measured_->time();
}

tl::expected<bool, SimulationFailure> Simulation::advance_measured() {
  const int pieces = case_->measured_pieces;
  if (piece_ == 0) {
    if (pieces > 1) {
      std::copy(measured_->values().begin(), measured_->values().end(), earlier_.begin());
      earlier_time_ = measured_->time();
    }
    auto read = measured_->advance();
    if (!read) return tl::unexpected(to_failure(read.error()));
    if (!*read) return false;
  }
  if (dynamics_) begin_ = row_.quantities;
  if (exact_) exact_->begin(row_.quantities, definitions_);
  if (++piece_ == pieces) {
    piece_ = 0;
    take_measured_row(row_, row_);
  } else {
    std::copy_n(row_.quantities.begin() + cases::kFirstMotion, law::kComponents,
                row_.begin.values.begin());
    const history::MeasuredSource& source = *case_->measured;
    const double time =
        std::lerp(earlier_time_, measured_->time(), static_cast<double>(piece_) / pieces);
    for (std::size_t i = 0; i < source.columns.size(); ++i) {
      row_.quantities[source.columns[i].quantity] = history::between_rows(
          earlier_time_, earlier_[i], measured_->time(), measured_->values()[i], time, source.hold);
    }
    row_.duration = time - row_.time;
    row_.time = row_.step_time = time;
  }
  ++row_.index;
  if (auto moved = move_belt(); !moved) return tl::unexpected(moved.error());
  return true;
}

/// Opens the profiles of the current step and begins its first pass.
tl::expected<void, SimulationFailure> Simulation::begin_step() {
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  cursors_.clear();
  for (const cases::Drive& drive : step.drives) {
    auto cursor = history::ProfileCursor::open(drive.profile);
    if (!cursor) return tl::unexpected(to_failure(cursor.error()));
    cursors_.push_back(std::move(*cursor));
  }
  row_.pass = 0;
  choose_force_driven(step);
  if (auto begun = begin_friction_changes(); !begun) return begun;
  return begin_pass();
}

tl::expected<void, SimulationFailure> Simulation::begin_friction_changes() {
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  if (step.friction_changes.empty()) return {};
  std::vector<double> mu;
  for (const DefinitionRow& definition : row_.definitions) mu.push_back(definition.update.mu);
  auto begun = friction_changes_.begin_step(step, row_.step == 0, row_.time, mu, definitions_);
  if (!begun) return tl::unexpected(to_failure(begun.error()));
  for (DefinitionRow& definition : row_.definitions) definition.thresholds = {};
  for (const cases::FrictionChange& change : step.friction_changes) note_falling(change.definition);
  return {};
}

void Simulation::note_falling(std::size_t i) {
  std::erase_if(falling_, [&](const Falling& falling) { return falling.definition == i; });
  const bool backward = case_->definitions[i].backward.has_value();
  if (!law::has_increment_thresholds(definitions_[i], definitions_[i].law) &&
      !(backward && law::has_increment_thresholds(definitions_[i], other_law_[i]))) {
    return;
  }
  law::CoefficientBounds bounds = law::coefficient_bounds(definitions_[i].law);
  if (backward) {
    const law::CoefficientBounds other = law::coefficient_bounds(other_law_[i]);
    bounds.largest = std::max(bounds.largest, other.largest);
    bounds.steepest_weakening = std::max(bounds.steepest_weakening, other.steepest_weakening);
  }
  if (bounds.steepest_weakening > 0.0) falling_.push_back({i, bounds});
}

/// Only for definitions whose coefficient may fall: the others' update costs nothing more.
void Simulation::note_thresholds(Row& at) const {
  // The thresholds are those of backward Euler.
  if (falling_.empty() || dynamics_ || exact_ || !(at.duration > 0.0)) return;
  const law::Ambient end = ambient_of(at.quantities, case_->reference);
  for (const auto& [i, bounds] : falling_) {
    DefinitionRow& row = at.definitions[i];
    const law::SlipSpace& slip = definitions_[i].slip;
    double square = 0.0;
    for (int k = 0; k < slip.dimension; ++k) {
      const auto a = static_cast<std::size_t>(k);
      const int c = slip.component[a];
      // A definition with a dead zone has one component.
      double moved = end.position[c] - at.begin[c] - row.travel;
      if (i > 0 && case_->belt && !case_->belt->lengths.empty()) {
        const law::SegmentBehind& before = at.definitions[i - 1].behind;
        moved = before.flow - before.flow_before;
      }
      const double ds = slip.scale[a] * moved;
      square += ds * ds;
    }
    row.thresholds = law::increment_thresholds(
        definitions_[i], bounds, end, row.update.normal_force, std::sqrt(square) / at.duration);
  }
}

tl::expected<void, SimulationFailure> Simulation::begin_pass() {
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  pass_start_ = row_.time;
  grid_ = history::StepGrid(step.duration, step.increments);
  varying_.clear();
  following_.clear();
  for (std::size_t i = 0; i < step.drives.size(); ++i) {
    const int quantity = step.drives[i].quantity;
    const double current = row_.quantities[static_cast<std::size_t>(quantity)];
    history::StepStart start{step.duration, current, pass_start_};
    std::copy_n(row_.quantities.begin() + cases::kFirstMotion, history::kPositions,
                start.position.begin());
    auto begun = cursors_[i].begin(start);
    if (!begun) {
      SimulationFailure fault = to_failure(begun.error());
      fault.message = fmt::format("step '{}', {}: {}", step.name, cases::quantity_name(quantity),
                                  fault.message);
      return tl::unexpected(std::move(fault));
    }
    if (is_motion(quantity)) note_jump(quantity, current, cursors_[i].start_value());
    if (!is_motion(quantity) && std::holds_alternative<history::Constant>(step.drives[i].profile)) {
      row_.quantities[static_cast<std::size_t>(quantity)] = cursors_[i].start_value();
    } else {
      varying_.push_back(i);
      if (cursors_[i].follows_position()) following_.push_back(i);
    }
  }
  breakpoint_ =
      std::min(history::next_breakpoint(cursors_, 0.0), friction_changes_.next_breakpoint(0.0));
  in_step_ = true;
  ++passes_;
  return {};
}

void Simulation::note_jump(int component, double from, double to) {
  // Below this part of the positions passed so far, the difference is the rounding of a path that
  // was meant to go on (a sine of whole periods ends beside 0).
  constexpr double kRounding = 1e-9;
  const double extent = extent_[static_cast<std::size_t>(component)];
  if (std::abs(to - from) <= kRounding * std::max({std::abs(from), std::abs(to), extent})) return;
  if (jumps_.size() < kMostJumps) {
    const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
    jumps_.push_back({component, to - from, row_.time, step.name});
  }
}

tl::expected<bool, SimulationFailure> Simulation::advance_history() {
  if (measured_) return advance_measured();
  if (!in_step_) return false;
  const cases::Step* step = &case_->steps[static_cast<std::size_t>(row_.step)];
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
  pass_breakpoint();
  if (dynamics_ || exact_) {
    begin_ = row_.quantities;
    for (const std::size_t i : varying_) {
      begin_[static_cast<std::size_t>(step->drives[i].quantity)] =
          cursors_[i].value_after(grid_.time());
    }
  }
  if (exact_) exact_->begin(begin_, definitions_);
  if (walk_grid({&row_, 1}, row_) == 0) return tl::unexpected(*std::exchange(failed_, {}));
  if (friction_changes_.active()) {
    friction_changes_.advance(row_.step_time, grid_.at_end(), definitions_);
  }
  if (auto moved = move_belt(); !moved) return tl::unexpected(moved.error());
  return true;
}

void Simulation::pass_breakpoint() {
  const double from = grid_.time();
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  if (from + history::kSameTime * step.duration < breakpoint_) return;
  breakpoint_ =
      std::min(history::next_breakpoint(cursors_, from), friction_changes_.next_breakpoint(from));
}

void Simulation::follow_positions(double step_time, Quantities& quantities) {
  for (const std::size_t i : following_) {
    const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
    cursors_[i].set_position(position_of(quantities));
    quantities[static_cast<std::size_t>(step.drives[i].quantity)] = cursors_[i].value(step_time);
  }
}

FollowPositions Simulation::following() {
  if (following_.empty()) return {};
  return [this](double part, Quantities& quantities) {
    follow_positions(row_.step_time - (1.0 - part) * row_.duration, quantities);
  };
}

void Simulation::choose_force_driven(const cases::Step& step) {
  if (!equilibrium_) return;
  law::ComponentSet now;
  for (int c = 0; c < law::kComponents; ++c) {
    const auto drives = [&](int quantity) {
      return std::any_of(step.drives.begin(), step.drives.end(),
                         [&](const cases::Drive& drive) { return drive.quantity == quantity; });
    };
    const int load_of_c = cases::kFirstForce + c;
    const auto load = static_cast<std::size_t>(load_of_c);
    const bool loaded = drives(load_of_c) && case_->force_driven.contains(c);
    if (loaded || (force_driven_.contains(c) && !drives(cases::kFirstMotion + c))) now.insert(c);
    if (loaded && !force_driven_.contains(c)) {
      // What held the component until now is the load it starts with.
      row_.quantities[load] = begin_[load] = row_.index > 0 ? carried_force(c) : 0.0;
    }
    if (case_->force_driven.contains(c) && !now.contains(c)) {
      row_.quantities[load] = begin_[load] = 0.0;
      row_.forces.component[static_cast<std::size_t>(c)].applied = 0.0;
      row_.forces.component[static_cast<std::size_t>(c)].reaction = 0.0;
    }
  }
  force_driven_ = now;
}

double Simulation::carried_force(int component) const {
  const ComponentForces& forces = row_.forces.component[static_cast<std::size_t>(component)];
  double sum = forces.elastic + forces.viscous;
  for (std::size_t i = 0; i < definitions_.size(); ++i) {
    sum += law::friction_force(definitions_[i], row_.definitions[i].update.state)[component];
  }
  return sum;
}

tl::expected<void, SimulationFailure> Simulation::solve_equilibrium() {
  for (DefinitionRow& definition : row_.definitions) {
    definition.changes.count = 0;
    definition.changes.overflow = false;
  }
  const IntegrateDefinition one =
      [this](std::size_t definition, const law::ConnectorIncrement& increment,
             const law::FrictionState& old) { return integrate(definition, increment, old); };
  const auto solved =
      equilibrium_->solve(force_driven_, begin_, definitions_, one, following(), row_);
  if (!solved) {
    const NoEquilibrium& why = solved.error();
    return tl::unexpected(SimulationFailure{
        SimulationFailure::Kind::kNumerical,
        fmt::format("{}: {}", place((1.0 - why.fraction) * row_.duration), why.message)});
  }
  for (std::size_t i = 0; i < row_.definitions.size(); ++i) {
    if (auto judged = judge(row_, i); !judged) return judged;
  }
  note_raw_coefficients();
  if (auto fault =
          beyond_stop(*case_, force_driven_, connector_increment(*case_, row_).end.position)) {
    return tl::unexpected(
        SimulationFailure{SimulationFailure::Kind::kInput, place() + ": " + *std::move(fault)});
  }
  begin_ = row_.quantities;
  return {};
}

tl::expected<void, SimulationFailure> Simulation::advance_mass(bool start) {
  const int definition = dynamics_->definition();
  const law::FrictionDefinition* friction =
      definition < 0 ? nullptr : &definitions_[static_cast<std::size_t>(definition)];
  if (start) {
    dynamics_->start(friction, row_);
  } else if (const auto done = dynamics_->advance(begin_, friction, following(), row_); !done) {
    return tl::unexpected(SimulationFailure{
        SimulationFailure::Kind::kNumerical,
        fmt::format("{}: {}", place((1.0 - done.error().fraction) * row_.duration),
                    done.error().message)});
  }
  // Coupled springs follow the position of the mass.
  take_springs_and_dampers(*case_, connector_increment(*case_, row_), row_.forces,
                           dynamics_->component());
  if (definition < 0) return {};
  return judge(row_, static_cast<std::size_t>(definition));
}

void Simulation::press() {
  const law::ComponentSet pressing = case_->kinetic.pressing;
  if (pressing.empty()) return;
  law::ConnectorIncrement increment = connector_increment(*case_, row_);
  law::set_kinetic_forces(case_->kinetic, pressing, &increment);
  row_.forces.pressing = increment.force;
  for (int c = 0; c < law::kComponents; ++c) {
    // Before the first increment is solved nothing has rubbed.
    if (force_driven_.contains(c)) row_.forces.pressing[c] = 0.0;
    if (!dynamics_ || c != dynamics_->component()) continue;
    const ComponentForces& mass = row_.forces.component[static_cast<std::size_t>(c)];
    row_.forces.pressing[c] = mass.elastic + mass.viscous - mass.applied;
  }
}

tl::expected<void, SimulationFailure> Simulation::take_forces() {
  const law::ConnectorIncrement increment = connector_increment(*case_, row_);
  if (auto fault = beyond_stop(*case_, {}, increment.end.position)) {
    return tl::unexpected(
        SimulationFailure{SimulationFailure::Kind::kInput, place() + ": " + *std::move(fault)});
  }
  if (!dynamics_) take_springs_and_dampers(*case_, increment, row_.forces);
  for (int c = 0; c < law::kComponents; ++c) {
    if (!force_driven_.contains(c)) continue;
    const int load = cases::kFirstForce + c;
    row_.forces.component[static_cast<std::size_t>(c)].applied =
        row_.quantities[static_cast<std::size_t>(load)];
  }
  if (equilibrium_) begin_ = row_.quantities;
  return {};
}

tl::expected<void, SimulationFailure> Simulation::update_definitions() {
  if (equilibrium_ && !force_driven_.empty() && row_.index > 0) return solve_equilibrium();
  if (dynamics_) {
    if (auto moved = advance_mass(row_.index == 0); !moved) return moved;
  }
  press();
  law::ConnectorIncrement increment = connector_increment(*case_, row_);
  if (case_->belt) prepare_belt(*case_, row_, increment, definitions_);
  if (exact_ && row_.index == 0) exact_->begin(row_.quantities, definitions_);
  for (std::size_t i = 0; i < row_.definitions.size(); ++i) {
    if (dynamics_ && static_cast<int>(i) == dynamics_->definition()) continue;
    DefinitionRow& here = row_.definitions[i];
    const law::FrictionState old = here.update.state;
    here.changes.count = 0;
    here.changes.overflow = false;
    // In place: an assignment would build the result elsewhere and copy its 400 bytes.
    static_assert(std::is_trivially_destructible_v<law::FrictionUpdate>);
    ::new (&here.update) law::FrictionUpdate(
        exact_         ? exact_->update(i, definitions_[i], increment, old, here.changes)
        : has_options_ ? integrate_with_options(i, increment, old)
                       : integrate(i, increment, old));
    add_increment(here.update, here);
    if (auto judged = judge(row_, i); !judged) return judged;
    if (!case_->belt) continue;
    if (auto fault = move_behind(*case_, i, row_)) {
      return tl::unexpected(numerical_failure(row_, i, *fault));
    }
    meet_next_ring(*case_, i, row_, increment);
  }
  note_raw_coefficients();
  if (has_forces_) return take_forces();
  return {};
}

tl::expected<void, SimulationFailure> Simulation::judge(const Row& at,
                                                        std::size_t definition) const {
  const DefinitionRow& row = at.definitions[definition];
  const law::FrictionDefinition& in_force = definitions_[definition];
  if (in_force.formulation && in_force.formulation->filter.kind == law::Filter::Kind::kPeriod &&
      row.penalty.alpha > 1.0) {
    const double period = in_force.formulation->filter.value;
    return tl::unexpected(SimulationFailure{
        SimulationFailure::Kind::kInput,
        fmt::format("{}: definition '{}': alpha = 2 pi dt/T = {:.6g} of its filter is above 1: dt "
                    "= {}, T = {}; take shorter increments or a longer period",
                    place(at), case_->definitions[definition].name, row.penalty.alpha,
                    base::format_number(at.duration), base::format_number(period))});
  }
  const char* what = not_finite(row.update);
  if (what == nullptr && !all_finite(row)) what = "sum of the energies";
  // The limit along an ellipse is finite beside one infinite coefficient.
  if (what == nullptr && !std::isfinite(row.penalty.mu[0] + row.penalty.mu[1])) {
    what = "coefficient";
  }
  if (what != nullptr) {
    if (auto exponent = overflow(in_force, row)) {
      return tl::unexpected(numerical_failure(at, definition, *exponent));
    }
    return tl::unexpected(
        numerical_failure(at, definition, fmt::format("the {} is not finite", what)));
  }
  if (!row.update.converged) {
    return tl::unexpected(numerical_failure(
        at, definition,
        exact_ ? "stick, slip and lift-off change too often within the increment for "
                 "exact integration; use backward_euler"
               : "the return to the limit surface of its potential found no solution"));
  }
  if (row.update.snap_back >= 1.0 && case_->integration.snap_back == cases::SnapBackAction::kStop) {
    return tl::unexpected(snap_back_failure(at, definition));
  }
  return {};
}

SimulationFailure Simulation::snap_back_failure(const Row& at, std::size_t definition) const {
  const law::FrictionDefinition& in_force = definitions_[definition];
  const double beta = at.definitions[definition].update.snap_back;
  const std::string unit = base::unit_text(
      law::is_rotational(in_force.slip) ? base::kMoment : base::Dimension{.force = 1, .length = -1},
      case_->units);
  const std::string enough = fmt::format("{:.6g}", beta * in_force.stick.value);
  return numerical_failure(
      at, definition,
      fmt::format(
          "the force would jump at constant motion (snap-back): its wear falls faster than "
          "the stick stiffness can follow, mu |F'| / {} = {} in this increment where it must "
          "stay below 1; a stick.stiffness above {} follows it here, so does a flatter "
          "table; 'integration: {{snap_back: jump}}' goes on behind the jump and books the "
          "energy lost in it",
          std::holds_alternative<law::Potential>(in_force.criterion) ? "(|m|^2 k)" : "k",
          fmt::format("{:.6g}", beta), unit.empty() ? enough : enough + " " + unit));
}

/// Behind the update, and only for the laws concerned: the others cost nothing more.
void Simulation::note_raw_coefficients() {
  if (with_floor_.empty()) return;
  const law::Ambient end = ambient_of(row_.quantities, case_->reference);
  for (const std::size_t i : with_floor_) {
    DefinitionRow& row = row_.definitions[i];
    const double normal_force = row.update.normal_force;
    const law::FrictionDefinition& definition = definitions_[i];
    row.clamped = false;
    const auto note = [&](const law::FrictionLaw& law, double speed, double& raw) {
      const law::SlipArguments slip{.slip_rate = speed, .contact_force = normal_force};
      raw = law::raw_coefficient(law, end, slip);
      row.clamped = row.clamped || law::is_clamped(law, end, slip);
    };
    if (definition.formulation && definition.formulation->orthotropy) {
      note(definition.law, row.penalty.speeds[0], row.raw_mu[0]);
      note(definition.formulation->orthotropy->second, row.penalty.speeds[1], row.raw_mu[1]);
    } else {
      note(definition.law, row.update.slip_rate, row.raw_mu[0]);
    }
  }
}

law::FrictionUpdate Simulation::integrate(std::size_t definition,
                                          const law::ConnectorIncrement& increment,
                                          const law::FrictionState& old) {
  if (definitions_[definition].formulation) {
    return law::update_penalty(definitions_[definition], increment, old,
                               &row_.definitions[definition].penalty);
  }
  if (case_->belt && case_->belt->both_tensions) {
    return law::judge_capstan(definitions_[definition], increment,
                              row_.quantities[cases::kTensionBehind]);
  }
  return law::update(definitions_[definition], increment, old);
}

law::FrictionUpdate Simulation::integrate_with_options(std::size_t definition,
                                                       law::ConnectorIncrement increment,
                                                       const law::FrictionState& old) {
  const cases::CaseDefinition& own = case_->definitions[definition];
  if (!own.dead_zone && !own.backward) return integrate(definition, increment, old);
  law::FrictionDefinition& in_force = definitions_[definition];
  DefinitionRow& here = row_.definitions[definition];
  const int c = in_force.slip.component[0];
  const double motion = increment.end.position[c] - increment.begin_position[c];
  const double elastic = elastic_extension(in_force, old);
  PlayStep step{.motion = motion};
  if (own.dead_zone) {
    step = move_play(*own.dead_zone, here.play, elastic, motion);
    here.play = step.play;
    here.travel = step.travel;
    // The law sees tables at the end of the increment, and of its begin only how far it is.
    if (step.travel != 0.0) increment.begin_position[c] = increment.end.position[c] - step.motion;
  }
  if (own.backward) {
    const bool backward = loads_backward(elastic, step.motion, motion);
    if (backward != here.backward) std::swap(in_force.law, other_law_[definition]);
    here.backward = backward;
  }
  law::FrictionUpdate update = integrate(definition, increment, old);
  if (own.backward) {
    split_at_zero_force(in_force, old, in_force.slip.scale[0] * step.motion, update);
  }
  if (step.travel != 0.0) {
    if (elastic + step.motion == 0.0) relax(update);
    place_onset(step, update);
  }
  return update;
}

std::string Simulation::place(const Row& row, double before) const {
  const std::string step =
      measured_ ? fmt::format("row {} of the measured history", row.index + 1)
                : fmt::format("step '{}', t = {}",
                              case_->steps.empty()
                                  ? std::string()
                                  : case_->steps[static_cast<std::size_t>(row.step)].name,
                              base::format_number(row.step_time - before));
  return fmt::format("{} (total time {})", step, base::format_number(row.time - before));
}

SimulationFailure Simulation::numerical_failure(const Row& row, std::size_t definition,
                                                const std::string& what) const {
  return {SimulationFailure::Kind::kNumerical,
          fmt::format("{}: definition '{}': {}", place(row), case_->definitions[definition].name,
                      what)};
}

}  // namespace slipbench::driver::bench
