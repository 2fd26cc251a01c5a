// SPDX-License-Identifier: Apache-2.0
// Increments of a simulation that go together: first their history, a quantity at a time, then the
// law, a definition at a time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/bench/connector_increment.hpp"
#include "driver/bench/simulation.hpp"
#include "law/update/known_update.hpp"

namespace slipbench::driver::bench {
namespace {

void copy_begin(const Row& before, Row& row) {
  // By way of a local: where both may be one row, a copy would be a call.
  law::RelativePosition begin;
  std::copy_n(before.quantities.begin() + cases::kFirstMotion, law::kComponents,
              begin.values.begin());
  row.begin = begin;
}

/// Brings the sums of a definition over the run to the end of its increment.
void add_up(const DefinitionRow& before, DefinitionRow& here) {
  here.dissipation = before.dissipation;
  here.work = before.work;
  here.lost = before.lost;
  here.jumps = before.jumps;
  add_increment(here.update, here);
}

/// Returns how many rows have finite sums of energies; a sum that is not finite stays so.
std::size_t finite_rows(std::span<const Row> rows, std::size_t definition) {
  const auto is_finite = [&](const Row& row) { return all_finite(row.definitions[definition]); };
  if (rows.empty() || is_finite(rows.back())) return rows.size();
  return static_cast<std::size_t>(std::find_if_not(rows.begin(), rows.end(), is_finite) -
                                  rows.begin());
}

/// Tells whether the table of a term, or the place of the connector, has a part in F_C.
bool depends_on_ambient(const law::ContactForce& contact) {
  if (const auto* terms = std::get_if<law::DerivedComponent>(&contact)) {
    return std::any_of(terms->begin(), terms->end(),
                       [](const law::DerivedTerm& term) { return term.weight_table.has_value(); });
  }
  return std::holds_alternative<law::UniversalJointContact>(contact);
}

}  // namespace

bool Simulation::is_plain() const {
  if (case_->belt || dynamics_ || equilibrium_ || exact_ || has_options_ || has_forces_) {
    return false;
  }
  const auto changes = [](const cases::Step& step) { return !step.friction_changes.empty(); };
  const auto formulated = [](const law::FrictionDefinition& definition) {
    return definition.formulation.has_value();
  };
  return case_->kinetic.pressing.empty() && with_floor_.empty() && case_->measured_pieces == 1 &&
         std::none_of(case_->steps.begin(), case_->steps.end(), changes) &&
         std::none_of(definitions_.begin(), definitions_.end(), formulated);
}

std::size_t Simulation::walk_grid(std::span<Row> rows, const Row& before) {
  const cases::Step& step = case_->steps[static_cast<std::size_t>(before.step)];
  const std::int64_t first = before.index + 1;
  history::StepGrid grid = grid_;
  double from = grid.time();
  copy_begin(before, rows[0]);
  std::size_t count = 0;
  // The next breakpoint is only known when all profiles have come to the one before.
  while (count < rows.size() && !grid.at_end() &&
         (count == 0 || from + history::kSameTime * step.duration < breakpoint_)) {
    Row& row = rows[count];
    const double to = grid.advance(breakpoint_);
    times_[count] = to;
    row.index = first + static_cast<std::int64_t>(count++);
    row.step_time = to;
    row.time = pass_start_ + to;
    row.duration = to - from;
    from = to;
  }
  grid_ = grid;
  std::size_t sound = count;
  for (const std::size_t i : varying_) {
    // A step drives its motions first. Those that a load makes are not known yet.
    if (!following_.empty()) {
      cursors_[i].set_position(std::span(rows[0].quantities).first<history::kPositions>());
    }
    cursors_[i].values(std::span(times_).first(count), std::span(values_).first(count));
    const auto quantity = static_cast<std::size_t>(step.drives[i].quantity);
    double extent = 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double value = values_[k];
      rows[k].quantities[quantity] = value;
      extent = std::max(extent, std::abs(value));
      sum += value;
    }
    // One infinity or NaN spoils the sum.
    for (std::size_t k = 0; !std::isfinite(sum) && k < sound; ++k) {
      if (!std::isfinite(values_[k])) sound = k;
    }
    if (quantity < extent_.size()) extent_[quantity] = std::max(extent_[quantity], extent);
  }
  for (std::size_t k = 1; k < count; ++k) copy_begin(rows[k - 1], rows[k]);
  if (sound < count) failed_ = history_failure(rows[sound]);
  return sound;
}

SimulationFailure Simulation::history_failure(const Row& row) const {
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row.step)];
  SimulationFailure fault{SimulationFailure::Kind::kInput, {}};
  for (const std::size_t i : varying_) {
    const int quantity = step.drives[i].quantity;
    if (std::isfinite(row.quantities[static_cast<std::size_t>(quantity)])) continue;
    const auto& error = cursors_[i].error();
    if (error) fault = to_failure(*error);
    fault.message = fmt::format("step '{}', t = {}, {}: {}", step.name,
                                base::format_number(row.step_time), cases::quantity_name(quantity),
                                error ? fault.message : "is not a finite number");
    break;
  }
  return fault;
}

std::size_t Simulation::walk_measured(std::span<Row> rows) {
  const Row* before = &row_;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto read = measured_->advance();
    if (!read) failed_ = to_failure(read.error());
    if (!read || !*read) return k;
    take_measured_row(*before, rows[k]);
    rows[k].index = before->index + 1;
    before = &rows[k];
  }
  return rows.size();
}

