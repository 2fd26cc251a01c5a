// SPDX-License-Identifier: Apache-2.0
#include "driver/export/fmu/law_numbers.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "driver/base/text/format_number.hpp"
#include "law/definition/packed_definition.hpp"

namespace slipbench::driver::exports {
namespace {

using Kind = Loss::Kind;

/// A sentence on what a law alone cannot hold, or nothing.
std::string beyond_a_law(const cases::Case& problem) {
  for (const cases::CaseDefinition& one : problem.definitions) {
    if (std::holds_alternative<law::Capstan>(one.law.criterion)) {
      return "the friction of a belt follows from its tensions and its strain, which the case's "
             "own history moves";
    }
    if (one.dead_zone) return "a dead zone is beside the law, and has a state of its own";
    if (one.backward) return "a coefficient for each direction is beside the law";
  }
  if (!problem.kinetic.pressing.empty()) {
    return "a contact force names a free component, whose springs and loads are not part of the "
           "law";
  }
  if (problem.definitions.empty()) return "the case has no friction";
  return {};
}

}  // namespace

tl::expected<LawNumbers, std::string> law_numbers(const cases::Case& problem) {
  if (std::string fault = beyond_a_law(problem); !fault.empty()) {
    return tl::unexpected(std::move(fault));
  }
  std::vector<law::FrictionDefinition> definitions;
  definitions.reserve(problem.definitions.size());
  for (const cases::CaseDefinition& one : problem.definitions) definitions.push_back(one.law);
  LawNumbers made{law::pack_all(definitions), {{Kind::kKept, "the friction, in all digits"}}};
  const auto drop = [&](bool there, const char* text) {
    if (there) made.losses.push_back({Kind::kDropped, text});
  };
  drop(true, "history, output and checks: motions and forces are the host's");
  bool acts = false;
  for (int c = 0; c < law::kComponents; ++c) acts = acts || cases::acts_beside_friction(problem, c);
  drop(acts, "springs, dampers and stops: forces beside friction are the host's");
  drop(problem.dynamics.has_value(), "the mass and its belt: the host moves masses");
  drop(!problem.force_driven.empty(),
       "the equilibrium of components that are driven by force: the host finds positions");
  drop(std::any_of(problem.steps.begin(), problem.steps.end(),
                   [](const cases::Step& step) { return !step.friction_changes.empty(); }),
       "changes of friction in steps: the friction is that of the first step's begin");
  if (problem.integration.method == cases::IntegrationMethod::kExact) {
    made.losses.push_back(
        {Kind::kApproximated, "exact integration: an increment is one of backward_euler"});
  }
  return made;
}

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text = std::to_string(numbers.size()) + '\n';
  for (const double x : numbers) {
    base::append_number(text, x);
    text += '\n';
  }
  return text;
}

}  // namespace slipbench::driver::exports
