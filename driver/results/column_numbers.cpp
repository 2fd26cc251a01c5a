// SPDX-License-Identifier: Apache-2.0
#include "driver/results/column_numbers.hpp"

#include <algorithm>
#include <variant>

#include "driver/case/quantity.hpp"

namespace slipbench::driver::results {

Owner owner_of(const cases::Case& problem, int component) {
  for (std::size_t d = 0; d < problem.definitions.size(); ++d) {
    const law::SlipSpace& slip = problem.definitions[d].law.slip;
    for (int k = 0; k < slip.dimension; ++k) {
      if (slip.component[static_cast<std::size_t>(k)] == component) {
        return {static_cast<int>(d), k};
      }
    }
  }
  return {};
}

std::optional<double> area_of(const cases::Case& problem, std::size_t definition) {
  std::optional<double> area;
  for_each_law(problem, definition, [&](const law::FrictionLaw& law) {
    if (const double own = law::area_of(law); !area && own > 0.0) area = own;
  });
  return area;
}

namespace number {

double no_friction(const Cell&) { return 0.0; }

double position(const Cell& at) {
  return at.row.quantities[cases::kFirstMotion + at.index()] - at.column.offset;
}

double mean_velocity(const Cell& at) {
  const bench::Row& row = at.row;
  return row.duration > 0.0
             ? (row.quantities[cases::kFirstMotion + at.index()] - row.begin.values[at.index()]) /
                   row.duration
             : 0.0;
}

double prescribed_force(const Cell& at) {
  return at.row.quantities[cases::kFirstForce + at.index()];
}

double quantity(const Cell& at) { return at.row.quantities[at.index()]; }

double elastic_force(const Cell& at) { return at.forces().elastic; }

double viscous_force(const Cell& at) { return at.forces().viscous; }

double friction_force(const Cell& at) {
  return at.scale() * at.own().update.state.force[at.index()];
}

double total_force(const Cell& at) {
  const bench::ComponentForces& forces = at.forces();
  double friction = 0.0;
  if (const Owner owner = owner_of(at.problem, at.column.index); owner.definition >= 0) {
    const auto d = static_cast<std::size_t>(owner.definition);
    const auto entry = static_cast<std::size_t>(owner.entry);
    friction = at.problem.definitions[d].law.slip.scale[entry] *
               at.row.definitions[d].update.state.force[entry];
  }
  return forces.elastic + forces.viscous + friction + forces.reaction - forces.applied;
}

double stop_flag(const Cell& at) {
  return at.problem.stop[at.index()]->flag(at.row.quantities[cases::kFirstMotion + at.index()]);
}

double kinetic_energy(const Cell& at) { return at.row.forces.kinetic_energy; }

double external_work(const Cell& at) { return at.row.forces.external_work; }

double chain_force(const Cell& at) {
  double sum = 0.0;
  for (const bench::DefinitionRow& ring : at.row.definitions) sum += ring.update.state.force[0];
  return sum;
}

double flow_behind(const Cell& at) { return at.own().behind.flow; }

double slip_velocity(const Cell& at) {
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
}

double accumulated_slip(const Cell& at) { return at.own().update.state.accumulated_slip; }

double normal_force(const Cell& at) { return at.own().update.normal_force; }

double mu_along(const Cell& at) { return at.own().penalty.mu[at.index()]; }

double speed_along(const Cell& at) { return at.own().penalty.speeds[at.index()]; }

double ring_angle(const Cell& at) {
  if (at.problem.belt && at.problem.belt->angle_from_nodes) return at.row.belt.wrap_angle;
  return std::get<law::Capstan>(at.law().criterion).wrap_angle;
}

double band_end(const Cell& at, law::FlowSense sense) {
  const law::FrictionUpdate& update = at.own().update;
  const double mu_alpha = update.mu * ring_angle(at);
  return std::min(update.normal_force * law::capstan_limit(mu_alpha, sense), at.law().force_limit);
}

}  // namespace number
}  // namespace slipbench::driver::results
