// SPDX-License-Identifier: Apache-2.0
#include "driver/results/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "driver/base/units/derived_units.hpp"
#include "driver/results/friction_force.hpp"
#include "driver/results/regime_history.hpp"
#include "law/update/penalty_predictor.hpp"
#include "law/update/penalty_update.hpp"
#include "law/update/uniqueness.hpp"

namespace slipbench::driver::results {
namespace {

/// A part of a whole in percent: whole numbers where they say enough.
std::string percent(double part, double whole) {
  const double value = whole > 0.0 ? 100.0 * part / whole : 0.0;
  return value >= 1.0 || value == 0.0 ? fmt::format("{:.0f} %", value)
                                      : fmt::format("{:.1g} %", value);
}

bool is_viscous(const law::FrictionDefinition& definition) {
  return definition.formulation &&
         std::holds_alternative<law::ViscousPenalty>(definition.formulation->penalty);
}
bool has_directions(const law::FrictionDefinition& definition) {
  return definition.formulation && definition.formulation->orthotropy;
}
/// Returns what to think of the energy balance of a definition with a filter.
std::string_view energy_note(const law::FrictionDefinition& definition) {
  if (!definition.formulation || definition.formulation->filter.kind == law::Filter::Kind::kNone) {
    return "";
  }
  return law::smooths(*definition.formulation)
             ? " with the work of the filtered force"
             : ": as coded the filter drops a part of each increment";
}

const char* plural(std::int64_t count) { return count == 1 ? "" : "s"; }

}  // namespace

double DefinitionSummary::energy_gap() const {
  return largest_energy > 0.0 ? (work - dissipation - lost - stored_energy) / largest_energy : 0.0;
}

Summary::Summary(const cases::Case& problem)
    : case_(&problem),
      detector_(problem),
      cycles_(problem),
      coverage_(problem),
      plausibility_(problem),
      stick_start_(problem.definitions.size()) {
  for (Column& column : result_columns(problem)) {
    if (is_position(column) && column.name.starts_with("CP")) {
      positions_.push_back(std::move(column));
    }
  }
  for (const cases::CaseDefinition& definition : problem.definitions) {
    definitions_.push_back({});
    definitions_.back().name = definition.name;
    stick_slip_.emplace_back(problem, stick_slip_.size());
  }
}

void Summary::add(std::span<const bench::Row> rows) {
  if (rows.front().index == 0) {
    start_time_ = rows.front().time;
    add_start(rows.front());
  }
  increments_ = rows.back().index;
  end_time_ = rows.back().time;
  const std::span<const Event> events = detector_.take(rows);
  cycles_.add(rows);
  if (case_->belt) {
    for (const bench::Row& row : rows) add_belt(row);
  }
  coverage_.add(rows);
  plausibility_.add(rows);
  for (std::size_t d = 0; d < definitions_.size(); ++d) add(rows, events, d);
}

void Summary::add(std::span<const bench::Row> rows, std::span<const Event> events,
                  std::size_t index) {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const bool formulated = definition.law.formulation.has_value();
  DefinitionSummary& sum = definitions_[index];
  StickSlipCounter& stick_slip = stick_slip_[index];
  auto event = events.begin();
  law::CompensatedSum slip_time = sum.slip_time;
  std::int64_t roots = sum.multiple_roots;
  double lowest = sum.lowest_force;
  double highest = sum.highest_force;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bench::Row& row = rows[k];
    const bench::DefinitionRow& here = row.definitions[index];
    const law::FrictionUpdate& update = here.update;
    double since = 0.0;
    if (event != events.end() && event->row == k) {
      sum.slip_time = slip_time;
      for (; event != events.end() && event->row == k; ++event) {
        if (event->definition == index) since = add_event(*event, row, since);
      }
      slip_time = sum.slip_time;
    }
    if (update.state.regime == law::Regime::kSlip) {
      slip_time += (1.0 - since) * row.duration;
    } else if (update.state.regime == law::Regime::kOpen) {
      sum.open_time += (1.0 - since) * row.duration;
    }
    const double force = representative_force(definition, here);
    lowest = std::min(lowest, force);
    highest = std::max(highest, force);
    stick_slip.add(row, formulated ? limited_force(definition, here) : force);
    roots += update.multiple_roots ? 1 : 0;
    if (formulated || here.clamped) add_formulation(row, index);
    if (here.thresholds.unique > 0.0 || here.thresholds.smooth > 0.0) add_thresholds(row, index);
  }
  sum.slip_time = slip_time;
  sum.multiple_roots = roots;
  sum.lowest_force = lowest;
  sum.highest_force = highest;
  add_creep(rows, index);
  const bench::DefinitionRow& last = rows.back().definitions[index];
  sum.stick_slip = stick_slip.cycles();
  sum.accumulated_slip = last.update.state.accumulated_slip;
  sum.dissipation = last.dissipation;
  sum.stored_energy = last.update.stored_energy;
  sum.work = last.work;
  sum.lost = last.lost;
  sum.jumps = last.jumps;
  sum.largest_energy = plausibility_.definitions()[index].largest_energy;
}