bool Simulation::limit_is_constant(std::size_t definition) const {
  const law::FrictionDefinition& law = definitions_[definition];
  if (measured_ || !std::holds_alternative<law::ConstantCoefficient>(law.law) ||
      !std::holds_alternative<double>(law.internal_contact_force) ||
      depends_on_ambient(law.contact_force)) {
    return false;
  }
  const cases::Step& step = case_->steps[static_cast<std::size_t>(row_.step)];
  return std::none_of(varying_.begin(), varying_.end(), [&](std::size_t i) {
    const int quantity = step.drives[i].quantity;
    return quantity >= cases::kFirstForce && quantity < cases::kFirstForce + law::kComponents;
  });
}

/// Updates a definition whose limits are known over some rows. Returns the first row that cannot be
/// used, or how many there are. `kConstant`: its limit is the same in all rows.
template <int D, bool kConstant>
std::size_t Simulation::update_known_rows(std::span<Row> rows, std::size_t definition) {
  const law::FrictionDefinition& law = definitions_[definition];
  law::ConnectorIncrement increment = connector_increment(*case_, rows[0]);
  const DefinitionRow* before = &row_.definitions[definition];
  law::KnownLimits limits(law);
  law::Limit rest;
  if (kConstant) rest = limits(increment, before->update.state, 0.0)(0.0);
  const law::Limit all_along = rest;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Row& row = rows[k];
    DefinitionRow& here = row.definitions[definition];
    const law::FrictionState& old = before->update.state;
    if constexpr (kConstant) {
      increment.duration = row.duration;
      for (int i = 0; i < D; ++i) {
        const int c = law.slip.component[static_cast<std::size_t>(i)];
        increment.begin_position[c] = row.begin[c];
        const int motion = cases::kFirstMotion + c;
        increment.end.position[c] = row.quantities[static_cast<std::size_t>(motion)];
      }
    } else {
      increment = connector_increment(*case_, row);
    }
    const auto limit_of = [&](double motion) {
      if constexpr (kConstant) return law::KnownLimit(all_along, law, row.duration, motion);
      return limits(increment, old, motion);
    };
    law::update_known<D>(law, increment, old, limit_of, &here.update);
    add_up(*before, here);
    if (!law::all_finite(here.update) && !judge(row, definition)) return k;
    before = &here;
  }
  return rows.size();
}

template <int D>
std::size_t Simulation::update_known_rows(std::span<Row> rows, std::size_t definition) {
  return limit_is_constant(definition) ? update_known_rows<D, true>(rows, definition)
                                       : update_known_rows<D, false>(rows, definition);
}

std::size_t Simulation::update_rows_one_by_one(std::span<Row> rows, std::size_t definition) {
  const DefinitionRow* before = &row_.definitions[definition];
  for (std::size_t k = 0; k < rows.size(); ++k) {
    DefinitionRow& here = rows[k].definitions[definition];
    // In place: an assignment would build the result elsewhere and copy its 400 bytes.
    ::new (&here.update) law::FrictionUpdate(law::update(
        definitions_[definition], connector_increment(*case_, rows[k]), before->update.state));
    add_up(*before, here);
    if (!judge(rows[k], definition)) return k;
    before = &here;
  }
  return rows.size();
}

tl::expected<std::span<const Row>, SimulationFailure> Simulation::advance_rows() {
  if (failed_) return tl::unexpected(*failed_);
  if (rows_.empty()) {
    rows_.assign(kMostRows, row_);
    rows_pass_.assign(kMostRows, -1);
  }
  const bool more_of_pass = measured_ || (in_step_ && !grid_.at_end());
  const bool together = plain_ && more_of_pass && following_.empty();
  const std::size_t count = together ? advance_together() : advance_one_by_one();
  if (count == 0 && failed_) return tl::unexpected(*failed_);
  return std::span<const Row>(rows_.data(), count);
}

std::size_t Simulation::advance_one_by_one() {
  std::size_t count = 0;
  // A plain case takes the first increment of a pass so.
  const std::size_t most = plain_ ? 1 : kMostRows;
  while (count < most) {
    const auto advanced = advance();
    if (!advanced) failed_ = advanced.error();
    if (!advanced || !*advanced) break;
    rows_pass_[count] = -1;
    rows_[count++] = row_;
  }
  return count;
}

std::size_t Simulation::advance_together() {
  for (std::size_t k = 0; k < kMostRows && rows_pass_[k] != passes_; ++k) {
    rows_[k].quantities = row_.quantities;
    rows_[k].step = row_.step;
    rows_[k].pass = row_.pass;
    rows_pass_[k] = passes_;
  }
  if (!measured_) pass_breakpoint();
  std::size_t count = measured_ ? walk_measured(rows_) : walk_grid(rows_, row_);
  for (std::size_t i = 0; i < definitions_.size(); ++i) {
    const std::span<Row> rows(rows_.data(), count);
    if (rows.empty()) break;
    const bool known = std::holds_alternative<law::EuclideanPotential>(definitions_[i].criterion) &&
                       law::has_known_limit(definitions_[i]);
    const int dimension = known ? definitions_[i].slip.dimension : 0;
    std::size_t done = dimension == 1   ? update_known_rows<1>(rows, i)
                       : dimension == 2 ? update_known_rows<2>(rows, i)
                       : dimension == 3 ? update_known_rows<3>(rows, i)
                                        : update_rows_one_by_one(rows, i);
    done = finite_rows(rows.first(done), i);
    if (done == count) continue;
    count = done;
    failed_ = judge(rows_[done], i).error();
    if (!measured_) failed_->step = row_.step;
  }
  if (count == 0) return 0;
  if (!falling_.empty()) {
    for (std::size_t k = 0; k < count; ++k) note_thresholds(rows_[k]);
  }
  row_ = rows_[count - 1];
  return count;
}

}  // namespace slipbench::driver::bench
