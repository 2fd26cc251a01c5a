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