void Summary::add_thresholds(const bench::Row& row, std::size_t index) {
  DefinitionSummary& sum = definitions_[index];
  const law::IncrementThresholds& thresholds = row.definitions[index].thresholds;
  sum.unique = std::max(sum.unique, thresholds.unique);
  if (!(thresholds.smooth > row.duration)) return;
  ++sum.short_increments;
  // thresholds.smooth / duration is the largest so far, by more than its rounding.
  constexpr double kMore = 1.0 + 1e-9;
  if (sum.worst_duration == 0.0 ||
      thresholds.smooth * sum.worst_duration > kMore * sum.worst.smooth * row.duration) {
    sum.worst = thresholds;
    sum.worst_time = row.time;
    sum.worst_duration = row.duration;
  }
}

void Summary::add_belt(const bench::Row& row) {
  const double distance = row.quantities[cases::kFirstMotion];
  if (case_->belt->has_length && (!shortest_ || distance < shortest_->value)) {
    shortest_ = {distance, row.time};
  }
  const double tension = row.quantities[cases::kFirstForce];
  if (case_->kinetic.elasticity[0] || !(tension < 0.0)) return;
  if (row.index > 0) ++slack_;
  if (tension < most_slack_.value) most_slack_ = {tension, row.time};
}

std::vector<std::string> Summary::belt_warnings() const {
  std::vector<std::string> all;
  const base::UnitSystem& units = case_->units;
  if (slack_ > 0) {
    all.push_back(fmt::format(
        "the tension f1 is below 0 in {} of {} increments, down to {} at t = {}: a belt pulls, it "
        "does not push; it is slack there, and CTF1, CSF2 and f_bc are 0",
        slack_, increments_,
        base::with_unit(base::rounded(most_slack_.value), base::unit_text(base::kForce, units)),
        base::rounded(most_slack_.time)));
  }
  const double locks = law::kShortestPart * case_->initial[0];
  if (shortest_ && shortest_->value < 2.0 * locks) {
    const std::string unit = base::unit_text(base::kLength, units);
    all.push_back(
        fmt::format("the distance CP1 came down to {} at t = {}, near {}, a hundredth of the "
                    "initial one, where "
                    "a belt locks",
                    base::with_unit(base::rounded(shortest_->value), unit),
                    base::rounded(shortest_->time), base::with_unit(base::rounded(locks), unit)));
  }
  return all;
}

void Summary::add_formulation(const bench::Row& row, std::size_t index) {
  const bench::DefinitionRow& here = row.definitions[index];
  DefinitionSummary& sum = definitions_[index];
  if (here.clamped && row.index > 0) {
    ++sum.clamped;
    const law::FrictionDefinition& of = case_->definitions[index].law;
    const bool two = has_directions(of);
    for (std::size_t i = 0; i < (two ? 2 : 1); ++i) {
      // The 0 of a law without a floor is what its user wants.
      const bool zero_is_meant = i == 1 && !law::has_floor(of.formulation->orthotropy->second);
      if (here.raw_mu[i] >= (zero_is_meant ? 0.0 : law::kCoefficientFloor)) continue;
      FloorCount& floor = sum.floor[i];
      ++floor.increments;
      if ((two ? here.penalty.mu[i] : here.update.mu) > law::kCoefficientFloor) ++floor.blended;
      floor.lowest = std::min(floor.lowest, here.raw_mu[i]);
    }
  }
  const law::FrictionDefinition& definition = case_->definitions[index].law;
  if (!definition.formulation || row.index == 0) return;
  const law::Filter& filter = definition.formulation->filter;
  if (filter.kind == law::Filter::Kind::kFrequency) {
    const double alpha = 2.0 * std::numbers::pi * filter.value * row.duration;
    if (alpha > 1.0) {
      const bool documented = definition.formulation->convention == law::Convention::kDocumented;
      ++(documented ? sum.alpha_limited : sum.alpha_overshoots);
      sum.largest_alpha = std::max(sum.largest_alpha, alpha);
    }
  }
  // The rounding of a force that was put on its limit is no overshoot.
  constexpr double kMore = 1.0 + 1e-9;
  const double use = law::limit_use(definition, here.update, here.penalty);
  if (use > kMore * sum.largest_use) {
    sum.largest_use = use;
    sum.largest_use_time = row.time;
  }
}

