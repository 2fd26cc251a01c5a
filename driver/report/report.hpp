// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/report/case_report.hpp"

namespace slipbench::driver {

struct ReportTotals {
  std::size_t cases = 0;
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t not_run = 0;
  std::size_t no_checks = 0;
  std::size_t checks = 0;
};

/// The cases of a page, put in from any thread in any order. Of the many cases of a suite, the
/// first kMostDetailed keep their curves, those that failed before all others; the rest are lines
/// of the table of verdicts. What is kept does not depend on the order in which they come.
class ReportCollection {
 public:
  /// \param count how many cases will come, at the places 0 .. count - 1
  explicit ReportCollection(std::size_t count) : cases_(count) {}

  /// Puts the case of one place in. Safe for threads.
  void put(std::size_t place, CaseReport report);

  /// The cases in the order of their places; for one thread, once all are there.
  std::span<const CaseReport> cases() const { return cases_; }
  ReportTotals totals() const;

  static constexpr std::size_t kMostDetailed = 200;

 private:
  std::mutex mutex_;
  std::vector<CaseReport> cases_;
  /// Who has details: (0 failed, 1 others) and the place, so that the last one goes first.
  std::set<std::pair<int, std::size_t>> detailed_;
};

/// The JSON document of the page, on one line, to be embedded as it is in a script element: no '<'
/// stands in it. Numbers have six significant digits; what is no finite number is null. The same
/// cases give the same bytes.
std::string report_document(const ReportCollection& collection, const std::string& title);

/// Writes the page as one file that appears only when it is complete. An empty title becomes
/// "slipbench report". Returns its size in bytes.
/// Errors: those of OutputFile, also for a file that is one of `inputs`.
tl::expected<std::size_t, std::string> write_report(const std::filesystem::path& file,
                                                    const ReportCollection& collection,
                                                    const std::string& title,
                                                    std::span<const std::string> inputs);

/// "0.8 MB", "12 kB": the size of a page for people.
std::string size_text(std::size_t bytes);

}  // namespace slipbench::driver
