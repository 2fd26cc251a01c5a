// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "law/definition/increment.hpp"

namespace slipbench::driver::bench {

/// Returns the field variables of a row; refers to those of `quantities`.
inline std::span<const double> fields_of(const Quantities& quantities) {
  return std::span(quantities).subspan(cases::kFirstField, law::kMaxFields);
}

/// Returns where the connector is at the end of a row; refers to the fields of `quantities`.
inline law::Ambient ambient_of(const Quantities& quantities,
                               const law::RelativePosition& reference) {
  law::Ambient ambient;
  std::copy_n(quantities.begin() + cases::kFirstMotion, law::kComponents,
              ambient.position.values.begin());
  ambient.motion = law::constitutive_motion(ambient.position, reference);
  ambient.temperature = quantities[cases::kTemperatureQuantity];
  ambient.fields = fields_of(quantities);
  return ambient;
}

/// Returns what the law was given for the increment of a row, kinetic forces that press included;
/// refers to the row's fields. Of a belt, the first ring's.
inline law::ConnectorIncrement connector_increment(const cases::Case& problem, const Row& row) {
  law::ConnectorIncrement increment;
  increment.duration = row.duration;
  increment.begin_position = row.begin;
  increment.end = ambient_of(row.quantities, problem.reference);
  std::copy_n(row.quantities.begin() + cases::kFirstForce, law::kComponents,
              increment.force.values.begin());
  if (!problem.kinetic.pressing.empty()) {
    for (int c = 0; c < law::kComponents; ++c) {
      if (problem.kinetic.pressing.contains(c)) increment.force[c] = row.forces.pressing[c];
    }
  }
  return increment;
}

}  // namespace slipbench::driver::bench
