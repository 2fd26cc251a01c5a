// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
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

namespace slipbench::driver::commands {
namespace {

/// Names the filters that match no case, in a sentence; empty if each has one, or where a fault may
/// hide it.
std::string nothing_matches(const CheckOptions& options, std::span<const suite::Candidate> all) {
  std::vector<std::string> quoted;
  for (const std::string& filter : options.filters) {
    const auto may_match = [&](const suite::Candidate& one) {
      return !one.fault.empty() || suite::label_matches_any(one.label, std::span(&filter, 1));
    };
    if (std::ranges::none_of(all, may_match)) quoted.push_back("'" + filter + "'");
  }
  if (quoted.empty()) return {};
  const std::vector<std::string_view> words(quoted.begin(), quoted.end());
  return fmt::format(
      "no case matches --filter {}; {}", base::in_words(words),
      all.size() == 1 ? "there is 1 case" : fmt::format("there are {} cases", all.size()));
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

/// The cases to run, in the order of the suite. One with a fault, such as a folder that cannot be
/// searched, may hide some that are wanted.
std::vector<suite::Candidate> chosen(const CheckOptions& options,
                                     const std::vector<suite::Candidate>& all) {
  std::vector<suite::Candidate> cases;
  std::copy_if(all.begin(), all.end(), std::back_inserter(cases), [&](const suite::Candidate& c) {
    std::error_code unknown;
    const bool is_missing = !c.is_searched && !std::filesystem::exists(c.path, unknown);
    return !c.fault.empty() || is_missing || suite::label_matches_any(c.label, options.filters);
  });
  return cases;
}

/// The cases in another order.
std::vector<suite::Candidate> reordered(const std::vector<suite::Candidate>& cases,
                                        const std::vector<std::size_t>& order) {
  std::vector<suite::Candidate> result;
  result.reserve(order.size());
  for (const std::size_t place : order) result.push_back(cases[place]);
  return result;
}

constexpr const char* kNotReached = "not run: an earlier case did not pass";

/// All outputs of how the cases went.
struct Told {
  suite::SuiteTotals totals;
  suite::TrailingNotes notes;
  std::optional<suite::JunitReport> junit;
  std::optional<suite::SuiteJson> json;
  std::optional<suite::Annotations> annotations;
  std::optional<suite::JobSummary> summary;
  suite::SlowestCases slowest{0};
  std::optional<suite::LastFailed> memory;
  std::size_t cases = 0;
  std::string overwritten;  ///< which input a file of verdicts would replace, in a sentence

  /// \param place of the case in the suite
  void add(std::size_t place, const suite::Candidate& candidate,
           const suite::CaseOutcome& outcome) {
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

  /// Puts a case that was not reached into the files of verdicts.
  void add_unreached(std::size_t place, const suite::Candidate& candidate) {
    suite::CaseOutcome outcome;
    outcome.fault = {candidate.path, {}, kNotReached};
    if (junit) junit->add(place, candidate, outcome);
    if (json) json->add(place, candidate, outcome);
  }

  /// Tells a fault of the suite that is that of none of its cases.
  void add_fault(const std::string& path, const std::string& message) {
    const suite::Candidate all{path, path};
    suite::CaseOutcome outcome;
    outcome.code = base::kExitCheckFailed;
    outcome.fault = {path, {}, message};
    outcome.messages = message + "\n";
    if (junit) junit->add(cases, all, outcome);
    if (annotations) annotations->add(all, outcome);
    if (summary) summary->add(all, outcome);
    totals.code = base::worse(totals.code, outcome.code);
  }
};

}  // namespace

int check_command(const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  const std::vector<suite::Candidate> found =
      suite::find_candidates(options.paths, options.allow_outside);
  if (found.empty()) {
    return terminal::refuse(base::kExitBadInput,
                            "no case (*.yaml, *.yml) found; nothing was checked");
  }
  Told told;
  if (found.size() > 1) told.memory.emplace(options.paths);
  const std::vector<suite::Candidate> in_order = chosen(options, found);
  if (const std::string fault = nothing_matches(options, found); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  std::vector<std::size_t> places(in_order.size());  // in the suite, of the cases as they are run
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (options.failed_first && told.memory) places = told.memory->order(in_order);
  const std::vector<suite::Candidate> cases = reordered(in_order, places);
  const suite::SuiteTargets targets{options.junit, options.json, options.report, options.force};
  auto files = suite::SuiteFiles::create(targets, found);
  if (!files) return terminal::refuse(files.error().code, files.error().message);

  if (!options.junit.empty()) told.junit.emplace();
  if (!options.json.empty()) told.json.emplace();
  if (suite::in_github_actions()) told.annotations.emplace(github_root());
  if (!job_summary_file().empty()) told.summary.emplace();
  if (options.durations) {
    told.slowest = suite::SlowestCases(
        *options.durations > 0 ? static_cast<std::size_t>(*options.durations) : cases.size());
  }
  std::optional<report::ReportCollection> pages;
  if (!options.report.empty()) pages.emplace(cases.size());

  suite::SuiteOptions suite;
  suite.read = {*settings, options.allow_outside};
  suite.threads = options.jobs > 0 ? static_cast<unsigned>(options.jobs) : base::core_count();
  suite.fail_fast = options.fail_fast;
  suite.keep_passing = told.junit || told.json;
  suite.strict = options.strict;
  if (pages) {
    suite.report = [&](std::size_t i, report::CaseReport&& page) {
      pages->put(i, std::move(page));
    };
  }
  std::vector<suite::Reading> readings;
  std::optional<std::size_t> checks;
  if (cases.size() <= suite::kReadAhead) {
    readings = suite::read_suite(cases, suite);
    checks = 0;
    for (const suite::Reading& reading : readings) {
      *checks += reading.checks();
      if (const std::string fault = suite::overwritten_input(targets, reading.inputs());
          !fault.empty()) {
        return terminal::refuse(base::kExitEnvironment, fault);
      }
    }
  }
  terminal::print(suite::table_head(
      cases.size(), checks, suite::counted(suite.threads, options.jobs > 0 ? "thread" : "core")));
  terminal::flush_output();

  const suite::VerdictTable table(cases, options.quiet, terminal::colour_wanted(STDOUT_FILENO));
  const bool on_terminal = isatty(STDOUT_FILENO) == 1;
  terminal::Progress progress("cases");
  suite::SuiteListener listener;
  listener.tell = [&](const suite::Candidate& candidate, suite::CaseOutcome&& outcome) {
    told.add(places[static_cast<std::size_t>(&candidate - cases.data())], candidate, outcome);
    if (told.overwritten.empty() && !checks) {
      told.overwritten = suite::overwritten_input(targets, outcome.inputs);
    }
    const std::string lines = table.lines(candidate, outcome);
    if (lines.empty()) return;
    if (on_terminal) progress.hide();
    terminal::print(told.annotations ? suite::without_commands(lines) : lines);
    terminal::flush_output();
  };
  listener.progress = [&](const terminal::WorkDone& work) { progress.step(work); };
  suite::run_suite(cases, std::move(readings), suite, listener);
  progress.hide();

  const std::size_t not_reached = cases.size() - told.cases;
  told.totals.not_run += not_reached;
  for (std::size_t i = told.cases; i < cases.size(); ++i) told.add_unreached(places[i], cases[i]);
  const bool nothing_judged = told.totals.checks == 0 && told.totals.no_checks > 0;
  constexpr const char* kNothingJudged = "no case has a check; nothing was judged";
  if (nothing_judged && options.strict) told.add_fault(options.paths.front(), kNothingJudged);
  terminal::print(
      suite::table_totals(told.totals, !checks, std::chrono::steady_clock::now() - start));
  terminal::print(told.slowest.text());
  terminal::print_error(told.annotations ? suite::without_commands(told.notes.text())
                                         : told.notes.text());
  if (told.annotations) terminal::print(told.annotations->text());
  if (told.summary) {
    const std::string fault = told.summary->append_to(job_summary_file(), told.totals);
    if (!fault.empty()) terminal::print_error("slipbench: warning: " + fault + "\n");
  }
  if (told.memory) told.memory->write(found);
  int& code = told.totals.code;
  if (nothing_judged) {
    terminal::print_error(
        fmt::format("slipbench: {}: {}\n", options.strict ? "error" : "warning", kNothingJudged));
  }
  if (!told.overwritten.empty())
    return base::worse(code, terminal::refuse(base::kExitEnvironment, told.overwritten));
  if (told.junit) files->junit->append(told.junit->text());
  if (told.json) {
    told.json->write(told.totals, [&](std::string_view text) { files->json->append(text); });
  }
  bool complete = false;
  if (pages) {
    for (std::size_t i = told.cases; i < cases.size(); ++i) {
      pages->put(i, report::not_run_report(cases[i].label, "", kNotReached));
    }
    // That the page replaces nothing that was read was made sure of above.
    const auto size = report::write_report(options.report, *pages, "", {.force = options.force},
                                           nullptr, files->all());
    complete = size.has_value();
    if (!size) code = base::worse(code, terminal::refuse(base::kExitEnvironment, size.error()));
  }
  // Verdicts do not hang on the page.
  if (!complete) {
    if (const auto written = base::commit(files->all()); !written) {
      code = base::worse(code, terminal::refuse(base::kExitEnvironment, written.error()));
    }
  }
  return code;
}

}  // namespace slipbench::driver::commands
