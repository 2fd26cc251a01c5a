// SPDX-License-Identifier: Apache-2.0
// The table of verdicts, as text for a terminal or a log.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"

namespace slipbench::driver::suite {

/// "slipbench 0.1.0   24 cases, 61 checks ...", with a line feed; `checks` only if their number is
/// known, `workers` is "2 cores" or "4 threads".
std::string table_head(std::size_t cases, std::optional<std::size_t> checks,
                       const std::string& workers);

/// "3 checks", "1 check".
std::string counted(std::size_t count, const char* thing);

/// The lines of cases, under each other.
class VerdictTable {
 public:
  /// \param cases those of the suite: the longest label is the width of its column
  /// \param quiet leave out what is well
  VerdictTable(std::span<const Candidate> cases, bool quiet, bool colour);

  /// A line for a case, or for each check that failed; none if it is left out. What a case or a
  /// check is called cannot harm the terminal.
  std::string lines(const Candidate& candidate, const CaseOutcome& outcome) const;

 private:
  std::size_t width_ = 0;
  bool quiet_;
  std::string pass_;
  std::string fail_;
};

/// "  24 cases passed, 0 failed ...   0.21 s", with a line feed; the number of checks is told if
/// the head did not.
std::string table_totals(const SuiteTotals& totals, bool with_checks,
                         std::chrono::steady_clock::duration elapsed);

}  // namespace slipbench::driver::suite
