// SPDX-License-Identifier: Apache-2.0
// Numbers for the list of columns: those that more than one column shows, or that take more than a
// line. All others stand with their column.
#pragma once

#include <optional>

#include "driver/results/columns.hpp"
#include "law/update/capstan_update.hpp"

namespace slipbench::driver::results {

/// The definition that acts in a component, and the entry of its slip space; -1 if there is none.
struct Owner {
  int definition = -1;
  int entry = 0;
};
Owner owner_of(const cases::Case& problem, int component);

/// Calls visit(law) for the laws a definition has in the course of the case.
template <class Visit>
void for_each_law(const cases::Case& problem, std::size_t definition, Visit&& visit) {
  const law::FrictionDefinition& own = problem.definitions[definition].law;
  visit(own.law);
  if (own.formulation && own.formulation->orthotropy) visit(own.formulation->orthotropy->second);
  if (problem.definitions[definition].backward) visit(*problem.definitions[definition].backward);
  for (const cases::Step& step : problem.steps) {
    for (const cases::FrictionChange& change : step.friction_changes) {
      if (change.definition == definition) visit(change.law);
    }
  }
}

/// The area that turns the normal force into the pressure a law of the definition sees.
std::optional<double> area_of(const cases::Case& problem, std::size_t definition);

namespace number {

inline constexpr auto kNoFriction = [](const Cell&) { return 0.0; };
/// CP, and with an offset CU and CCU.
inline constexpr auto kPosition = [](const Cell& at) {
  return at.row.quantities[cases::kFirstMotion + at.index()] - at.column.offset;
};
inline constexpr auto kMeanVelocity = [](const Cell& at) {
  const bench::Row& row = at.row;
  return row.duration > 0.0
             ? (row.quantities[cases::kFirstMotion + at.index()] - row.begin.values[at.index()]) /
                   row.duration
             : 0.0;
};
inline constexpr auto kPrescribedForce = [](const Cell& at) {
  return at.row.quantities[cases::kFirstForce + at.index()];
};
inline constexpr auto kQuantity = [](const Cell& at) { return at.row.quantities[at.index()]; };
inline constexpr auto kElasticForce = [](const Cell& at) { return at.forces().elastic; };
inline constexpr auto kViscousForce = [](const Cell& at) { return at.forces().viscous; };
/// R_i y_i of one entry of a definition's slip space.
inline constexpr auto kFrictionForce = [](const Cell& at) {
  return at.scale() * at.own().update.state.force[at.index()];
};
/// CEF + CVF + CSF + CRF - CCF of a component.
inline constexpr auto kTotalForce = [](const Cell& at) {
  const bench::ComponentForces& forces = at.forces();
  double friction = 0.0;
  if (const Owner owner = owner_of(at.problem, at.column.index); owner.definition >= 0) {
    const auto d = static_cast<std::size_t>(owner.definition);
    const auto entry = static_cast<std::size_t>(owner.entry);
    friction = at.problem.definitions[d].law.slip.scale[entry] *
               at.row.definitions[d].update.state.force[entry];
  }
  return forces.elastic + forces.viscous + friction + forces.reaction - forces.applied;
};
inline constexpr auto kStopFlag = [](const Cell& at) {
  return at.problem.stop[at.index()]->flag(at.row.quantities[cases::kFirstMotion + at.index()]);
};
inline constexpr auto kKineticEnergy = [](const Cell& at) { return at.row.forces.kinetic_energy; };
inline constexpr auto kExternalWork = [](const Cell& at) { return at.row.forces.external_work; };
/// Sum of the friction forces of all rings.
inline constexpr auto kChainForce = [](const Cell& at) {
  double sum = 0.0;
  for (const bench::DefinitionRow& ring : at.row.definitions) sum += ring.update.state.force[0];
  return sum;
};
inline constexpr auto kFlowBehind = [](const Cell& at) { return at.own().behind.flow; };
/// n . ds/dt of a definition.
inline constexpr auto kSlipVelocity = [](const Cell& at) {
  const bench::Row& row = at.row;
  if (!(row.duration > 0.0)) return 0.0;
  const law::SlipSpace& slip = at.law().slip;
  double sum = 0.0;
  for (int k = 0; k < slip.dimension; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const auto c = static_cast<std::size_t>(slip.component[i]);
    sum += at.own().update.direction[i] * slip.scale[i] *
           (row.quantities[cases::kFirstMotion + c] - row.begin.values[c]);
  }
  return sum / row.duration;
};
inline constexpr auto kAccumulatedSlip = [](const Cell& at) {
  return at.own().update.state.accumulated_slip;
};
inline constexpr auto kNormalForce = [](const Cell& at) { return at.own().update.normal_force; };
inline constexpr auto kMuAlong = [](const Cell& at) { return at.own().penalty.mu[at.index()]; };
inline constexpr auto kSpeedAlong = [](const Cell& at) {
  return at.own().penalty.speeds[at.index()];
};
double ring_angle(const Cell& at);
/// Returns how far CSF2 may go on one side, with the coefficient of the row.
double band_end(const Cell& at, law::FlowSense sense);

}  // namespace number
}  // namespace slipbench::driver::results
