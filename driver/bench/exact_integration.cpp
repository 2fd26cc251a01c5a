// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/exact_integration.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include "driver/bench/belt_motion.hpp"
#include "driver/bench/connector_increment.hpp"
#include "law/connection/belt.hpp"

namespace slipbench::driver::bench {
namespace {

double wrap_angle(const law::FrictionDefinition& definition) {
  const auto* belt = std::get_if<law::Capstan>(&definition.criterion);
  return belt != nullptr ? belt->wrap_angle : 0.0;
}

std::optional<ExactRefusal> refuse_definition(const std::string& name,
                                              const law::FrictionDefinition& definition) {
  if (definition.formulation) {
    return ExactRefusal{"friction '" + name +
                            "': a formulation is a rule for increments, as the solver takes them: "
                            "there is no continuous solution to follow",
                        "leave the method out"};
  }
  const auto why = law::no_continuous_solution(definition);
  if (!why) return std::nullopt;
  const std::string whose = "friction '" + name + "': ";
  if (*why == law::NoContinuousSolution::kWeakening) {
    return ExactRefusal{
        whose +
            "the coefficient falls with the rate of the slip it allows, under a constant stick "
            "stiffness: the continuous force would jump, there is none to follow",
        "use backward_euler, or slip_rate: relative_motion, or an allowable elastic slip"};
  }
  if (*why == law::NoContinuousSolution::kShiftWithElasticSlip) {
    return ExactRefusal{
        whose +
            "a shifted potential over an allowable elastic slip, whose limit changes with the "
            "slip: "
            "what elastic slip is allowed changes with it, and exact integration does not follow",
        "use backward_euler, or a constant stick stiffness"};
  }
  return ExactRefusal{whose +
                          "the accumulated slip of an increment's start depends on the "
                          "increments, and exact integration does not",
                      "leave out accumulated_slip: start"};
}

}  // namespace

ExactIntegration::ExactIntegration(const cases::Case& problem)
    : case_(&problem), kinetic_(problem.kinetic), definitions_(problem.definitions.size()) {
  if (problem.belt && kinetic_.elasticity[0]) kinetic_.pressing.insert(0);
}

void ExactIntegration::begin(const Quantities& quantities,
                             std::span<const law::FrictionDefinition> definitions) {
  quantities_ = quantities;
  for (std::size_t i = 0; i < definitions.size(); ++i) {
    definitions_[i] = {definitions[i].blend, definitions[i].stick.value,
                       wrap_angle(definitions[i])};
  }
}

law::FrictionUpdate ExactIntegration::update(std::size_t index,
                                             const law::FrictionDefinition& definition,
                                             const law::ConnectorIncrement& increment,
                                             const law::FrictionState& old,
                                             law::RegimeChanges& changes) const {
  law::PathSegment segment;
  segment.increment = increment;
  segment.begin = ambient_of(quantities_, case_->reference);
  // Motions begin where the connector was, even where their profile has jumped away.
  segment.begin.position = increment.begin_position;
  segment.begin.motion = law::constitutive_motion(increment.begin_position, case_->reference);
  if (case_->belt && case_->belt->has_length) {
    segment.begin_length = reference_length(*case_, segment.begin.position);
    segment.end_length = reference_length(*case_, increment.end.position);
    segment.begin.motion[0] = law::strain(segment.begin.position[0], segment.begin_length);
  }
  std::copy_n(quantities_.begin() + cases::kFirstForce, law::kComponents,
              segment.begin_force.values.begin());
  const law::ComponentSet named = law::components_of(definition.contact_force);
  if (!(kinetic_.pressing & named).empty()) {
    segment.kinetic = &kinetic_;
    for (int c = 0; c < law::kComponents; ++c) {
      if (!kinetic_.pressing.contains(c)) continue;
      segment.begin_force[c] =
          law::kinetic_force(kinetic_, c, law::mean_velocity(increment, c), segment.begin);
    }
  }
  segment.begin_blend = definitions_[index].blend;
  segment.begin_stick = definitions_[index].stick;
  segment.begin_wrap_angle = definitions_[index].wrap_angle;
  return law::continuous_update(definition, segment, old, case_->integration.tolerance, &changes);
}

std::optional<ExactRefusal> refuse_exact(const cases::Case& problem) {
  if (problem.dynamics) {
    return ExactRefusal{"a dynamic case locates its changes itself: there is nothing to choose",
                        "leave the method out"};
  }
  if (!problem.force_driven.empty()) {
    return ExactRefusal{"exact integration needs components that are driven by their motion; " +
                            std::string("the motion of one that is driven by force is not straight "
                                        "between two rows"),
                        "use backward_euler and small increments"};
  }
  if (problem.measured && problem.measured->hold) {
    return ExactRefusal{
        "a history that holds its rows jumps from one to the next, and exact "
        "integration joins them by straight lines",
        "use backward_euler, or leave out 'hold'"};
  }
  const bool judged = problem.belt && problem.belt->both_tensions;
  if (problem.belt && !judged && problem.definitions.size() > 1) {
    return ExactRefusal{
        "a ring of a chain meets the tension that the ring before leaves, which "
        "does not go straight from row to row",
        "use backward_euler and small increments"};
  }
  if (problem.belt && problem.kinetic.damping[0]) {
    return ExactRefusal{
        "the damping of a belt lets its tension jump where the rate of its strain does, and exact "
        "integration does not follow such a jump",
        "use backward_euler and small increments"};
  }
  std::vector<law::FrictionDefinition> changed;
  for (const cases::CaseDefinition& definition : problem.definitions) {
    changed.push_back(definition.law);
    if (definition.dead_zone) {
      return ExactRefusal{"friction '" + definition.name +
                              "' has a dead zone, which only backward_euler crosses: an increment "
                              "may unload, cross it and load again",
                          "leave the method out; at a constant limit backward_euler is exact"};
    }
    if (definition.backward) {
      return ExactRefusal{"friction '" + definition.name +
                              "' has a coefficient for each direction, which only backward_euler "
                              "chooses between",
                          "leave the method out; at a constant limit backward_euler is exact"};
    }
    if (auto refusal = refuse_definition(definition.name, definition.law)) return refusal;
  }
  for (const cases::Step& step : problem.steps) {
    for (const cases::FrictionChange& change : step.friction_changes) {
      law::FrictionDefinition& now = changed[change.definition];
      now.law = change.law;
      now.stick = change.stick;
      if (auto refusal = refuse_definition(problem.definitions[change.definition].name, now)) {
        return refusal;
      }
    }
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::bench
