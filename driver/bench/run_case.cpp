// SPDX-License-Identifier: Apache-2.0
#include "driver/bench/run_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "driver/base/files/exit_code.hpp"

namespace slipbench::driver::bench {

tl::expected<std::vector<Simulation>, SimulationFailure> follow_cases(
    std::span<const cases::Case> problems,
    const std::function<bool(std::span<const Simulation>)>& take) {
  std::vector<Simulation> runs;
  runs.reserve(problems.size());
  for (const cases::Case& problem : problems) {
    auto run = Simulation::start(problem);
    if (!run) return tl::unexpected(std::move(run.error()));
    runs.push_back(std::move(*run));
  }
  // Times of different increments are the same but for rounding.
  constexpr double kSame = 1e-6;
  while (take(runs)) {
    for (Simulation& run : runs) {
      do {
        const auto more = run.advance();
        if (!more) return tl::unexpected(more.error());
        if (!*more) return runs;
      } while (run.row().time < runs.front().row().time - kSame * runs.front().row().duration);
    }
  }
  return runs;
}

tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const cases::Case& problem, const std::function<void(const Row&)>& take) {
  return run_in_blocks(problem, [&](std::span<const Row> rows) {
    for (const Row& row : rows) take(row);
  });
}

tl::expected<std::vector<MotionJump>, SimulationFailure> run_in_blocks(
    const cases::Case& problem, const std::function<void(std::span<const Row>)>& take) {
  auto run = Simulation::start(problem);
  if (!run) return tl::unexpected(std::move(run.error()));
  take({&run->row(), 1});
  while (true) {
    const auto rows = run->advance_rows();
    if (!rows) return tl::unexpected(rows.error());
    if (rows->empty()) break;
    take(*rows);
  }
  const auto jumps = run->jumps();
  return std::vector<MotionJump>(jumps.begin(), jumps.end());
}

tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const cases::Case& problem, const std::function<void(const Simulation&)>& take) {
  const auto runs = follow_cases({&problem, 1}, [&](std::span<const Simulation> all) {
    take(all.front());
    return true;
  });
  if (!runs) return tl::unexpected(runs.error());
  const auto jumps = runs->front().jumps();
  return std::vector<MotionJump>(jumps.begin(), jumps.end());
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
