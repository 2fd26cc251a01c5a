// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "driver/commands/shared.hpp"
#include "driver/report/collect.hpp"
#include "driver/report/report.hpp"
#include "driver/suite/annotations.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/junit.hpp"
#include "driver/suite/label_filter.hpp"
#include "driver/suite/last_failed.hpp"
#include "driver/suite/run_suite.hpp"
#include "driver/suite/suite_files.hpp"
#include "driver/suite/suite_json.hpp"
#include "driver/suite/trailing_notes.hpp"
#include "driver/suite/verdict_table.hpp"

namespace slipbench::driver {
namespace {

/// Up to so many cases are all read before the first one is run, so that the head of the table can
/// say how many checks there are. More are read as their turn comes, which takes no memory.
constexpr std::size_t kReadAhead = 1000;

int refuse(int code, const std::string& message) {
  print_error("slipbench: error: " + message + "\n");
  return code;
}

std::string nothing_matches(const CheckOptions& options, std::size_t count) {
  std::vector<std::string> quoted;
  for (const std::string& filter : options.filters) quoted.push_back("'" + filter + "'");
  const std::vector<std::string_view> words(quoted.begin(), quoted.end());
  return fmt::format("no case matches --filter {}; {}", in_words(words),
                     count == 1 ? "there is 1 case" : fmt::format("there are {} cases", count));
}

std::string github_root() {
  const char* root = std::getenv("GITHUB_WORKSPACE");
  return root == nullptr ? "" : root;
}

/// The cases to run, in their order.
std::vector<Candidate> chosen(const CheckOptions& options, const std::vector<Candidate>& all,
                              const std::optional<LastFailed>& memory) {
  std::vector<Candidate> cases;
  std::copy_if(all.begin(), all.end(), std::back_inserter(cases),
               [&](const Candidate& c) { return label_matches_any(c.label, options.filters); });
  if (memory) memory->order(cases);
  return cases;
}

/// Everybody who wants to know how the cases went.
struct Told {
  SuiteTotals totals;
  TrailingNotes notes;
  std::optional<JunitReport> junit;
  std::optional<SuiteJson> json;
  std::optional<Annotations> annotations;
  std::optional<LastFailed> memory;
  std::size_t cases = 0;

  void add(const Candidate& candidate, const CaseOutcome& outcome) {
    ++cases;
    totals.add(outcome);
    notes.add(candidate, outcome);
    if (junit) junit->add(candidate, outcome);
    if (json) json->add(candidate, outcome);
    if (annotations) annotations->add(candidate, outcome);
    if (memory) memory->note(candidate, outcome.well());
  }
};

}  // namespace

int check_command(const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto settings = parse_settings(options.settings);
  if (!settings) return refuse(kExitBadInput, settings.error());
  const Candidates found = find_candidates(options.paths);
  for (const std::string& fault : found.faults) refuse(kExitEnvironment, fault);
  const int search_code = found.faults.empty() ? kExitOk : kExitEnvironment;
  if (found.cases.empty()) {
    return worse(search_code, refuse(kExitBadInput, "no case (*.yaml) found; nothing was checked"));
  }
  Told told;
  if (options.failed_first) told.memory.emplace(options.paths);
  const std::vector<Candidate> cases = chosen(options, found.cases, told.memory);
  if (cases.empty()) return refuse(kExitBadInput, nothing_matches(options, found.cases.size()));
  auto files = SuiteFiles::create({options.junit, options.json, options.report}, found.cases);
  if (!files) return refuse(files.error().code, files.error().message);

  if (!options.junit.empty()) told.junit.emplace();
  if (!options.json.empty()) told.json.emplace();
  if (in_github_actions()) told.annotations.emplace(github_root());
  std::optional<ReportCollection> pages;
  if (!options.report.empty()) pages.emplace(cases.size());

  SuiteOptions suite;
  suite.read = {*settings, options.allow_outside};
  suite.threads = options.jobs > 0 ? static_cast<unsigned>(options.jobs)
                                   : std::max(1U, std::thread::hardware_concurrency());
  suite.fail_fast = options.fail_fast;
  suite.keep_passing = told.junit || told.json;
  if (pages) {
    suite.report = [&](std::size_t i, CaseReport&& page) { pages->put(i, std::move(page)); };
  }
  std::vector<Reading> readings;
  std::optional<std::size_t> checks;
  if (cases.size() <= kReadAhead) {
    readings = read_suite(cases, suite);
    checks = 0;
    for (const Reading& reading : readings) *checks += reading.checks();
  }
  print(table_head(cases.size(), checks,
                   counted(suite.threads, options.jobs > 0 ? "thread" : "core")));
  std::fflush(stdout);

  const VerdictTable table(cases, options.quiet, colour_wanted(STDOUT_FILENO));
  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  Progress progress("cases");
  SuiteListener listener;
  listener.tell = [&](const Candidate& candidate, CaseOutcome&& outcome) {
    told.add(candidate, outcome);
    const std::string lines = table.lines(candidate, outcome);
    if (lines.empty()) return;
    if (on_terminal) progress.hide();
    print(lines);
    std::fflush(stdout);
  };
  listener.progress = [&](const WorkDone& work) { progress.step(work); };
  run_suite(cases, std::move(readings), suite, listener);
  progress.hide();

  const std::size_t not_reached = cases.size() - told.cases;
  told.totals.not_run += not_reached;
  print(table_totals(told.totals, !checks, std::chrono::steady_clock::now() - start));
  print_error(told.notes.text());
  if (told.annotations) print(told.annotations->text());
  if (told.memory) told.memory->write(found.cases);
  if (told.junit) files->junit->append(told.junit->text());
  if (told.json) files->json->append(told.json->text(told.totals));
  int code = worse(told.totals.code, search_code);
  for (const std::string& fault : files->complete()) {
    code = worse(code, refuse(kExitEnvironment, fault));
  }
  if (pages) {
    for (std::size_t i = told.cases; i < cases.size(); ++i) {
      pages->put(i, not_run_report(cases[i].label, "", "not run: an earlier case did not pass"));
    }
    // That the page is none of the cases was made sure of above.
    const auto size = write_report(options.report, *pages, "", {});
    if (!size) code = worse(code, refuse(kExitEnvironment, size.error()));
  }
  return code;
}

}  // namespace slipbench::driver
