// SPDX-License-Identifier: Apache-2.0
#include "driver/report/report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "driver/base/files/output_file.hpp"
#include "driver/report/page.hpp"

namespace slipbench::driver::report {

void ReportCollection::put(std::size_t place, CaseReport report) {
  const std::scoped_lock lock(mutex_);
  failed_.erase(place);
  others_.erase(place);
  cases_[place] = std::move(report);
  if (cases_[place].status == ReportStatus::kNotRun) return;
  std::set<std::size_t>& kind = cases_[place].status == ReportStatus::kFailed ? failed_ : others_;
  kind.insert(place);
  keep_first(kind, kMostDetailed);
}

void ReportCollection::keep_first(std::set<std::size_t>& places, std::size_t most) const {
  while (places.size() > most) {
    const auto last = std::prev(places.end());
    cases_[*last].drop_details();
    places.erase(last);
  }
}

std::span<const CaseReport> ReportCollection::cases() const {
  const std::scoped_lock lock(mutex_);
  keep_first(others_, kMostDetailed - failed_.size());
  return cases_;
}

ReportTotals ReportCollection::totals() const {
  ReportTotals totals;
  for (const CaseReport& one : cases_) {
    ++totals.cases;
    totals.checks += one.checks.size();
    switch (one.status) {
      case ReportStatus::kPassed:
        ++totals.passed;
        break;
      case ReportStatus::kFailed:
        ++totals.failed;
        break;
      case ReportStatus::kNoChecks:
        ++totals.no_checks;
        break;
      case ReportStatus::kNotRun:
        ++totals.not_run;
        break;
    }
  }
  return totals;
}

tl::expected<std::size_t, std::string> write_report(const std::filesystem::path& file,
                                                    const ReportCollection& collection,
                                                    const std::string& title,
                                                    const base::Overwriting& overwriting,
                                                    const LiveBench* bench,
                                                    std::span<base::OutputFile* const> with) {
  auto out = base::OutputFile::create(file, report_page_mark(), overwriting);
  if (!out) return tl::unexpected(out.error());
  const std::string shown = title.empty() ? "slipbench report" : title;
  const std::string page = report_page(report_document(collection, shown), shown, bench);
  out->append(page);
  std::vector<base::OutputFile*> together(with.begin(), with.end());
  together.push_back(&*out);
  if (auto committed = base::commit(together); !committed) return tl::unexpected(committed.error());
  return page.size();
}

std::string size_text(std::size_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 99.5e3) return fmt::format("{:.0f} kB", 1e-3 * size);
  return fmt::format("{:.1f} MB", 1e-6 * size);
}

}  // namespace slipbench::driver::report