/// A mass that moves against its belt slips from the start: no event begins that slip.
void Summary::add_start(const bench::Row& row) {
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const bench::DefinitionRow& here = row.definitions[d];
    const law::FrictionUpdate& update = here.update;
    if (update.state.regime != law::Regime::kSlip) continue;
    const Event start{row.time,
                      1.0,
                      d,
                      law::Regime::kSlip,
                      law::Regime::kSlip,
                      false,
                      limited_force(case_->definitions[d], here),
                      update.limit,
                      update.state.accumulated_slip};
    note_first_slip(start, row);
  }
}

void Summary::note_first_slip(const Event& event, const bench::Row& row) {
  DefinitionSummary& sum = definitions_[event.definition];
  if (sum.first_slip) return;
  sum.first_slip = event;
  for (const Column& position : positions_) {
    sum.first_place.push_back(position_at(event, row, position.index) - position.offset);
  }
}

double Summary::add_event(const Event& event, const bench::Row& row, double since) {
  DefinitionSummary& sum = definitions_[event.definition];
  if (event.jump) {
    if (!sum.first_jump) sum.first_jump = event.time;
    return since;
  }
  stick_slip_[event.definition].add(event, row);
  // Slip that turns to the opposite sense has stuck on the way, but where the turn was located.
  const bool located = row.definitions[event.definition].changes.count > 0;
  if (event.from == law::Regime::kSlip && (located || event.to != law::Regime::kSlip)) {
    sum.slip_time += (event.fraction - since) * row.duration;
  }
  if (event.from == law::Regime::kOpen) sum.open_time += (event.fraction - since) * row.duration;
  if (event.reversal) ++sum.reversals;
  if (event.to == law::Regime::kSlip && event.from != law::Regime::kSlip) {
    ++sum.events;
    note_first_slip(event, row);
  }
  return event.fraction;
}

void Summary::add_creep(std::span<const bench::Row> rows, std::size_t index) {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const bool viscous = is_viscous(definition.law);
  const auto dimension = static_cast<std::size_t>(definition.law.slip.dimension);
  DefinitionSummary& sum = definitions_[index];
  const law::FrictionState* start = &stick_start_[index];  // but for its regime
  law::Regime before = start->regime;
  double length = 0.0;  // squares of the largest so far
  double creep = 0.0;
  for (const bench::Row& row : rows) {
    const law::FrictionUpdate& update = row.definitions[index].update;
    const law::FrictionState& now = update.state;
    const bool sticks = now.regime == law::Regime::kStick;
    if (sticks || (now.regime == law::Regime::kSlip && update.onset > 0.0)) {
      double stretch = 0.0;
      double way = 0.0;
      double across = 0.0;  // negative where slip turned to the opposite sense: it stuck on the way
      for (std::size_t k = 0; k < dimension; ++k) {
        const double moved = now.elastic_slip[k] - start->elastic_slip[k];
        stretch += now.elastic_slip[k] * now.elastic_slip[k];
        way += moved * moved;
        across += now.elastic_slip[k] * start->elastic_slip[k];
      }
      if (sticks) length = std::max(length, stretch);
      // The stick before a slip lasts up to the limit, where the elastic slip then stays.
      if (sticks || before == law::Regime::kStick || across < 0.0) creep = std::max(creep, way);
    }
    // Below its limit a viscous penalty creeps with all of the motion, and stores nothing.
    if (viscous && sticks) {
      sum.largest_creep =
          std::max(sum.largest_creep, now.accumulated_slip - start->accumulated_slip);
    }
    if (!sticks) start = &now;
    before = now.regime;
  }
  // The root of the largest square is the largest root: it is rounded monotonically.
  sum.largest_elastic_slip = std::max(sum.largest_elastic_slip, std::sqrt(length));
  sum.largest_creep = std::max(sum.largest_creep, std::sqrt(creep));
  if (start != &stick_start_[index]) stick_start_[index] = *start;
  stick_start_[index].regime = before;
}

