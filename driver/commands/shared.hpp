// SPDX-License-Identifier: Apache-2.0
// What the commands have in common: reading cases, running them, talking to the terminal.
#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/check/check.hpp"
#include "driver/read/read_case.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver {

/// `--set name=value` taken apart; the value is a number or an expression over other parameters.
/// Errors: no '=', nothing before or after it.
tl::expected<std::vector<ParameterText>, std::string> parse_settings(
    std::span<const std::string> settings);

/// Everything written to standard output goes through here, so that `finish_output` knows whether
/// it arrived.
void print(std::string_view text);
/// Lets what was printed be seen now, by those who follow a long work.
void flush_output();
/// A message for standard error.
void print_error(std::string_view text);
/// "slipbench: error: ..." for standard error; returns `code`. What names and files are called
/// cannot harm the terminal.
int refuse(int code, std::string_view message);

/// The case that somebody names: the path as it is, or, if there is nothing of that name, the file
/// that is called so with .yaml or .yml, as tables show it; with a warning if both are there.
std::string named_case(const std::string& path);

/// Why `-o` names no folder: it is a file by its ending, or "-". A sentence, or nothing.
/// \param whose of what the files in it bear the name: "case"
std::string folder_fault(const std::string& folder, std::string_view whose);

/// Flushes standard output. If something did not arrive (a closed or full one), says so on
/// standard error and returns the worse of `code` and kExitEnvironment. A reader that has seen
/// enough, as head has, is no trouble: nothing is said, and kExitOk becomes kExitNoReader.
int finish_output(int code);

/// True if colour is wanted on a stream. The first of these decides: NO_COLOR that is not empty
/// forbids it, FORCE_COLOR or CLICOLOR_FORCE that is neither empty nor 0 demands it, CLICOLOR=0
/// forbids it; else a terminal whose TERM is neither empty nor "dumb" has it.
bool colour_wanted(int descriptor);

/// "12 ms", "0.21 s", "3.4 s".
std::string elapsed_text(std::chrono::steady_clock::duration elapsed);

/// Runs a case to its end: `take` gets every row, row 0 first. Returns the motions that jumped, or
/// why it ended early.
tl::expected<std::vector<MotionJump>, SimulationFailure> run_case(
    const Case& problem, const std::function<void(const Row&)>& take);

/// The same for a `take` that wants to see the definitions in force, too.
tl::expected<std::vector<MotionJump>, SimulationFailure> follow_case(
    const Case& problem, const std::function<void(const Simulation&)>& take);

/// The exit code that goes with a failed run.
int exit_code(const SimulationFailure& failure);

/// "shock.yaml: error: ..." for a failed run, with a line feed.
std::string failure_text(const Case& problem, const SimulationFailure& failure);

/// The file of a case and those of its history.
std::vector<std::string> history_files(const Case& problem);

/// The files a case is read from, none of which may be overwritten: those of its history, its
/// tables and the curves of its checks.
std::vector<std::string> input_files(const Case& problem);

/// The check's line in the results of `run` and `check`: its name, and the worst deviation or what
/// is wrong.
std::string verdict_text(const Check& check, const Verdict& verdict);

/// "worst 2.1e-15 of 1e-12" (both relative), or "worst 0.41 of its tolerance".
std::string worst_text(const Check& check, const Verdict& verdict);

}  // namespace slipbench::driver
