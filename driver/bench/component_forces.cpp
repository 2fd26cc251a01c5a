// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/component_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "driver/base/text/format_number.hpp"
#include "driver/case/quantity.hpp"

namespace slipbench::driver::bench {

bool has_component_forces(const cases::Case& problem) {
  if (problem.belt) return false;
  if (problem.dynamics || !problem.force_driven.empty()) return true;
  for (int c = 0; c < law::kComponents; ++c) {
    if (cases::acts_beside_friction(problem, c)) return true;
  }
  return false;
}

void take_springs_and_dampers(const cases::Case& problem, const law::ConnectorIncrement& increment,
                              ConnectorForces& forces, int mass) {
  const law::KineticBehavior& kinetic = problem.kinetic;
  forces.elastic_energy = 0.0;
  for (int c = 0; c < law::kComponents; ++c) {
    ComponentForces& here = forces.component[static_cast<std::size_t>(c)];
    if (kinetic.is_elastic(c)) {
      if (c != mass) here.elastic = law::elastic_force(kinetic, c, increment.end).force;
      forces.elastic_energy += law::elastic_energy(kinetic, c, increment.end);
    }
    if (kinetic.is_damped(c) && c != mass) {
      const double velocity = law::mean_velocity(increment, c);
      here.viscous = law::viscous_force(kinetic, c, velocity, increment.end).force;
      const double heat = here.viscous * (increment.end.position[c] - increment.begin_position[c]);
      // No row is judged by it: what is infinite stays so, and does not become NaN.
      if (std::isfinite(double{forces.viscous_dissipation})) forces.viscous_dissipation += heat;
    }
  }
}

std::optional<std::string> beyond_stop(const cases::Case& problem, law::ComponentSet solved,
                                       const law::RelativePosition& position) {
  for (int c = 0; c < law::kComponents; ++c) {
    const auto& stop = problem.stop[static_cast<std::size_t>(c)];
    if (!stop || solved.contains(c)) continue;
    const double at = position[c];
    const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(at);
    const bool above = at > stop->upper + rounding;
    if (!above && at >= stop->lower - rounding) continue;
    return fmt::format("{} = {} is beyond the {} stop of component {} at {}", cases::motion_name(c),
                       base::format_number(at), above ? "upper" : "lower", c + 1,
                       base::format_number(above ? stop->upper : stop->lower));
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::bench
