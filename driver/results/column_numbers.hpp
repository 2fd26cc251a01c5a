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

double position(const Cell& at);  ///< CP, and with an offset CU and CCU
double mean_velocity(const Cell& at);
double prescribed_force(const Cell& at);
double quantity(const Cell& at);
double no_friction(const Cell& at);
double elastic_force(const Cell& at);
double viscous_force(const Cell& at);
double friction_force(const Cell& at);  ///< R_i y_i of one entry of a definition's slip space
double total_force(const Cell& at);     ///< CEF + CVF + CSF + CRF - CCF of a component
double stop_flag(const Cell& at);
double kinetic_energy(const Cell& at);
double external_work(const Cell& at);
double chain_force(const Cell& at);  ///< sum of the friction forces of all rings
double flow_behind(const Cell& at);
double slip_velocity(const Cell& at);  ///< n . ds/dt of a definition
double accumulated_slip(const Cell& at);
double normal_force(const Cell& at);
double mu_along(const Cell& at);
double speed_along(const Cell& at);
double ring_angle(const Cell& at);
/// Returns how far CSF2 may go on one side, with the coefficient of the row.
double band_end(const Cell& at, law::FlowSense sense);

}  // namespace number
}  // namespace slipbench::driver::results
