// SPDX-License-Identifier: Apache-2.0
// Contact forces together with springs, loads and history: what of them can press at all.
#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "driver/bench/equilibrium.hpp"
#include "driver/read/resolve/resolve.hpp"
#include "driver/results/columns.hpp"
#include "law/component/kinetic_force.hpp"

namespace slipbench::driver::read {
namespace {

/// Definitions that one entry of `friction:` gives, and where it names its contact force.
struct Owner {
  std::vector<std::size_t> definitions;
  const yaml::Node* node = nullptr;
  const yaml::Path* path = nullptr;
  bool predefined = false;
};

std::vector<Owner> owners(const CaseText& text, const cases::Case& problem) {
  std::vector<Owner> all;
  for (const yaml::At<FrictionText>& at : text.friction.value) {
    const FrictionText& one = at.value;
    Owner owner;
    owner.predefined = one.predefined.given();
    if (owner.predefined) {
      // Predefined friction is alone.
      for (std::size_t d = 0; d < problem.definitions.size(); ++d) owner.definitions.push_back(d);
      owner.node = &*one.predefined.node;
      owner.path = &one.predefined.path;
    } else {
      owner.definitions.push_back(all.size());
      const auto& contact = one.contact_force;
      owner.node = contact.given() ? &*contact.node : &*at.node;
      owner.path = contact.given() ? &contact.path : &at.path;
    }
    all.push_back(std::move(owner));
  }
  return all;
}

/// Extent to which the history drives a quantity.
enum class Driven { kNever, kZero, kYes };

Driven driven(const cases::Case& problem, int quantity) {
  if (!cases::is_driven(problem, quantity)) return Driven::kNever;
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives) {
      const auto* constant = std::get_if<history::Constant>(&drive.profile);
      const auto* ramp = std::get_if<history::LinearTo>(&drive.profile);
      const bool zero = (constant != nullptr && constant->value == 0.0) ||
                        (ramp != nullptr && ramp->value == 0.0);
      if (drive.quantity == quantity && !zero) return Driven::kYes;
    }
  }
  return problem.measured ? Driven::kYes : Driven::kZero;
}

Driven pressure(const cases::Case& problem, int component) {
  const Driven load = driven(problem, cases::kFirstForce + component);
  if (!problem.kinetic.pressing.contains(component)) return load;
  const bool mass = problem.dynamics && problem.dynamics->component == component;
  return mass || problem.kinetic.is_elastic(component) || problem.kinetic.is_damped(component)
             ? Driven::kYes
             : load;
}

bool has_no_internal_force(const law::FrictionDefinition& definition) {
  const auto* number = std::get_if<double>(&definition.internal_contact_force);
  return number != nullptr && *number == 0.0;
}

/// Returns the components whose forces could press and never do, `zero` apart, which the history
/// keeps at 0; empty if one of them is driven.
law::ComponentSet undriven(const law::ContactForce& contact, const cases::Case& problem,
                           law::ComponentSet& zero) {
  law::ComponentSet never;
  const law::ComponentSet named = law::components_of(contact);
  for (int c = 0; c < law::kComponents; ++c) {
    if (!named.contains(c)) continue;
    const Driven how = pressure(problem, c);
    if (how == Driven::kYes) return {};
    (how == Driven::kNever ? never : zero).insert(c);
  }
  return never;
}

/// Says once that nothing in the history drives any of the forces that could press.
void tell_undriven(yaml::Binder& binder, const Owner& owner, const cases::Case& problem) {
  // A press fit of predefined friction needs no loads.
  const bool press_fit =
      owner.predefined &&
      std::any_of(owner.definitions.begin(), owner.definitions.end(),
                  [&](auto d) { return !has_no_internal_force(problem.definitions[d].law); });
  if (press_fit) return;
  law::ComponentSet told;
  for (const std::size_t d : owner.definitions) {
    const law::FrictionDefinition& law = problem.definitions[d].law;
    const bool presses_otherwise = !has_no_internal_force(law);
    law::ComponentSet zero;
    const law::ComponentSet never = undriven(law.contact_force, problem, zero);
    if (never.empty() || never == told) continue;
    told = never;
    std::string what = "nothing drives " + force_names(never);
    if (!zero.empty()) what += ", and the history keeps " + force_names(zero) + " at 0";
    what += ": the contact force is 0 over the whole run";
    int first = 0;
    while (!never.contains(first)) ++first;
    const std::string hint =
        problem.kinetic.pressing.contains(first)
            ? component_words(first) +
                  " is free: a spring under 'elasticity' presses once the history moves " +
                  cases::motion_name(first)
        : problem.measured
            ? "a column of the measured history drives it: 'columns: {" + cases::force_name(first) +
                  ": ..}'"
            : "a step drives it, for example 'force: {" + cases::force_name(first) + ": 100}'";
    if (presses_otherwise || !zero.empty()) {
      binder.note(*owner.node, *owner.path, what, hint);
    } else {
      binder.warning(*owner.node, *owner.path, what, hint);
    }
  }
}

