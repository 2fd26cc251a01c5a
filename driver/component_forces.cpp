// SPDX-License-Identifier: Apache-2.0
#include "driver/component_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/case/quantity.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {

bool has_component_forces(const Case& problem) {
  if (problem.belt) return false;
  return problem.dynamics || !problem.force_driven.empty() ||
         std::any_of(problem.behavior.begin(), problem.behavior.end(),
                     [](const ComponentBehavior& behavior) { return behavior.any(); });
}

void take_springs_and_dampers(const Case& problem, const law::ConnectorIncrement& increment,
                              ConnectorForces& forces, int except) {
  forces.elastic_energy = 0.0;
  for (int c = 0; c < law::kComponents; ++c) {
    if (c == except) continue;
    const auto i = static_cast<std::size_t>(c);
    const ComponentBehavior& behavior = problem.behavior[i];
    ComponentForces& here = forces.component[i];
    if (behavior.elasticity) {
      const double u = increment.end.motion[c];
      here.elastic = behavior.elasticity->value(u, increment.end).force;
      forces.elastic_energy += behavior.elasticity->energy(u, increment.end);
    }
    if (behavior.damping) {
      const double motion = increment.end.position[c] - increment.begin_position[c];
      const double velocity = increment.duration > 0.0 ? motion / increment.duration : 0.0;
      here.viscous = behavior.damping->value(velocity, increment.end).force;
      forces.viscous_dissipation += here.viscous * motion;
    }
  }
}

std::optional<std::string> beyond_stop(const Case& problem, law::ComponentSet solved,
                                       const law::RelativePosition& position) {
  for (int c = 0; c < law::kComponents; ++c) {
    const auto& stop = problem.behavior[static_cast<std::size_t>(c)].stop;
    if (!stop || solved.contains(c)) continue;
    const double at = position[c];
    const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(at);
    const bool above = at > stop->upper + rounding;
    if (!above && at >= stop->lower - rounding) continue;
    return fmt::format("{} = {} is beyond the {} stop of component {} at {}", motion_name(c),
                       format_number(at), above ? "upper" : "lower", c + 1,
                       format_number(above ? stop->upper : stop->lower));
  }
  return std::nullopt;
}

}  // namespace slipbench::driver
