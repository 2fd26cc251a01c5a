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

#include "driver/base/files/output_file.hpp"
#include "driver/report/case_report.hpp"
#include "driver/report/live_bench.hpp"

namespace slipbench::driver::report {

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
/// A case may be put in anew, as one that was not run after all: then all behind it must be, too.
class ReportCollection {
 public:
  /// \param count how many cases will come, at the places 0 .. count - 1
  explicit ReportCollection(std::size_t count) : cases_(count) {}

  /// Puts the case of one place in. Safe for threads.
  void put(std::size_t place, CaseReport report);

  /// The cases in the order of their places; for one thread, once all are there.
  std::span<const CaseReport> cases() const;
  ReportTotals totals() const;

  static constexpr std::size_t kMostDetailed = 200;

 private:
  /// Drops the details of the last ones until only `most` have them.
  void keep_first(std::set<std::size_t>& places, std::size_t most) const;

  // As long as cases may still be put in anew, as many of either kind keep their details as may be
  // needed; a reader gets the final choice.
  mutable std::mutex mutex_;
  mutable std::vector<CaseReport> cases_;
  mutable std::set<std::size_t> failed_;  ///< places with details
  mutable std::set<std::size_t> others_;
};

/// The JSON document of the page, on one line, to be embedded as it is in a script element: no '<'
/// stands in it. Numbers have as many digits as tell neighbouring rows apart, those that stand
/// alone ten; what is no finite number is null. The same cases give the same bytes.
std::string report_document(const ReportCollection& collection, const std::string& title);

/// Writes the page as one file that appears only when it is complete. An empty title becomes
/// "slipbench report". Returns its size in bytes.
/// \param bench runs the cases in the page; null for a page to look at
/// \param with what appears together with it, or not at all
/// Errors: those of OutputFile.
tl::expected<std::size_t, std::string> write_report(const std::filesystem::path& file,
                                                    const ReportCollection& collection,
                                                    const std::string& title,
                                                    const base::Overwriting& overwriting,
                                                    const LiveBench* bench = nullptr,
                                                    std::span<base::OutputFile* const> with = {});

/// "0.8 MB", "12 kB": the size of a page for people.
std::string size_text(std::size_t bytes);

}  // namespace slipbench::driver::report
