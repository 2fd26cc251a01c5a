// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/run_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "driver/base/files/exit_code.hpp"

namespace slipbench::driver::bench {

tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const cases::Case& problem, const std::function<void(const Row&)>& take) {
  return follow_case(problem, [&](const Simulation& simulation) { take(simulation.row()); });
}

tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const cases::Case& problem, const std::function<void(const Simulation&)>& take) {
  auto simulation = Simulation::start(problem);
  if (!simulation) return tl::unexpected(std::move(simulation.error()));
  while (true) {
    take(*simulation);
    auto more = simulation->advance();
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) break;
  }
  return std::vector<MotionJump>(simulation->jumps().begin(), simulation->jumps().end());
}

int exit_code(const SimulationFailure& failure) {
  switch (failure.kind) {
    case SimulationFailure::Kind::kInput:
      return base::kExitBadInput;
    case SimulationFailure::Kind::kEnvironment:
      return base::kExitEnvironment;
    case SimulationFailure::Kind::kNumerical:
      break;
  }
  return base::kExitNumerical;
}

std::string failure_text(const cases::Case& problem, const SimulationFailure& failure) {
  return fmt::format(
      "{}: {}: {}\n", problem.file,
      failure.kind == SimulationFailure::Kind::kNumerical ? "numerical failure" : "error",
      failure.message);
}

}  // namespace slipbench::driver::bench
