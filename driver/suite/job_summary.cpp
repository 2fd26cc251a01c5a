// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/job_summary.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "driver/base/text/diagnostic.hpp"
#include "driver/results/provenance.hpp"
#include "driver/suite/verdict_table.hpp"

namespace slipbench::driver::suite {
namespace {

std::string place_of(const std::filesystem::path& file, const base::SourcePosition& where) {
  const std::string name = file.lexically_normal().string();
  return where.line > 0 ? fmt::format("{}:{}", name, where.line) : name;
}

}  // namespace

std::string markdown_text(std::string_view text) {
  constexpr std::string_view kMarkup = "\\`*_[]#|~<>&$:@";
  constexpr std::size_t kLongest = 1000;
  std::string result;
  for (const char c : base::printable(text.substr(0, kLongest))) {
    if (kMarkup.find(c) != std::string_view::npos) {
      result += fmt::format("&#{};", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result;
}

void JobSummary::add(const Candidate& candidate, const CaseOutcome& outcome) {
  slowest_.add(candidate, outcome);
  if (outcome.kind == CaseOutcome::Kind::kNotRun) {
    const CaseFault& fault = outcome.fault;
    add_row(place_of(fault.file.empty() ? candidate.path : fault.file, fault.where), "not run",
            fault.message);
  }
  for (const CheckOutcome& check : outcome.verdicts) {
    if (check.verdict.passed) continue;
    add_row(place_of(candidate.path, check.where), check.verdict.name, check.verdict.message);
  }
}

void JobSummary::add_row(std::string_view place, std::string_view check, std::string_view message) {
  if (++row_count_ > kMostRows) return;
  rows_ += fmt::format("| {} | {} | {} |\n", markdown_text(place), markdown_text(check),
                       markdown_text(message));
}

std::string JobSummary::text(const SuiteTotals& totals) const {
  std::string text =
      fmt::format("### slipbench {}: {} passed, {} failed", results::program_version(),
                  counted(totals.passed, "case"), totals.failed);
  if (totals.not_run > 0) text += fmt::format(", {} not run", totals.not_run);
  if (totals.no_checks > 0) text += fmt::format(", {} without checks", totals.no_checks);
  text += "\n\n";
  if (row_count_ > 0) text += "| place | check | message |\n|---|---|---|\n" + rows_ + "\n";
  if (row_count_ > kMostRows) text += fmt::format("... and {} more\n\n", row_count_ - kMostRows);
  text += "| slowest | time |\n|---|---|\n";
  for (const SlowestCases::Entry& entry : slowest_.entries()) {
    text += fmt::format("| {} | {} |\n", markdown_text(entry.label), seconds_text(entry.seconds));
  }
  return text + "\n";
}

std::string JobSummary::append_to(const std::string& file, const SuiteTotals& totals) const {
  errno = 0;
  std::ofstream out(file, std::ios::app | std::ios::binary);
  out << text(totals) << std::flush;
  if (out) return {};
  return fmt::format("the summary of the job is not written to {}: {}", base::printable(file),
                     std::generic_category().message(errno == 0 ? EIO : errno));
}

}  // namespace slipbench::driver::suite