/// Returns the connection types that hold `component` and leave what a definition slips in free.
std::string holding_types(int component, const law::SlipSpace& slip) {
  std::vector<std::string_view> names;
  law::for_each_connection_type([&]<class Type>(std::type_identity<Type>) {
    bool good = Type::kInfo.held.contains(component);
    for (int k = 0; k < slip.dimension; ++k) {
      good = good && Type::kInfo.available.contains(slip.component[static_cast<std::size_t>(k)]);
    }
    if (good) names.push_back(Type::kInfo.name);
  });
  return base::in_words(names);
}

/// Returns the first step that drives a load, in words.
std::string loading(const cases::Case& problem, int component) {
  for (const cases::Step& step : problem.steps) {
    for (const cases::Drive& drive : step.drives) {
      if (drive.quantity == cases::kFirstForce + component) return "step '" + step.name + "'";
    }
  }
  return "the measured history";
}

/// Warns of a contact force over a component whose load balances all that presses there.
void tell_balanced(yaml::Binder& binder, const Owner& owner, const cases::Case& problem) {
  const cases::CaseDefinition& definition = problem.definitions[owner.definitions.front()];
  const law::ComponentSet named = law::components_of(definition.law.contact_force);
  for (int c = 0; c < law::kComponents; ++c) {
    if (!named.contains(c) || !problem.kinetic.pressing.contains(c)) continue;
    if (!problem.force_driven.contains(c)) continue;
    std::string left = "nothing is left to press";
    for (const cases::CaseDefinition& other : problem.definitions) {
      const auto begin = other.law.slip.component.begin();
      const auto end = begin + other.law.slip.dimension;
      if (std::find(begin, end, c) == end) continue;
      left =
          "only the friction '" + other.name + "' of " + component_words(c) + " is left to press";
    }
    std::string hint;
    if (problem.kinetic.is_elastic(c)) {
      hint =
          "prescribe " + cases::motion_name(c) + " under 'motion' instead: its spring then presses";
    }
    if (const std::string types = holding_types(c, definition.law.slip); !types.empty()) {
      hint += (hint.empty() ? "prescribe " : "; or prescribe ") + cases::force_name(c) +
              " in a connection that holds " + component_words(c) + ": " + types;
    }
    binder.warning(*owner.node, *owner.path,
                   loading(problem, c) + " drives " + component_words(c) +
                       " by force: in equilibrium its load and the spring or stop that takes it up "
                       "cancel, and " +
                       left,
                   hint);
  }
}

}  // namespace

void finish_contact_forces(yaml::Binder& binder, const CaseText& text, cases::Case& out) {
  const law::ConnectionInfo& info = out.connection.info;
  if (is_any_connection(out.connection) || cases::is_belt(out.connection) || binder.errors() > 0)
    return;
  for (const cases::CaseDefinition& definition : out.definitions) {
    const law::ComponentSet named = law::components_of(definition.law.contact_force);
    out.kinetic.pressing = out.kinetic.pressing | (named & info.available);
  }
  const std::vector<Owner> all = owners(text, out);
  if (const auto order = bench::order_of_evaluation(out); !order) {
    const std::vector<std::size_t>& chain = order.error();
    std::string who;
    for (const std::size_t d : chain) {
      who += (who.empty() ? "'" : "', '") + out.definitions[d].name;
    }
    const Owner& owner = all[chain.front()];
    binder.error(*owner.node, *owner.path,
                 chain.size() == 1
                     ? "friction " + who +
                           "' would press itself: its contact force names a component that it "
                           "slips in and that is driven by force, and in equilibrium that force is "
                           "minus this friction"
                     : "frictions " + who +
                           "' would press each other: the contact force of each names a component "
                           "that the next slips in and that is driven by force, and in equilibrium "
                           "that force is minus its friction",
                 "prescribe the position of such a component under 'motion', or let the contact "
                 "force name another");
    return;
  }
  if (out.steps.empty() && !out.measured) return;
  for (const Owner& owner : all) {
    tell_undriven(binder, owner, out);
    tell_balanced(binder, owner, out);
  }
}

}  // namespace slipbench::driver::read
