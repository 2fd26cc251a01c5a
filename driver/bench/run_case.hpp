// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"

namespace slipbench::driver::bench {

/// Runs a case to its end: `take` gets every row, row 0 first. Returns the motions that jumped, or
/// why it ended early.
tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const cases::Case& problem, const std::function<void(const Row&)>& take);

/// The same for a `take` that wants to see the definitions in force, too.
tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const cases::Case& problem, const std::function<void(const Simulation&)>& take);

/// The exit code that goes with a failed run.
int exit_code(const SimulationFailure& failure);

/// "shock.yaml: error: ..." for a failed run, with a line feed.
std::string failure_text(const cases::Case& problem, const SimulationFailure& failure);

}  // namespace slipbench::driver::bench
