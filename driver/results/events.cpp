// SPDX-License-Identifier: Apache-2.0
#include "driver/results/events.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/results/friction_force.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::results {

const char* regime_name(law::Regime regime) {
  if (regime == law::Regime::kOpen) return "open";
  return regime == law::Regime::kStick ? "stick" : "slip";
}

const char* goal_name(const Event& event) { return event.jump ? kJumpWord : regime_name(event.to); }

double position_at(const Event& event, const bench::Row& row, int component) {
  const auto c = static_cast<std::size_t>(component);
  const double begin = row.begin.values[c];
  const double end = row.quantities[cases::kFirstMotion + c];
  return event.fraction == 1.0 ? end : begin + event.fraction * (end - begin);
}

EventDetector::EventDetector(const cases::Case& problem)
    : case_(&problem), memory_(problem.definitions.size()) {
  events_.reserve(problem.definitions.size() * (law::RegimeChanges{}.at.size() + 2));
}

std::span<const Event> EventDetector::take(std::span<const bench::Row> rows) {
  events_.clear();
  for (std::size_t d = 0; d < memory_.size(); ++d) take(rows, d);
  for (Event& event : events_) {
    const double begin = event.row > 0 ? rows[event.row - 1].time : begin_time_;
    const double end = rows[event.row].time;
    event.time = event.fraction == 1.0 ? end : begin + event.fraction * (end - begin);
  }
  begin_time_ = rows.back().time;
  if (events_.size() > 1) {
    std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      return std::tie(a.row, a.fraction) < std::tie(b.row, b.fraction);
    });
  }
  return events_;
}

/// Most increments go on as the one before: these are left behind with few comparisons.
void EventDetector::take(std::span<const bench::Row> rows, std::size_t definition) {
  Memory& memory = memory_[definition];
  const auto dimension =
      static_cast<std::size_t>(case_->definitions[definition].law.slip.dimension);
  const std::array<double, law::kComponents>* last_direction = &memory.slip_direction;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bench::DefinitionRow& here = rows[k].definitions[definition];
    const law::Regime to = here.update.state.regime;
    const bool slips = to == law::Regime::kSlip;
    double along = 0.0;
    for (std::size_t i = 0; slips && i < dimension; ++i) {
      along += (*last_direction)[i] * here.update.direction[i];
    }
    if (to != memory.regime || along < 0.0 || here.changes.count > 0 || here.update.jumps > 0) {
      if (k > 0) remember_force(rows[k - 1], definition);
      memory.slip_direction = *last_direction;
      const std::size_t before = events_.size();
      if (rows[k].index > 0) judge(rows[k], definition);
      if (here.update.jumps > 0) {
        events_.push_back({0.0, here.update.jump_onset, definition, law::Regime::kSlip,
                           law::Regime::kSlip, false,
                           limited_force(case_->definitions[definition], here), here.update.limit,
                           here.update.state.accumulated_slip, true});
      }
      for (std::size_t e = before; e < events_.size(); ++e) events_[e].row = k;
      last_direction = &memory.slip_direction;
    }
    memory.regime = to;
    if (slips) last_direction = &here.update.direction;
  }
  memory.slip_direction = *last_direction;
  remember_force(rows.back(), definition);
}

void EventDetector::remember_force(const bench::Row& row, std::size_t definition) {
  const bench::DefinitionRow& here = row.definitions[definition];
  memory_[definition].force = limited_force(case_->definitions[definition], here);
  memory_[definition].limit = here.update.limit;
}

bool EventDetector::turns(std::size_t definition, const bench::DefinitionRow& here) const {
  double along = 0.0;
  for (std::size_t k = 0; k < here.update.direction.size(); ++k) {
    along += memory_[definition].slip_direction[k] * here.update.direction[k];
  }
  return along < 0.0;
}

