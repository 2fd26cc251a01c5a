// SPDX-License-Identifier: Apache-2.0
#include "driver/analysis/side_by_side.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slipbench::driver::analysis {

void ForceDistance::add(const bench::Row& row, std::size_t definition,
                        const law::FrictionState& other) {
  const law::FrictionState& state = row.definitions[definition].update.state;
  double apart = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < state.force.size(); ++i) {
    const double difference = state.force[i] - other.force[i];
    apart += difference * difference;
    size += state.force[i] * state.force[i];
  }
  apart = std::sqrt(apart);
  sum += apart;
  ++rows;
  largest = std::max(largest, std::sqrt(size));
  if (apart > most) {
    most = apart;
    time = row.time;
    step = row.step;
  }
}

std::string percent_text(double part) { return fmt::format("{:.2g} %", 100.0 * part); }

std::string step_text(const cases::Case& problem, int step) {
  if (problem.steps.empty()) return {};
  return fmt::format(", step '{}'", problem.steps[static_cast<std::size_t>(step)].name);
}

}  // namespace slipbench::driver::analysis
