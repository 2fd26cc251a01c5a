// SPDX-License-Identifier: Apache-2.0
#include "driver/results/normal_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "driver/case/quantity.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::results {
namespace {

/// Two terms may carry the same components: a number tells them apart.
std::string name_of(const law::DerivedTerm& term, const std::vector<NormalShare>& before) {
  std::string components;
  for (int j = 0; j < term.count; ++j) {
    components +=
        (j == 0 ? "" : " ") + cases::force_name(term.component[static_cast<std::size_t>(j)]);
  }
  const std::string name = fmt::format("{} ({})", term_words(term), components);
  const auto same = std::count_if(before.begin(), before.end(), [&](const NormalShare& share) {
    return share.name.starts_with(name);
  });
  return same == 0 ? name : fmt::format("{}, {}", name, same + 1);
}

}  // namespace

std::string term_words(const law::DerivedTerm& term) {
  law::ComponentSet set;
  for (int j = 0; j < term.count; ++j) set.insert(term.component[static_cast<std::size_t>(j)]);
  if (set.size() == 1) {
    const int c = term.component[0];
    return law::is_rotation(c) ? fmt::format("moment about axis {}", c - 2)
                               : fmt::format("force along axis {}", c + 1);
  }
  if (set == law::ComponentSet::of(2, 3)) return "forces across axis 1";
  if (set == law::ComponentSet::of(5, 6)) return "bending moments across axis 1";
  if ((set & law::ComponentSet::of(4, 5, 6)).empty()) return "forces";
  if ((set & law::ComponentSet::of(1, 2, 3)).empty()) return "moments";
  return "forces and moments";
}

double term_value(const law::DerivedTerm& term, const law::ConnectorForce& force,
                  const law::Ambient& ambient) {
  return law::evaluate(law::DerivedComponent{term}, force, ambient);
}

std::vector<NormalShare> contact_shares(const law::ContactForce& contact,
                                        const law::ConnectorIncrement& increment) {
  const law::ConnectorForce& force = increment.force;
  std::vector<NormalShare> shares;
  if (const auto* component = std::get_if<law::ComponentContactForce>(&contact)) {
    shares.push_back({cases::force_name(component->component), force[component->component]});
  } else if (const auto* derived = std::get_if<law::DerivedComponent>(&contact)) {
    for (const law::DerivedTerm& term : *derived) {
      shares.push_back({name_of(term, shares), term_value(term, force, increment.end)});
    }
  } else if (const auto* joint = std::get_if<law::UniversalJointContact>(&contact)) {
    const law::UniversalJointTerms t = law::terms(*joint, force, increment.end.position);
    shares = {{"faces of the hinges", 2.0 * t.face},
              {"radial forces on the pins", 2.0 * joint->R_p * t.radial},
              {"bending of the pins", 2.0 * joint->R_p * t.bending}};
  }
  return shares;
}

double slip_of_internal_force(const law::FrictionDefinition& definition,
                              const law::FrictionUpdate& update) {
  const bool at_end = definition.accumulated_slip == law::AccumulatedSlipTiming::kEnd;
  return update.state.accumulated_slip - (at_end ? 0.0 : update.slip_increment);
}

std::vector<NormalShare> normal_shares(const law::FrictionDefinition& definition,
                                       const law::FrictionUpdate& update,
                                       const law::ConnectorIncrement& increment) {
  if (std::holds_alternative<law::Capstan>(definition.criterion)) {
    return {{"tension before the ring", update.normal_force}};
  }
  std::vector<NormalShare> shares = contact_shares(definition.contact_force, increment);
  const double slip = slip_of_internal_force(definition, update);
  shares.push_back(
      {is_rotational(definition) ? "internal contact moment" : "internal contact force",
       law::evaluate(definition.internal_contact_force, increment.end, slip).value});
  return shares;
}

}  // namespace slipbench::driver::results
