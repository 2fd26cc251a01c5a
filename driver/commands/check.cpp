// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/work_crew.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/report/collect.hpp"
#include "driver/report/report.hpp"
#include "driver/suite/annotations.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/job_summary.hpp"
#include "driver/suite/junit.hpp"
#include "driver/suite/label_filter.hpp"
#include "driver/suite/last_failed.hpp"
#include "driver/suite/run_suite.hpp"
#include "driver/suite/slowest_cases.hpp"
#include "driver/suite/suite_files.hpp"
#include "driver/suite/suite_json.hpp"
#include "driver/suite/trailing_notes.hpp"
#include "driver/suite/verdict_table.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver {
namespace {

std::string nothing_matches(const CheckOptions& options, std::size_t count) {
  std::vector<std::string> quoted;
  for (const std::string& filter : options.filters) quoted.push_back("'" + filter + "'");
  const std::vector<std::string_view> words(quoted.begin(), quoted.end());
  return fmt::format("no case matches --filter {}; {}", in_words(words),
                     count == 1 ? "there is 1 case" : fmt::format("there are {} cases", count));
}

/// The file that a job of GitHub Actions shows at its end; empty elsewhere.
std::string job_summary_file() {
  const char* file = std::getenv("GITHUB_STEP_SUMMARY");
  return file == nullptr ? "" : file;
}

std::string github_root() {
  const char* root = std::getenv("GITHUB_WORKSPACE");
  return root == nullptr ? "" : root;
}

/// The cases to run, in the order of the suite.
std::vector<Candidate> chosen(const CheckOptions& options, const std::vector<Candidate>& all) {
  std::vector<Candidate> cases;
  std::copy_if(all.begin(), all.end(), std::back_inserter(cases),
               [&](const Candidate& c) { return label_matches_any(c.label, options.filters); });
  return cases;
}

/// The cases in another order.
std::vector<Candidate> reordered(const std::vector<Candidate>& cases,
                                 const std::vector<std::size_t>& order) {
  std::vector<Candidate> result;
  for (const std::size_t place : order) result.push_back(cases[place]);
  return result;
}

/// All that are told how the cases went.
struct Told {
  SuiteTotals totals;
  TrailingNotes notes;
  std::optional<JunitReport> junit;
  std::optional<SuiteJson> json;
  std::optional<Annotations> annotations;
  std::optional<JobSummary> summary;
  SlowestCases slowest{0};
  std::optional<LastFailed> memory;
  std::size_t cases = 0;
  std::string overwritten;  ///< which input a file of verdicts would replace, in a sentence

  /// \param place of the case in the suite
  void add(std::size_t place, const Candidate& candidate, const CaseOutcome& outcome) {
    ++cases;
    totals.add(outcome);
    notes.add(candidate, outcome);
    if (junit) junit->add(place, candidate, outcome);
    if (json) json->add(place, candidate, outcome);
    if (annotations) annotations->add(candidate, outcome);
    if (summary) summary->add(candidate, outcome);
    slowest.add(candidate, outcome);
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
    return worse(search_code,
                 refuse(kExitBadInput, "no case (*.yaml, *.yml) found; nothing was checked"));
  }
  Told told;
  if (found.cases.size() > 1) told.memory.emplace(options.paths);
  const std::vector<Candidate> in_order = chosen(options, found.cases);
  if (in_order.empty()) return refuse(kExitBadInput, nothing_matches(options, found.cases.size()));
  std::vector<std::size_t> places(in_order.size());  // in the suite, of the cases as they are run
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (options.failed_first && told.memory) places = told.memory->order(in_order);
  const std::vector<Candidate> cases = reordered(in_order, places);
  const SuiteTargets targets{options.junit, options.json, options.report, options.force};
  auto files = SuiteFiles::create(targets, found.cases);
  if (!files) return refuse(files.error().code, files.error().message);

  if (!options.junit.empty()) told.junit.emplace();
  if (!options.json.empty()) told.json.emplace();
  if (in_github_actions()) told.annotations.emplace(github_root());
  if (!job_summary_file().empty()) told.summary.emplace();
  if (options.durations) {
    told.slowest = SlowestCases(
        *options.durations > 0 ? static_cast<std::size_t>(*options.durations) : cases.size());
  }
  std::optional<ReportCollection> pages;
  if (!options.report.empty()) pages.emplace(cases.size());

  SuiteOptions suite;
  suite.read = {*settings, options.allow_outside};
  suite.threads = options.jobs > 0 ? static_cast<unsigned>(options.jobs) : core_count();
  suite.fail_fast = options.fail_fast;
  suite.keep_passing = told.junit || told.json;
  suite.strict = options.strict;
  if (pages) {
    suite.report = [&](std::size_t i, CaseReport&& page) { pages->put(i, std::move(page)); };
  }
  std::vector<Reading> readings;
  std::optional<std::size_t> checks;
  if (cases.size() <= kReadAhead) {
    readings = read_suite(cases, suite);
    checks = 0;
    for (const Reading& reading : readings) {
      *checks += reading.checks();
      if (const std::string fault = overwritten_input(targets, reading.inputs()); !fault.empty()) {
        return refuse(kExitEnvironment, fault);
      }
    }
  }
  print(table_head(cases.size(), checks,
                   counted(suite.threads, options.jobs > 0 ? "thread" : "core")));
  flush_output();

  const VerdictTable table(cases, options.quiet, colour_wanted(STDOUT_FILENO));
  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  Progress progress("cases");
  SuiteListener listener;
  listener.tell = [&](const Candidate& candidate, CaseOutcome&& outcome) {
    told.add(places[static_cast<std::size_t>(&candidate - cases.data())], candidate, outcome);
    if (told.overwritten.empty() && !checks) {
      told.overwritten = overwritten_input(targets, outcome.inputs);
    }
    const std::string lines = table.lines(candidate, outcome);
    if (lines.empty()) return;
    if (on_terminal) progress.hide();
    print(told.annotations ? without_commands(lines) : lines);
    flush_output();
  };
  listener.progress = [&](const WorkDone& work) { progress.step(work); };
  run_suite(cases, std::move(readings), suite, listener);
  progress.hide();

  const std::size_t not_reached = cases.size() - told.cases;
  told.totals.not_run += not_reached;
  print(table_totals(told.totals, !checks, std::chrono::steady_clock::now() - start));
  print(told.slowest.text());
  print_error(told.annotations ? without_commands(told.notes.text()) : told.notes.text());
  if (told.annotations) print(told.annotations->text());
  if (told.summary) {
    const std::string fault = told.summary->append_to(job_summary_file(), told.totals);
    if (!fault.empty()) print_error("slipbench: warning: " + fault + "\n");
  }
  if (told.memory) told.memory->write(found.cases);
  int code = worse(told.totals.code, search_code);
  if (!told.overwritten.empty()) return worse(code, refuse(kExitEnvironment, told.overwritten));
  if (told.junit) files->junit->append(told.junit->text());
  if (told.json) files->json->append(told.json->text(told.totals));
  for (const std::string& fault : files->complete()) {
    code = worse(code, refuse(kExitEnvironment, fault));
  }
  if (pages) {
    for (std::size_t i = told.cases; i < cases.size(); ++i) {
      pages->put(i, not_run_report(cases[i].label, "", "not run: an earlier case did not pass"));
    }
    // That the page replaces nothing that was read was made sure of above.
    const auto size = write_report(options.report, *pages, "", {.force = options.force});
    if (!size) code = worse(code, refuse(kExitEnvironment, size.error()));
  }
  return code;
}

}  // namespace slipbench::driver
