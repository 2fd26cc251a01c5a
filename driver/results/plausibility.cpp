// SPDX-License-Identifier: Apache-2.0
#include "driver/results/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/units/readable.hpp"
#include "driver/case/quantity.hpp"
#include "driver/results/columns.hpp"
#include "law/contact/contact_force.hpp"

namespace slipbench::driver::results {
namespace {

constexpr double kOpenBalance = 0.01;

/// The components whose force presses the parts of a definition together.
law::ComponentSet pressing_components(const cases::CaseDefinition& definition,
                                      const cases::Case& problem) {
  law::ComponentSet pressing;
  if (std::holds_alternative<law::Capstan>(definition.law.criterion)) {
    pressing.insert(0);
    return pressing;
  }
  law::Ambient start;
  start.position = problem.initial;
  for (int c = 0; c < law::kComponents; ++c) {
    law::ConnectorForce force;
    for (const double sense : {1.0, -1.0}) {
      force[c] = sense;
      if (evaluate(definition.law.contact_force, force, start) != 0.0) pressing.insert(c);
    }
  }
  return pressing;
}

/// Returns whether the law of a definition has a stick spring, and moves with prescribed motions
/// alone.
bool is_measured_by_its_spring(const cases::CaseDefinition& definition,
                               const cases::Case& problem) {
  const law::FrictionDefinition& law = definition.law;
  if (law.formulation || definition.dead_zone || problem.belt) return false;
  for (int i = 0; i < law.slip.dimension; ++i) {
    const int component = law.slip.component[static_cast<std::size_t>(i)];
    if (problem.force_driven.contains(component)) return false;
    if (problem.dynamics && problem.dynamics->component == component) return false;
  }
  return true;
}

std::string whose(const cases::CaseDefinition& definition) {
  return fmt::format("friction '{}': ", definition.name);
}

/// Returns the length of the way through the slip space that holds all motions [L].
double motion_range(const DefinitionExtremes& all) {
  double range = 0.0;
  for (std::size_t i = 0; i < all.lowest_motion.size(); ++i) {
    range = std::hypot(range, all.highest_motion[i] - all.lowest_motion[i]);
  }
  return range;
}

std::string percent(double part) { return fmt::format("{:.2g} %", 100.0 * part); }

}  // namespace

Plausibility::Plausibility(const cases::Case& problem)
    : case_(&problem),
      definitions_(problem.definitions.size()),
      springs_(problem.definitions.size()) {}

void Plausibility::add(std::span<const bench::Row> rows) {
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    add(rows, d);
    if (!case_->definitions[d].law.formulation) add_springs(rows, d);
  }
}

void Plausibility::add(std::span<const bench::Row> rows, std::size_t index) {
  const law::SlipSpace& slip = case_->definitions[index].law.slip;
  DefinitionExtremes& all = definitions_[index];
  for (std::size_t i = 0; i < static_cast<std::size_t>(slip.dimension); ++i) {
    const auto motion =
        static_cast<std::size_t>(cases::kFirstMotion) + static_cast<std::size_t>(slip.component[i]);
    const double scale = slip.scale[i];
    const bool begins = rows.front().index == 0;
    double lowest = begins ? scale * rows.front().quantities[motion] : all.lowest_motion[i];
    double highest = begins ? lowest : all.highest_motion[i];
    for (const bench::Row& row : rows) {
      const double s = scale * row.quantities[motion];
      lowest = std::min(lowest, s);
      highest = std::max(highest, s);
    }
    all.lowest_motion[i] = lowest;
    all.highest_motion[i] = highest;
  }
  double normal_force = all.highest_normal_force;
  double mu = all.highest_mu;
  double energy = all.largest_energy;
  bool falls = all.falls;
  bool slips = all.slips;
  for (const bench::Row& row : rows) {
    const bench::DefinitionRow& here = row.definitions[index];
    const law::FrictionUpdate& update = here.update;
    normal_force = std::max(normal_force, update.normal_force);
    mu = std::max(mu, update.mu);
    energy = std::max(std::max(energy, std::abs(here.work)),
                      std::max<double>(here.dissipation, update.stored_energy));
    falls = falls || here.thresholds.smooth > 0.0;
    slips = slips || update.state.regime == law::Regime::kSlip || update.slip_increment > 0.0;
    if (update.state.regime != law::Regime::kOpen) continue;
    all.opens = true;
    all.open_under_force = all.open_under_force || update.normal_force > 0.0;
  }
  all.falls = falls;
  all.slips = slips;
  all.highest_normal_force = normal_force;
  all.highest_mu = mu;
  all.largest_energy = energy;
  const bench::DefinitionRow& last = rows.back().definitions[index];
  all.work = last.work;
  all.dissipation = last.dissipation;
  all.lost = last.lost;
  all.stored = last.update.stored_energy;
}

