// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/verdict_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/utf8.hpp"
#include "driver/results/provenance.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::suite {
namespace {

/// `left` and `right` on one line of the table's width.
std::string two_ends(const std::string& left, const std::string& right) {
  constexpr std::size_t kWidth = 72;
  const std::size_t used = left.size() + right.size();
  return left + std::string(used + 3 < kWidth ? kWidth - used : 3, ' ') + right + "\n";
}

std::string painted(bool colour, const char* code, const char* text) {
  return colour ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
}

}  // namespace

std::string counted(std::size_t count, const char* thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string table_head(std::size_t cases, std::optional<std::size_t> checks,
                       const std::string& workers) {
  std::string left =
      fmt::format("slipbench {}   {}", results::program_version(), counted(cases, "case"));
  if (checks) left += ", " + counted(*checks, "check");
  return two_ends(left, workers);
}

VerdictTable::VerdictTable(std::span<const Candidate> cases, bool quiet, bool colour)
    : quiet_(quiet), pass_(painted(colour, "32", "PASS")), fail_(painted(colour, "31", "FAIL")) {
  for (const Candidate& candidate : cases) {
    width_ = std::max(width_, base::count_code_points(candidate.label));
  }
}

std::string VerdictTable::lines(const Candidate& candidate, const CaseOutcome& outcome) const {
  if (quiet_ && outcome.well()) return {};
  const std::string label = base::printable(candidate.label);
  const std::string padded = label + std::string(width_ - base::count_code_points(label), ' ');
  std::string text;
  switch (outcome.kind) {
    case CaseOutcome::Kind::kPassed:
      return fmt::format("  {}  {}   {:>9}   {}\n", pass_, padded, counted(outcome.checks, "check"),
                         outcome.remark);
    case CaseOutcome::Kind::kNoChecks:
      return fmt::format("  ----  {}   no checks\n", padded);
    case CaseOutcome::Kind::kFailed:
      for (const CheckOutcome& check : outcome.verdicts) {
        if (check.verdict.passed) continue;
        text += fmt::format("  {}  {}   {}\n", fail_, padded, base::printable(check.text));
      }
      return text;
    case CaseOutcome::Kind::kNotRun:
      break;
  }
  return fmt::format("  {}  {}   {}\n", fail_, padded,
                     outcome.code == base::kExitNumerical ? "numerical failure, see below"
                                                          : "cannot be run, see below");
}

std::string table_totals(const SuiteTotals& totals, bool with_checks,
                         std::chrono::steady_clock::duration elapsed) {
  std::string left =
      fmt::format("  {} passed, {} failed", counted(totals.passed, "case"), totals.failed);
  if (totals.not_run > 0) left += fmt::format(", {} not run", totals.not_run);
  if (totals.no_checks > 0) left += fmt::format(", {} without checks", totals.no_checks);
  if (with_checks) left += "; " + counted(totals.checks, "check");
  return two_ends(left, terminal::elapsed_text(elapsed));
}

}  // namespace slipbench::driver::suite
