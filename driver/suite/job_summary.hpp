// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "driver/suite/candidates.hpp"
#include "driver/suite/outcome.hpp"
#include "driver/suite/slowest_cases.hpp"

namespace slipbench::driver::suite {

/// The text as Markdown shows it in one line of a table: nothing in it is markup.
std::string markdown_text(std::string_view text);

/// The verdicts of a suite as a page of Markdown, for the summary that GitHub Actions shows of a
/// job: how many cases went how, what did not pass and why, and the slowest cases. A flood is cut,
/// for GitHub drops a page of more than a megabyte.
class JobSummary {
 public:
  void add(const Candidate& candidate, const CaseOutcome& outcome);

  std::string text(const SuiteTotals& totals) const;

  /// Appends the text to a file that other steps of the job write to as well. \return what went
  /// wrong, in a sentence; else empty
  std::string append_to(const std::string& file, const SuiteTotals& totals) const;

 private:
  static constexpr std::size_t kMostRows = 100;
  static constexpr std::size_t kMostSlow = 5;

  void add_row(std::string_view place, std::string_view check, std::string_view message);

  std::string rows_;
  std::size_t row_count_ = 0;
  SlowestCases slowest_{kMostSlow};
};

}  // namespace slipbench::driver::suite