/// Returns why there was no friction all along: only a contact force of 0 is no contact.
std::string Summary::open_text(std::size_t index) const {
  const DefinitionExtremes& all = plausibility_.definitions()[index];
  if (!all.open_under_force) return "never in contact";
  const bool rotational = is_rotational(case_->definitions[index].law);
  return fmt::format(
      "no friction all along: its {} 0 (pressed by up to {})",
      all.highest_mu > 0.0 ? "limit is" : "coefficient is",
      base::with_unit(base::rounded(all.highest_normal_force),
                      base::unit_text(rotational ? base::kMoment : base::kForce, case_->units)));
}

std::string Summary::definition_text(const DefinitionSummary& sum, std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const base::UnitSystem& units = case_->units;
  const bool rotational = is_rotational(definition.law);
  const std::string force = base::unit_text(rotational ? base::kMoment : base::kForce, units);
  const std::string name = definitions_.size() > 1 ? definition.name + ": " : "";
  const double duration = end_time_ - start_time_;
  std::string text = "  " + name;
  if (!sum.first_slip) {
    const bool all_along = duration > 0.0 && !lasts(duration - sum.open_time, duration);
    text += all_along ? open_text(index) : "never slips";
  } else {
    const Event& first = *sum.first_slip;
    std::string reversals;
    if (sum.reversals > 0) {
      reversals = fmt::format(" and {} reversal{}", sum.reversals, plural(sum.reversals));
    }
    text += fmt::format("slips {} of the time, {} stick-slip event{}{}, first slip at t = {}",
                        percent(sum.slip_time, duration), sum.events, plural(sum.events), reversals,
                        base::with_unit(base::rounded(first.time), units.time));
    std::string where;
    for (std::size_t p = 0; p < positions_.size(); ++p) {
      where += fmt::format("{}{} = {}", where.empty() ? "" : ", ", positions_[p].name,
                           base::with_unit(base::rounded(sum.first_place[p]),
                                           base::unit_text(positions_[p].dimension, units)));
    }
    text += fmt::format(" ({}) at {}", where,
                        base::with_unit(base::rounded(std::abs(first.force)), force));
  }
  if (sum.first_slip && lasts(sum.open_time, duration)) {
    text += fmt::format(
        ", {} {} of the time",
        plausibility_.definitions()[index].open_under_force ? "with a limit of 0 for" : "open",
        percent(sum.open_time, duration));
  }
  text += fmt::format(
      "\n  {}friction {} {} .. {}, dissipated {}, stored {}, energy balance {}\n", name,
      rotational ? "moment" : "force", base::rounded(sum.lowest_force),
      base::with_unit(base::rounded(sum.highest_force), force),
      base::energy_text(sum.dissipation, units), base::energy_text(sum.stored_energy, units),
      fmt::format("{:.1g}{}", std::abs(sum.energy_gap()), energy_note(definition.law)));
  if (sum.jumps > 0) {
    text += fmt::format("  {}{} were lost in {} jump{} (snap-back), the first at t = {}\n", name,
                        base::energy_text(sum.lost, units), sum.jumps, plural(sum.jumps),
                        base::with_unit(base::rounded(*sum.first_jump), units.time));
  }
  return text + stick_slip_text(sum, index) + why_text(sum, index);
}

