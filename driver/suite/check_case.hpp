// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "driver/read/read_case.hpp"
#include "driver/report/case_report.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// A case file that was read, before it is run.
struct Reading {
  std::optional<read::ReadCase> read;  ///< none if reading was given up, see `failure`
  CaseOutcome failure;
  double seconds = 0.0;  ///< reading took

  /// Returns how many checks the case has; 0 if it cannot be run.
  std::size_t checks() const;

  /// The files the case is read from, as far as they are known, for one that has errors, too.
  std::vector<std::string> inputs() const;
};

struct CheckCaseOptions {
  bool keep_passing = false;  ///< the verdicts of checks that passed, too
  /// Told how many rows have come since it was asked last, if there is one; the case is given up
  /// when it says so.
  std::function<bool(std::size_t rows)> stopped = {};
  /// Takes what a page of the case needs, if there is one.
  std::function<void(report::CaseReport&&)> report = {};
  std::size_t report_rows = report::kMostRows;  ///< of a run that is not thinned
  bool strict = false;                          ///< a warning fails the case
  unsigned threads = 1;  ///< a second one reads the curves that the case is compared with
};

/// Reads a case, unless it has a fault. Nothing is thrown: a case that needs more memory than there
/// is, or that trips over a bug, is a failure like any other.
Reading read_candidate(const Candidate& candidate, const read::ReadOptions& options);

/// Runs a case that was read and judges its checks. Nothing is thrown, as above. Nothing is
/// returned for a case that was given up.
std::optional<CaseOutcome> check_case(const Candidate& candidate, const Reading& reading,
                                      const CheckCaseOptions& options);

}  // namespace slipbench::driver::suite
