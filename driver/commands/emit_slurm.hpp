// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "driver/commands/sweep.hpp"
#include "driver/commands/sweep_files.hpp"

namespace slipbench::driver::commands {

/// Tasks of a job array, so that each takes two minutes or more: starting one costs Slurm about a
/// second. At most 1000, as many as a Slurm takes that was not told otherwise.
/// \param rate samples a second and core
std::size_t array_tasks(std::size_t samples, double rate);

/// Writes SWEEP.slurm: a job array whose tasks run the parts of a sweep, and says how to start it
/// and to join what it leaves. Returns the exit code.
int emit_slurm(const OpenSweep& open, const SweepOptions& options);

}  // namespace slipbench::driver::commands
