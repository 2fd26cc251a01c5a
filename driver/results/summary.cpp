// SPDX-License-Identifier: Apache-2.0
#include "driver/results/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "driver/results/csv_writer.hpp"
#include "law/uniqueness.hpp"

namespace slipbench::driver {
namespace {

/// A part of a whole in percent: whole numbers where they say enough.
std::string percent(double part, double whole) {
  const double value = whole > 0.0 ? 100.0 * part / whole : 0.0;
  return value >= 1.0 || value == 0.0 ? fmt::format("{:.0f} %", value)
                                      : fmt::format("{:.1g} %", value);
}

const char* plural(std::int64_t count) { return count == 1 ? "" : "s"; }

}  // namespace

std::string rounded(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  // "105.0" is a measured quantity, "105" could be a count.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::string energy_unit(const UnitSystem& units) {
  const std::string product = unit_text(kMoment, units);
  constexpr std::array<std::array<const char*, 2>, 4> kJoules{
      {{"N mm", "mJ"}, {"N m", "J"}, {"kN mm", "J"}, {"kN m", "kJ"}}};
  for (const auto& [text, joules] : kJoules) {
    if (product == text) return joules;
  }
  return product;
}

double DefinitionSummary::energy_gap() const {
  const double scale = std::max({std::abs(work), std::abs(dissipation), std::abs(stored_energy)});
  return scale > 0.0 ? (work - dissipation - stored_energy) / scale : 0.0;
}

Summary::Summary(const Case& problem)
    : case_(&problem), regimes_(problem.definitions.size(), law::Regime::kStick) {
  for (Column& column : result_columns(problem)) {
    if (column.source == ColumnSource::kPosition && column.name.starts_with("CP")) {
      positions_.push_back(std::move(column));
    }
  }
  for (const CaseDefinition& definition : problem.definitions) {
    definitions_.push_back({});
    definitions_.back().name = definition.name;
  }
}

void Summary::add(const Row& row) {
  if (row.index == 0) start_time_ = row.time;
  increments_ = row.index;
  end_time_ = row.time;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const DefinitionRow& here = row.definitions[d];
    const law::FrictionUpdate& update = here.update;
    DefinitionSummary& sum = definitions_[d];
    const law::Regime before = std::exchange(regimes_[d], update.state.regime);
    if (update.state.regime == law::Regime::kSlip) {
      sum.slip_time += row.duration;
      if (before != law::Regime::kSlip) {
        ++sum.events;
        if (!sum.first_slip) sum.first_slip = row;
      }
    } else if (update.state.regime == law::Regime::kOpen) {
      sum.open_time += row.duration;
    }
    const double force = representative_force(case_->definitions[d], here);
    sum.lowest_force = std::min(sum.lowest_force, force);
    sum.highest_force = std::max(sum.highest_force, force);
    if (update.normal_force > sum.largest_normal_force) {
      sum.largest_normal_force = update.normal_force;
      sum.stiffness_there = law::stick_stiffness(case_->definitions[d].law, update.limit);
    }
    if (update.multiple_roots) {
      sum.shortest_increment =
          sum.multiple_roots == 0 ? row.duration : std::min(sum.shortest_increment, row.duration);
      ++sum.multiple_roots;
    }
    sum.accumulated_slip = update.state.accumulated_slip;
    sum.dissipation = here.dissipation;
    sum.stored_energy = update.stored_energy;
    sum.work = here.work;
  }
}