void Plausibility::add_springs(std::span<const bench::Row> rows, std::size_t index) {
  const auto dimension = static_cast<std::size_t>(case_->definitions[index].law.slip.dimension);
  DefinitionExtremes& all = definitions_[index];
  Spring before = springs_[index];
  double stiffening = all.stiffening;
  for (const bench::Row& row : rows) {
    const law::FrictionUpdate& update = row.definitions[index].update;
    double force = 0.0;
    double stretch = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      force += update.state.force[i] * update.state.force[i];
      stretch += update.state.elastic_slip[i] * update.state.elastic_slip[i];
    }
    const Spring now{stretch > 0.0 ? std::sqrt(force / stretch) : 0.0, stretch};
    if (before.stretch > 0.0 && now.stretch > 0.0) {
      stiffening += 0.25 * (before.stretch + now.stretch) * (now.stiffness - before.stiffness);
    }
    before = now;
    const double equivalent = update.phi + update.limit;
    if (update.state.regime != law::Regime::kStick || !(stretch > 0.0 && equivalent > 0.0)) {
      continue;
    }
    const double at_limit = std::sqrt(stretch) * update.limit / equivalent;
    all.smallest_elastic_slip =
        all.smallest_elastic_slip > 0.0 ? std::min(all.smallest_elastic_slip, at_limit) : at_limit;
  }
  all.stiffening = stiffening;
  springs_[index] = before;
}

std::string Plausibility::no_pressure(std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  // An exact increment may press, and slip, between two rows without contact.
  if (definitions_[index].highest_normal_force > 0.0 || definitions_[index].slips) return {};
  const law::ComponentSet pressing = pressing_components(definition, *case_);
  std::vector<std::string> all;
  std::vector<std::string> driven;
  for (int c = 0; c < law::kComponents; ++c) {
    if (!pressing.contains(c)) continue;
    all.push_back(cases::force_name(c));
    if (case_->kinetic.pressing.contains(c) && case_->force_driven.contains(c)) continue;
    if (case_->belt && case_->kinetic.is_elastic(c)) {
      driven.push_back("the strain CU1");
    } else if (!case_->belt && cases::acts_beside_friction(*case_, c)) {
      const bool moves = cases::is_driven(*case_, cases::kFirstMotion + c);
      driven.push_back(cases::motion_name(c) + (moves ? "" : " (nothing moves it)"));
    } else if (cases::is_driven(*case_, cases::kFirstForce + c)) {
      driven.push_back(cases::force_name(c));
    }
  }
  // That nothing drives it, or that its load balances all that presses, is said when the case is
  // read.
  const bool constant = std::holds_alternative<double>(definition.law.internal_contact_force);
  if (!all.empty() && driven.empty() && constant) return {};
  std::string text = whose(definition) +
                     "nothing ever presses: its contact force is 0 all along, "
                     "and so is its friction; ";
  if (all.empty() && !constant) return text + "look at its 'internal_contact_force'";
  if (all.empty()) {
    return text + "it has no 'contact_force' that could be driven, and no 'internal_contact_force'";
  }
  const auto words = [](const std::vector<std::string>& names) {
    return base::in_words(std::vector<std::string_view>(names.begin(), names.end()), "and");
  };
  return text + fmt::format("look at the size and the sign of {} in the history",
                            words(driven.empty() ? all : driven));
}