std::string Summary::stick_slip_text(const DefinitionSummary& sum, std::size_t index) const {
  // One cycle may be any motion that stops once.
  constexpr std::int64_t kFewest = 2;
  const StickSlip& all = sum.stick_slip;
  if (all.cycles < kFewest) return {};
  const base::UnitSystem& units = case_->units;
  const bool rotational = is_rotational(case_->definitions[index].law);
  // A steady vibration has one period, apart from where its rows lie.
  constexpr double kSteady = 0.01;
  const double mean = all.time / static_cast<double>(all.cycles);
  const std::string period =
      all.period.highest - all.period.lowest <= kSteady * mean
          ? base::rounded(mean)
          : base::rounded(all.period.lowest, 3) + " .. " + base::rounded(all.period.highest, 3);
  const std::string over = fmt::format(
      "(period {} over {} cycles, t = {} .. {})", base::with_unit(period, units.time), all.cycles,
      base::rounded(all.first), base::with_unit(base::rounded(all.last), units.time));
  std::string text = definitions_.size() > 1 ? "  " + sum.name + ": " : "  ";
  // Of bursts a mean frequency says nothing.
  if (all.period.highest > 2.0 * all.period.lowest) {
    text += "irregular stick-slip " + over;
  } else {
    const std::string hertz = base::frequency_name(units);
    const std::string frequency = base::rounded(all.frequency());
    text += fmt::format(
        "stick-slip at {} {}",
        hertz.empty() ? frequency + " cycles a unit of time" : base::with_unit(frequency, hertz),
        over);
  }
  if (all.place.highest > all.place.lowest) {
    text += ", amplitude " +
            base::with_unit(base::rounded(0.5 * (all.place.highest - all.place.lowest), 3),
                            base::unit_text(rotational ? base::kAngle : base::kLength, units));
  }
  return text + fmt::format(", {} {} .. {}, slips {} of a cycle\n", rotational ? "moment" : "force",
                            base::rounded(all.force.lowest),
                            base::with_unit(
                                base::rounded(all.force.highest),
                                base::unit_text(rotational ? base::kMoment : base::kForce, units)),
                            percent(all.slip_time, all.time));
}

std::string Summary::why_text(const DefinitionSummary& sum, std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const std::string name = definitions_.size() > 1 ? definition.name + ": " : "";
  const std::string slip =
      base::unit_text(is_rotational(definition.law) ? base::kAngle : base::kLength, case_->units);
  std::string text;
  if (sum.largest_creep > 0.0) {
    const std::string length = base::with_unit(base::rounded(sum.largest_creep, 3), slip);
    text = is_viscous(definition.law) ? "creeps up to " + length + " below its limit"
                                      : "elastic displacement while sticking up to " + length;
  }
  const CycleEnergy& cycle = cycles_.energies()[index];
  if (cycle.count > 0 && cycle.highest > 0.0) {
    text +=
        fmt::format("{}dissipates {} in the last of {} cycle{}", text.empty() ? "" : ", ",
                    base::energy_text(cycle.last, case_->units), cycle.count, plural(cycle.count));
  }
  const auto& formulation = definition.law.formulation;
  if (formulation && law::smooths(*formulation) && sum.largest_use > 1.0 + 1e-9) {
    const std::string time =
        base::with_unit(base::rounded(sum.largest_use_time), case_->units.time);
    text += text.empty() ? "" : ", ";
    text += sum.largest_use < kUseWithoutLimit
                ? fmt::format("force up to {} of its limit at t = {} (overshoot by the filter)",
                              base::rounded(sum.largest_use), time)
                : fmt::format("force behind the filter where {} limit is 0, at t = {}",
                              formulation->orthotropy ? "a direction's" : "the", time);
  }
  return text.empty() ? text : "  " + name + text + "\n";
}

std::string Summary::text() const {
  std::string text;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    text += definition_text(definitions_[d], d);
  }
  if (definitions_.empty()) text = "  no friction\n";
  return text + coverage_.text();
}

