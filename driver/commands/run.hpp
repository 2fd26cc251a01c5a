// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slipbench::driver::commands {

struct RunOptions {
  std::vector<std::string> cases;     ///< paths
  std::string folder = ".";           ///< where the results go; "-": the rows to standard output
  std::vector<std::string> settings;  ///< --set, as typed
  std::optional<int> every;           ///< write every N-th row; the case's choice if absent
  std::string format = "csv";         ///< --format of the rows: a word of table::kTableFormats
  bool no_output = false;             ///< write no files
  bool quiet = false;                 ///< tell only warnings, failed checks and errors
  bool force = false;                 ///< --force: replace files that are no results of the case
  std::optional<double> explain;      ///< --explain: only tell why, at this total time
  bool solver_report = false;         ///< --solver-report: what a solver has to expect
  bool compare_integration = false;   ///< --compare-integration: backward Euler against exact
  bool converge = false;              ///< --converge: dt, dt/2, dt/4
  bool strict = false;                ///< --strict: a warning fails the case
  bool allow_outside = false;
};

/// `slipbench run`: runs cases, writes their results and tells what happened. All cases are read
/// before the first is run, and all files looked at that would be replaced. Rows on standard output
/// are complete or not there; what is told goes to standard error then. Returns the exit code.
int run_command(const RunOptions& options);

}  // namespace slipbench::driver::commands
