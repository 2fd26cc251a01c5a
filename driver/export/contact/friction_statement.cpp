// SPDX-License-Identifier: Apache-2.0
#include "driver/export/contact/friction_statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <variant>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/format_number.hpp"
#include "law/friction/law_list.hpp"

namespace slipbench::driver::exports {
namespace {

using Kind = Loss::Kind;

law::FrictionLaw law_of(const read::CoefficientText& text) {
  const auto* const law = std::get_if<law::FrictionLaw>(&text.value);
  if (text.with_direction || law == nullptr) {
    throw NotExported{"its table of part pairs has tables, or a coefficient for each direction"};
  }
  return *law;
}

/// Friction of a record of the table of part pairs.
template <class Record>
StatedFriction stated(const Record& record) {
  const read::CoefficientText& text = record.coefficient.value;
  StatedFriction friction;
  if (text.orthotropic) {
    friction.law = law_of(text.orthotropic->direction1.value.coefficient);
    friction.second = law_of(text.orthotropic->direction2.value.coefficient);
  } else {
    friction.law = law_of(text);
  }
  if (record.visf.given()) friction.visf = record.visf.value;
  if (record.force_limit.given() && record.force_limit.value > 0.0) {
    friction.force_limit = record.force_limit.value;
  }
  return friction;
}

/// The number in a name like G100; 0 where it has none.
int number_in(const std::string& name) {
  const std::string digits = name.substr(std::min<std::size_t>(1, name.size()));
  const bool number = !digits.empty() && digits.size() < 9 &&
                      std::all_of(digits.begin(), digits.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
  return number ? std::stoi(digits) : 0;
}

/// Numbers groups, each by the number in its name or, where it has none or another group has it, by
/// the next one that is free.
void number_groups(std::vector<StatedGroup>& groups) {
  std::set<int> taken{0};
  for (StatedGroup& group : groups) {
    const int own = number_in(group.name);
    if (taken.insert(own).second) group.id = own;
  }
  constexpr int kFirst = 1001;
  int next = kFirst;
  for (StatedGroup& group : groups) {
    if (group.id != 0) continue;
    while (!taken.insert(next).second) ++next;
    group.id = next;
  }
}

void take_pairs(const read::FrictionPairsText& table, FrictionStatement& statement) {
  for (const auto& named : table.groups) {
    StatedGroup& group = statement.groups.emplace_back();
    group.name = named.name;
    for (const auto& part : named.value) group.parts.push_back(part.value);
  }
  number_groups(statement.groups);
  for (const StatedGroup& group : statement.groups) {
    statement.id_of_group.emplace(group.name, group.id);
  }
  statement.otherwise = table.otherwise.given() ? stated(table.otherwise.value)
                                                : StatedFriction{.law = law::ConstantCoefficient{}};
  for (const auto& pair : table.pairs.value) {
    statement.pairs.push_back(
        {{pair.value.parts.value[0].value, pair.value.parts.value[1].value}, stated(pair.value)});
  }
}

bool has_geometry(const cases::CaseDefinition& definition) {
  return !definition.predefined || !std::holds_alternative<law::Contact>(*definition.predefined);
}

/// Notes what acts beside the friction, or changes it on the way.
void tell_other_parts(const cases::Case& problem, std::vector<Loss>& losses) {
  bool acts = false;
  for (int c = 0; c < law::kComponents; ++c) acts = acts || cases::acts_beside_friction(problem, c);
  if (acts) {
    losses.push_back(
        {Kind::kDropped, "springs, dampers and stops: a contact has its friction only"});
  }
  if (problem.dynamics) {
    losses.push_back({Kind::kDropped, "the mass and its belt: masses are a matter of the model"});
  }
  if (std::any_of(problem.steps.begin(), problem.steps.end(),
                  [](const cases::Step& step) { return !step.friction_changes.empty(); })) {
    losses.push_back({Kind::kDropped,
                      "changes of friction in steps: the friction is that before the first one"});
  }
}

}  // namespace

int FrictionStatement::id_of(const read::PartOrGroup& side) const {
  if (const int* const part = std::get_if<int>(&side.value)) return *part;
  const auto group = id_of_group.find(std::get<std::string>(side.value));
  return group == id_of_group.end() ? 0 : group->second;
}

FrictionStatement stated_friction(const cases::Case& problem, const read::CaseText& written,
                                  std::vector<Loss>& losses) {
  const auto note = [&](Kind kind, std::string text) { losses.push_back({kind, std::move(text)}); };
  FrictionStatement statement{.title = problem.title, .units = problem.units};
  const cases::CaseDefinition& first = problem.definitions.front();
  for (const cases::CaseDefinition& one : problem.definitions) {
    if (one.entry != first.entry) {
      throw NotExported{
          "it has several friction definitions, and a contact one: export a case of each"};
    }
    if (one.backward) throw NotExported{"it has a coefficient for each direction"};
    if (one.dead_zone) note(Kind::kDropped, "backlash in series with the friction");
  }
  statement.formulation = first.law.formulation;
  statement.stick = first.law.stick;
  statement.area = contact_area(problem, written);
  if (written.friction_pairs.given()) {
    take_pairs(written.friction_pairs.value, statement);
    const std::size_t records = statement.pairs.size();
    note(Kind::kKept, fmt::format("{} record{} of part pairs", records, records == 1 ? "" : "s"));
  } else {
    statement.otherwise.law = first.law.law;
    if (statement.formulation && statement.formulation->orthotropy) {
      statement.otherwise.second = statement.formulation->orthotropy->second;
    }
  }
  if (first.law.force_limit < law::kNoForceLimit && !written.friction_pairs.given()) {
    statement.otherwise.force_limit = first.law.force_limit;
  }
  if (has_geometry(first)) {
    std::string type;
    for (const auto& name : written.connector.value.type.value.names) {
      type += (type.empty() ? "" : ", ") + std::string(name.value);
    }
    note(Kind::kDropped,
         fmt::format("{}: the contact force of its geometry; a contact has the normal force of its "
                     "surfaces",
                     type));
  }
  if (const auto* const force = std::get_if<double>(&first.law.internal_contact_force);
      force == nullptr || *force != 0.0) {
    note(Kind::kDropped, "internal contact force: a preload is a matter of the contact");
  }
  const law::FrictionLaw& law = statement.otherwise.law;
  const auto transition = transition_of(law);
  if (statement.pairs.empty() && transition && transition->at_rest == 0.0 &&
      transition->fast == 0.0) {
    throw NotExported{"it has no friction, which a contact need not say"};
  }
  if (law::is_rotational(first.law.slip) &&
      (law::depends_on_slip_rate(law) || law::depends_on_contact_force(law))) {
    note(Kind::kApproximated,
         "the case's slip is an angle, that of a contact a way: velocities and forces of the deck "
         "are those at a radius of 1");
  }
  tell_other_parts(problem, losses);
  if (!problem.checks.empty()) note(Kind::kDropped, "checks: a deck has none");
  note(Kind::kDropped, "history: the model has its own");
  statement.run = run_range(problem);
  return statement;
}

double contact_area(const cases::Case& problem, const read::CaseText& written) {
  const double own = law::area_of(problem.definitions.front().law.law);
  const auto& area = written.connector.value.area;
  return own > 0.0 || !area.given() ? own : area.value;
}

std::optional<Transition> transition_of(const law::FrictionLaw& law) {
  if (const auto* const constant = law::get_law_if<law::ConstantCoefficient>(law)) {
    return Transition{constant->mu, constant->mu, 0.0};
  }
  if (const auto decay = law::exponential_decay(law)) {
    return Transition{decay->mu_static, decay->kinetic, decay->decay};
  }
  const auto* const darmstad = law::get_law_if<law::ModifiedDarmstad>(law);
  if (darmstad != nullptr && darmstad->c1 == 0.0 && darmstad->c3 == 0.0 && darmstad->c6 <= 0.0) {
    return Transition{darmstad->fric + darmstad->c5, darmstad->fric, -darmstad->c6};
  }
  const auto* const viscous = law::get_law_if<law::GeneralizedViscous>(law);
  if (viscous != nullptr && viscous->c1 == 0.0 && viscous->c2 == 0.0 && viscous->c3 == 0.0 &&
      viscous->c4 == 0.0 && viscous->c5 == 0.0) {
    return Transition{viscous->fric, viscous->fric, 0.0};
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::exports
