// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::bench {

/// Runs cases side by side, the one loop that follows runs: `take` sees all of them at the start,
/// and again after each increment of the first, when the others have come to the same time; it
/// returns whether to go on. Ends with the first of them, or returns why one failed.
tl::expected<std::vector<Simulation>, SimulationFailure> follow_cases(
    std::span<const cases::Case> problems,
    const std::function<bool(std::span<const Simulation>)>& take);

/// Runs a case to its end: `take` gets every row, row 0 first. Returns the motions that jumped, or
/// why it ended early.
tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const cases::Case& problem, const std::function<void(const Row&)>& take);

/// The same for a `take` of some rows at once.
tl::expected<std::vector<MotionJump>, SimulationFailure> run_in_blocks(
    const cases::Case& problem, const std::function<void(std::span<const Row>)>& take);

/// The same for a `take` that wants to see the definitions in force, too.
tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const cases::Case& problem, const std::function<void(const Simulation&)>& take);

/// The exit code that goes with a failed run.
int exit_code(const SimulationFailure& failure);

/// "shock.yaml: error: ..." for a failed run, with a line feed.
std::string failure_text(const cases::Case& problem, const SimulationFailure& failure);

}  // namespace slipbench::driver::bench
