// SPDX-License-Identifier: Apache-2.0
// Outcomes of the cases of a suite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/check/check.hpp"

namespace slipbench::driver::suite {

/// One check of a case that was run.
struct CheckOutcome {
  check::Verdict verdict;
  std::string text;            ///< as the table tells it
  base::SourcePosition where;  ///< of the check in the case's file
};

/// Reason, in one line, why a case was not run to its end.
struct CaseFault {
  std::string file;
  base::SourcePosition where;  ///< line 0 where there is none
  std::string message;
};

/// One case of a suite.
struct CaseOutcome {
  enum class Kind : std::uint8_t { kPassed, kFailed, kNoChecks, kNotRun };

  Kind kind = Kind::kNotRun;
  int code = base::kExitOk;  ///< the exit code it would have alone
  std::size_t checks = 0;    ///< how many it has
  std::size_t failed = 0;    ///< of them
  double seconds = 0.0;      ///< it took to read, run and judge
  std::string remark;        ///< beside a passed case: its worst check
  /// Those that failed or are doubtful; those that passed too if they are wanted.
  std::vector<CheckOutcome> verdicts;
  std::vector<std::string> warnings;  ///< of a case that was run, unless all its checks passed
  std::string messages;               ///< of a case that was not run, as printed: one or more lines
  CaseFault fault;                    ///< of a case that was not run
  std::vector<std::string> inputs;    ///< files it was read from

  bool well() const { return kind == Kind::kPassed || kind == Kind::kNoChecks; }
};

/// "passed", "failed", "no_checks", "not_run".
constexpr const char* word_for(CaseOutcome::Kind kind) {
  switch (kind) {
    case CaseOutcome::Kind::kPassed:
      return "passed";
    case CaseOutcome::Kind::kFailed:
      return "failed";
    case CaseOutcome::Kind::kNoChecks:
      return "no_checks";
    case CaseOutcome::Kind::kNotRun:
      break;
  }
  return "not_run";
}

/// Counts of the cases of a suite by outcome.
struct SuiteTotals {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t no_checks = 0;
  std::size_t not_run = 0;  ///< faulty ones and those that were not reached
  std::size_t checks = 0;
  std::size_t failed_checks = 0;
  int code = base::kExitOk;  ///< the worst

  void add(const CaseOutcome& outcome);
};

}  // namespace slipbench::driver::suite