std::string Summary::falling_warning(const DefinitionSummary& sum, std::size_t index) const {
  const base::UnitSystem& units = case_->units;
  const auto time = [&](double value) {
    return base::with_unit(fmt::format("{:.6g}", value), units.time);
  };
  // A definition that never slips has no falling coefficient to follow.
  const bool jumps = sum.short_increments > 0 && sum.first_slip;
  // With a coefficient that does not fall the roots are those of wear, and the first of them is
  // where the force arrives.
  if (!jumps && (sum.multiple_roots == 0 || sum.unique == 0.0)) return {};
  if (!jumps) {
    std::string text = fmt::format(
        "friction '{}': {} increment{} may have more than one solution, because the coefficient "
        "falls with the slip rate faster than the stick stiffness follows; the one of least slip "
        "was taken",
        sum.name, sum.multiple_roots, plural(sum.multiple_roots));
    return text +
           fmt::format("; with increments longer than {} there is one only", time(sum.unique));
  }
  const std::string force = base::unit_text(
      is_rotational(case_->definitions[index].law) ? base::kMoment : base::kForce, units);
  std::string text = fmt::format(
      "friction '{}': {} of {} increments are shorter than 2 F_N |dmu/dv| / k, at worst {} against "
      "{} (t = {}, F_N = {}): there backward Euler may not settle on F_N mu(v) but jumps between "
      "the static and the kinetic limit",
      sum.name, sum.short_increments, increments_, time(sum.worst_duration), time(sum.worst.smooth),
      base::rounded(sum.worst_time), base::with_unit(base::rounded(sum.worst.normal_force), force));
  if (sum.multiple_roots > 0) {
    text += fmt::format(
        "; below F_N max|dmu/dv| / k = {} an increment may have more than one solution ({} had, "
        "the one of least slip was taken)",
        time(sum.unique), sum.multiple_roots);
  }
  return text +
         "; take longer increments, 'slip_rate: relative_motion', a smaller decay, a larger stick "
         "stiffness, or an 'elastic_slip' in its place";
}

std::vector<std::string> Summary::formulation_warnings(const DefinitionSummary& sum,
                                                       std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  std::vector<std::string> all;
  const std::string whose = fmt::format("friction '{}': ", sum.name);
  const bool two = has_directions(definition.law);
  for (std::size_t i = 0; i < sum.floor.size(); ++i) {
    const FloorCount& floor = sum.floor[i];
    if (floor.increments == 0) continue;
    std::string text = fmt::format(
        "{}the coefficient{} is not above 0 in {} of {} increments{}, and kept at 1e-30 there",
        whose, two ? fmt::format(" of direction {}", i + 1) : "", floor.increments, increments_,
        floor.lowest < 0.0 ? ", down to " + base::rounded(floor.lowest) : "");
    if (floor.blended < floor.increments) text += two ? ": no friction along it" : ": no friction";
    if (floor.blended > 0) {
      text += fmt::format("{}{} of them blend it with another coefficient",
                          floor.blended < floor.increments ? ", but " : ": ", floor.blended);
    }
    all.push_back(text +
                  "; its constants do not fit the pressures and speeds of this history (column" +
                  (two ? " CLAMPED)" : "s MU_RAW and CLAMPED)"));
  }
  if (sum.alpha_limited > 0) {
    all.push_back(fmt::format(
        "{}alpha of its filter is limited to 1 in {} of {} increments (2 pi f dt up to {}): these "
        "are not smoothed; take shorter increments or a lower frequency",
        whose, sum.alpha_limited, increments_, base::rounded(sum.largest_alpha)));
  }
  if (sum.alpha_overshoots > 0) {
    const std::string effect =
        law::smooths(*definition.law.formulation)
            ? std::string("the force overshoots") +
                  (sum.largest_alpha >= 2.0 ? ", and diverges where alpha is 2 or more" : "")
            : std::string("the spring is stiffer than K_t by that factor; nothing is smoothed");
    all.push_back(fmt::format(
        "{}as coded, alpha of its filter is above 1 in {} of {} increments, up to {}: {}", whose,
        sum.alpha_overshoots, increments_, base::rounded(sum.largest_alpha), effect));
  }
  return all;
}

std::vector<std::string> Summary::warnings(std::span<const bench::MotionJump> jumps) const {
  std::vector<std::string> all = plausibility_.findings();
  for (std::string& one : belt_warnings()) all.push_back(std::move(one));
  const base::UnitSystem& units = case_->units;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    std::string warning = falling_warning(definitions_[d], d);
    if (!warning.empty()) all.push_back(std::move(warning));
    for (std::string& one : formulation_warnings(definitions_[d], d)) all.push_back(std::move(one));
  }
  for (const bench::MotionJump& jump : jumps) {
    const std::string unit =
        base::unit_text(jump.component >= 3 ? base::kAngle : base::kLength, units);
    all.push_back(fmt::format(
        "{} jumps by {} at the start of step '{}' (t = {}): the jump is made in the first "
        "increment{}",
        cases::motion_name(jump.component), base::with_unit(base::rounded(jump.size), unit),
        jump.step, base::rounded(jump.time),
        jump.time == 0.0 ? "; 'initial:' gives the position before it" : ""));
  }
  return all;
}

}  // namespace slipbench::driver::results