std::string Summary::definition_text(const DefinitionSummary& sum, std::size_t index) const {
  const CaseDefinition& definition = case_->definitions[index];
  const UnitSystem& units = case_->units;
  const bool rotational = is_rotational(definition.law);
  const std::string force = unit_text(rotational ? kMoment : kForce, units);
  const std::string energy = energy_unit(units);
  const std::string name = definitions_.size() > 1 ? definition.name + ": " : "";
  const double duration = end_time_ - start_time_;
  std::string text = "  " + name;
  if (!sum.first_slip) {
    text += duration > 0.0 && sum.open_time >= duration ? "never in contact" : "never slips";
  } else {
    const Row& first = *sum.first_slip;
    text += fmt::format("slips {} of the time, {} stick-slip event{}, first slip at t = {}",
                        percent(sum.slip_time, duration), sum.events, plural(sum.events),
                        with_unit(rounded(first.time), units.time));
    std::string where;
    for (const Column& position : positions_) {
      where += fmt::format("{}{} = {}", where.empty() ? "" : ", ", position.name,
                           with_unit(rounded(column_value(position, *case_, first)),
                                     unit_text(position.dimension, units)));
    }
    text += fmt::format(
        " ({}) at {}", where,
        with_unit(rounded(std::abs(representative_force(definition, first.definitions[index]))),
                  force));
  }
  if (sum.first_slip && sum.open_time > 0.0) {
    text += fmt::format(", open {} of the time", percent(sum.open_time, duration));
  }
  text += fmt::format("\n  {}friction {} {} .. {}, dissipated {}, stored {}, energy balance {}\n",
                      name, rotational ? "moment" : "force", rounded(sum.lowest_force),
                      with_unit(rounded(sum.highest_force), force),
                      with_unit(rounded(sum.dissipation, 3), energy),
                      with_unit(rounded(sum.stored_energy, 3), energy),
                      fmt::format("{:.1g}", std::abs(sum.energy_gap())));
  return text;
}

std::string Summary::text() const {
  std::string text;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    text += definition_text(definitions_[d], d);
  }
  if (definitions_.empty()) text = "  no friction\n";
  return text;
}

std::vector<std::string> Summary::warnings(std::span<const MotionJump> jumps) const {
  std::vector<std::string> all;
  const UnitSystem& units = case_->units;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const DefinitionSummary& sum = definitions_[d];
    if (sum.multiple_roots == 0) continue;
    const double threshold = law::uniqueness_threshold(
        case_->definitions[d].law.law, sum.largest_normal_force, sum.stiffness_there);
    std::string advice;
    if (threshold > 0.0) {
      advice = fmt::format("; with increments longer than {} there is one only",
                           with_unit(rounded(threshold), units.time));
    }
    all.push_back(fmt::format(
        "friction '{}': {} increment{} may have more than one solution, because the coefficient "
        "falls with the slip rate faster than the stick stiffness follows; the one of least slip "
        "was taken{}",
        sum.name, sum.multiple_roots, plural(sum.multiple_roots), advice));
  }
  for (const MotionJump& jump : jumps) {
    const std::string unit = unit_text(jump.component >= 3 ? kAngle : kLength, units);
    all.push_back(fmt::format(
        "{} jumps by {} at the start of step '{}' (t = {}): the jump is made in the first "
        "increment{}",
        motion_name(jump.component), with_unit(rounded(jump.size), unit), jump.step,
        rounded(jump.time), jump.time == 0.0 ? "; 'initial:' gives the position before it" : ""));
  }
  return all;
}

json::Value Summary::to_json() const {
  json::Value all;
  all["increments"] = increments_;
  all["start_time"] = start_time_;
  all["end_time"] = end_time_;
  json::Value list = json::Array{};
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const DefinitionSummary& sum = definitions_[d];
    json::Value one;
    one["name"] = sum.name;
    one["slip_time"] = sum.slip_time;
    one["open_time"] = sum.open_time;
    one["stick_slip_events"] = sum.events;
    if (sum.first_slip) {
      json::Value first;
      first["t"] = sum.first_slip->time;
      first["force"] = representative_force(case_->definitions[d], sum.first_slip->definitions[d]);
      for (const Column& position : positions_) {
        first[position.name] = column_value(position, *case_, *sum.first_slip);
      }
      one["first_slip"] = first;
    } else {
      one["first_slip"] = nullptr;
    }
    one["lowest_force"] = sum.lowest_force;
    one["highest_force"] = sum.highest_force;
    one["accumulated_slip"] = sum.accumulated_slip;
    one["dissipation"] = sum.dissipation;
    one["stored_energy"] = sum.stored_energy;
    one["work"] = sum.work;
    one["increments_with_several_solutions"] = sum.multiple_roots;
    list.push_back(one);
  }
  all["definitions"] = list;
  return all;
}

}  // namespace slipbench::driver
#include "law/uniqueness.hpp"