std::string Plausibility::no_motion() const {
  law::ComponentSet slipping;
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    const cases::CaseDefinition& definition = case_->definitions[d];
    if (!is_measured_by_its_spring(definition, *case_) || motion_range(definitions_[d]) > 0.0) {
      return {};
    }
    const law::SlipSpace& slip = definition.law.slip;
    for (int i = 0; i < slip.dimension; ++i) {
      slipping.insert(slip.component[static_cast<std::size_t>(i)]);
    }
  }
  if (slipping.empty()) return {};
  std::vector<std::string> names;
  for (int c = 0; c < law::kComponents; ++c) {
    if (slipping.contains(c)) names.push_back(cases::motion_name(c));
  }
  return fmt::format(
      "history: nothing moves: {} never changes, so nothing can slip; a step moves it, for example "
      "'motion: "
      "{{{}: {{to: 1}}}}'",
      base::in_words(std::vector<std::string_view>(names.begin(), names.end()), "and"),
      names.front());
}

std::string Plausibility::mere_spring(std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const DefinitionExtremes& all = definitions_[index];
  if (all.slips || all.smallest_elastic_slip == 0.0) return {};
  if (!is_measured_by_its_spring(definition, *case_)) return {};
  const double range = motion_range(all);
  if (range >= all.smallest_elastic_slip) return {};
  const std::string unit =
      base::unit_text(is_rotational(definition.law) ? base::kAngle : base::kLength, case_->units);
  const bool fixed = definition.law.stick.mode == law::StickStiffness::Mode::kElasticSlip;
  return whose(definition) +
         fmt::format(
             "its motion, {} in all, is less than the elastic slip that comes before any "
             "slip, {}: it never slips, and its force is that of the stick spring; move "
             "farther, or {}",
             base::with_unit(base::rounded(range, 3), unit),
             base::with_unit(base::rounded(all.smallest_elastic_slip, 3), unit),
             fixed ? "take a smaller elastic slip under 'stick'"
                   : "raise the 'stiffness' under 'stick'");
}

std::string Plausibility::open_balance(std::size_t index) const {
  const cases::CaseDefinition& definition = case_->definitions[index];
  const DefinitionExtremes& all = definitions_[index];
  // The force behind a filter, and a penalty as a program has it, keep no balance; a lost contact
  // and a force that drops from static to kinetic lose what no increments bring back.
  if (definition.law.formulation || definition.dead_zone || all.opens || all.falls) return {};
  if (!(all.largest_energy > 0.0)) return {};
  const double gap = (all.work - all.dissipation - all.lost - all.stored) / all.largest_energy;
  const double of_stepping = gap + all.stiffening / all.largest_energy;
  if (std::abs(gap) <= kOpenBalance) return {};
  const std::string energies =
      fmt::format("the energy balance is open by {} (work {}, dissipated {}, stored {}): ",
                  percent(std::abs(gap)), base::energy_text(all.work, case_->units),
                  base::energy_text(all.dissipation, case_->units),
                  base::energy_text(all.stored, case_->units));
  if (std::abs(of_stepping) <= kOpenBalance) {
    return whose(definition) + energies +
           "the stick stiffness changes while its spring is stretched, which no work of the "
           "friction pays for; a constant 'stick: {stiffness: ..}' and longer motions make it less";
  }
  return whose(definition) + energies +
         "too much changes within an increment; take more 'increments', as many as it needs for "
         "this to go below 1 % ('run --converge' tells what they change)";
}

std::vector<std::string> Plausibility::findings() const {
  std::vector<std::string> all;
  const auto add = [&](std::string text) {
    if (!text.empty()) all.push_back(std::move(text));
  };
  add(no_motion());
  for (std::size_t d = 0; d < definitions_.size(); ++d) {
    add(no_pressure(d));
    add(mere_spring(d));
    add(open_balance(d));
  }
  return all;
}

}  // namespace slipbench::driver::results