void EventDetector::judge(const bench::Row& row, std::size_t definition) {
  const bench::DefinitionRow& here = row.definitions[definition];
  if (here.changes.count > 0) {
    add_located(row, definition);
    return;
  }
  const law::FrictionUpdate& update = here.update;
  const Memory& memory = memory_[definition];
  const law::Regime to = update.state.regime;
  const bool slips = to == law::Regime::kSlip;
  // Exact integration has located what there is: slip that goes on has turned step by step.
  const bool goes_on = case_->integration.method == cases::IntegrationMethod::kExact &&
                       memory.regime == law::Regime::kSlip;
  const bool reversal = slips && !goes_on && turns(definition, here);
  if (memory.regime == to && !reversal) return;
  const double slip_before = update.state.accumulated_slip - update.slip_increment;
  Event event{0.0, 0.0, definition, memory.regime, to, reversal, 0.0, 0.0, slip_before};
  if (memory.regime == law::Regime::kStick &&
      (slips ? update.jumps > 0 : to == law::Regime::kOpen && update.slip_increment > 0.0)) {
    // It slipped at the limit before, until the force jumped or nothing held it any more.
    const bool signed_force = !case_->definitions[definition].coupled &&
                              case_->definitions[definition].law.slip.dimension == 1;
    const double sense = signed_force ? update.direction[0] : 1.0;
    events_.push_back({0.0, update.onset, definition, memory.regime, law::Regime::kSlip,
                       turns(definition, here), std::copysign(memory.limit, sense), memory.limit,
                       slip_before});
    if (slips) return;
    event.from = law::Regime::kSlip;
  }
  if (slips || to == law::Regime::kOpen) {
    event.fraction = slips ? update.onset : 1.0;
    event.force = limited_force(case_->definitions[definition], here);
    event.limit = update.limit;
    if (!slips) event.accumulated_slip = update.state.accumulated_slip;
  } else {
    event.force = memory.force;
    event.limit = memory.limit;
  }
  events_.push_back(event);
}

void EventDetector::add_located(const bench::Row& row, std::size_t definition) {
  const bench::DefinitionRow& here = row.definitions[definition];
  Memory& memory = memory_[definition];
  const bool signed_force = !case_->definitions[definition].coupled &&
                            here.update.state.regime != law::Regime::kOpen &&
                            case_->definitions[definition].law.slip.dimension == 1;
  law::Regime from = memory.regime;
  for (int i = 0; i < here.changes.count; ++i) {
    const law::RegimeChange& change = here.changes.at[static_cast<std::size_t>(i)];
    bool reversal = false;
    if (change.to == law::Regime::kSlip) {
      if (signed_force) {
        // A limit of 0 has a force of -0 or 0.
        const double sense = std::signbit(change.force) ? -1.0 : 1.0;
        reversal = memory.slip_direction[0] * sense < 0.0;
        memory.slip_direction[0] = sense;
      } else {
        reversal = turns(definition, here);
        memory.slip_direction = here.update.direction;
      }
    }
    events_.push_back({0.0, change.fraction, definition, from, change.to, reversal, change.force,
                       change.limit, change.accumulated_slip});
    from = change.to;
  }
  // More changes than were kept: the last of them led to the regime of the end.
  if (from != here.update.state.regime) {
    events_.push_back({0.0, 1.0, definition, from, here.update.state.regime, false,
                       limited_force(case_->definitions[definition], here), here.update.limit,
                       here.update.state.accumulated_slip});
  }
}

EventWriter::EventWriter(const cases::Case& problem, base::OutputFile& file)
    : case_(&problem), detector_(problem), file_(&file) {
  std::string text = base::in_cells(provenance_lines(problem));
  text += "t,definition,from,to,force,limit,accumulated_slip";
  for (Column& column : result_columns(problem)) {
    if (!is_position(column) || !column.name.starts_with("CP")) continue;
    text += "," + column.name;
    positions_.push_back(std::move(column));
  }
  file.append(text + "\n");
}

void EventWriter::write(std::span<const bench::Row> rows) {
  for (const Event& event : detector_.take(rows)) {
    const bench::Row& row = rows[event.row];
    std::string& text = file_->buffer();
    base::append_number(text, event.time);
    text.append(",").append(case_->definitions[event.definition].name).append(",");
    text.append(regime_name(event.from)).append(",").append(goal_name(event));
    for (const double number : {event.force, event.limit, event.accumulated_slip}) {
      text += ',';
      base::append_number(text, number);
    }
    for (const Column& position : positions_) {
      text += ',';
      base::append_number(text, position_at(event, row, position.index) - position.offset);
    }
    text += '\n';
    file_->flush_if_full();
  }
}

}  // namespace slipbench::driver::results
