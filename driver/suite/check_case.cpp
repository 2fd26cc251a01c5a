// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/one_line.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/case/input_files.hpp"
#include "driver/check/check.hpp"
#include "driver/check/curves/read_ahead.hpp"
#include "driver/check/kept_rows.hpp"
#include "driver/check/verdict_text.hpp"
#include "driver/report/collect.hpp"
#include "driver/results/plausibility.hpp"

namespace slipbench::driver::suite {
namespace {

using Clock = std::chrono::steady_clock;

/// Ends a run from within a row.
struct GivenUp {};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

CaseOutcome failure(const std::string& path, int code, const char* kind,
                    const std::string& message) {
  CaseOutcome outcome;
  outcome.code = code;
  outcome.fault = {path, {}, base::printable(message)};
  outcome.messages =
      fmt::format("{}: {}: {}\n", base::printable(path), kind, outcome.fault.message);
  return outcome;
}

/// Returns what `work` gives; what it throws becomes an outcome.
template <class Work>
auto guarded(const std::string& path, const Work& work)
    -> tl::expected<decltype(work()), CaseOutcome> {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return tl::unexpected(
        failure(path, base::kExitEnvironment, "error", "needs more memory than there is"));
  } catch (const std::exception& error) {
    return tl::unexpected(failure(path, base::kExitInternal, "internal error", error.what()));
  }
}

/// Returns the text of a file as a page shows it: also without the sequences that colour a
/// terminal.
std::string shown_text(const base::SourceText& source) {
  std::string text = base::printable_lines(source.text());
  std::erase(text, '\033');
  return text;
}

bool can_run(const read::ReadCase& read) { return read.value && !read.diagnostics.has_errors(); }

CaseOutcome refused(const std::string& path, const read::ReadCase& read) {
  CaseOutcome outcome;
  outcome.code = read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  outcome.messages = base::render(read.diagnostics, read.sources);
  const std::vector<base::Diagnostic> all = read.diagnostics.sorted();
  const auto first = std::find_if(all.begin(), all.end(), [](const base::Diagnostic& diagnostic) {
    return diagnostic.severity == base::Severity::kError;
  });
  if (first == all.end()) {
    outcome.fault = {path, {}, "cannot be read"};
    return outcome;
  }
  outcome.fault = {first->file.empty() ? path : first->file, first->where,
                   base::printable(base::one_line(*first))};
  return outcome;
}

/// A warning as the failed check that '--strict' makes of it.
CheckOutcome failed_by(const std::string& warning, std::size_t number) {
  CheckOutcome outcome;
  outcome.verdict.name = fmt::format("warning {}", number);
  outcome.verdict.message = warning;
  outcome.text = "warning: " + warning;
  return outcome;
}

/// Tells the warnings of a case. Checks that pass have judged its numbers: what is not plausible in
/// them is told only where none do, or if warnings count.
void take_warnings(CaseOutcome& outcome, std::vector<std::string> warnings, bool strict) {
  if (!strict) {
    if (outcome.kind != CaseOutcome::Kind::kPassed) outcome.warnings = std::move(warnings);
    return;
  }
  for (const CheckOutcome& check : outcome.verdicts) {
    for (const std::string& warning : check.verdict.warnings) {
      warnings.push_back(fmt::format("check '{}': {}", check.verdict.name, warning));
    }
  }
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    outcome.verdicts.push_back(failed_by(warnings[i], i + 1));
    outcome.kind = CaseOutcome::Kind::kFailed;
    outcome.code = base::kExitCheckFailed;
    ++outcome.failed;
  }
}

CaseOutcome run_and_judge(const read::ReadCase& read, const std::string& label,
                          const CheckCaseOptions& options) {
  const cases::Case& problem = *read.value;
  const check::Trace trace = options.report ? check::Trace::kKeep : check::Trace::kNone;
  if (const std::string fault = check::memory_fault(problem, trace); !fault.empty()) {
    return failure(problem.file, base::kExitEnvironment, "error", fault);
  }
  CaseOutcome outcome;
  outcome.checks = problem.checks.size();
  std::vector<check::CheckProgress> checks;
  checks.reserve(problem.checks.size());
  for (const cases::Check& check : problem.checks) {
    checks.emplace_back(problem, check, trace);
  }
  std::optional<report::CaseCollector> collector;
  if (options.report) collector.emplace(problem, options.report_rows);
  results::Plausibility plausibility(problem);
  std::optional<check::ReadAhead> ahead;
  if (options.threads > 1) ahead.emplace(problem);
  const auto ended = bench::run_in_blocks(problem, [&](std::span<const bench::Row> rows) {
    if (options.stopped && options.stopped(rows.size())) throw GivenUp{};
    for (check::CheckProgress& check : checks) check.add(rows);
    plausibility.add(rows);
    if (!collector) return;
    for (const bench::Row& row : rows) collector->add(row);
  });
  if (!ended) {
    outcome.code = bench::exit_code(ended.error());
    outcome.messages = bench::failure_text(problem, ended.error());
    outcome.fault = {problem.file, {}, base::printable(ended.error().message)};
    return outcome;
  }
  outcome.kind = checks.empty() ? CaseOutcome::Kind::kNoChecks : CaseOutcome::Kind::kPassed;
  double worst = -1.0;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const cases::Check& check = problem.checks[i];
    check::Verdict verdict = checks[i].verdict();
    if (!verdict.passed) {
      outcome.kind = CaseOutcome::Kind::kFailed;
      outcome.code = base::kExitCheckFailed;
      ++outcome.failed;
    } else if (verdict.worst_fraction() > worst) {
      worst = verdict.worst_fraction();
      outcome.remark = check::worst_text(check, verdict);
    }
    if (!verdict.passed || !verdict.warnings.empty() || options.keep_passing) {
      std::string text = check::verdict_text(check, verdict);
      outcome.verdicts.push_back({std::move(verdict), std::move(text), check.where});
    }
  }
  std::vector<std::string> warnings = base::lines_of(read.diagnostics, base::Severity::kWarning);
  for (std::string& finding : plausibility.findings()) warnings.push_back(std::move(finding));
  take_warnings(outcome, std::move(warnings), options.strict);
  if (collector) {
    report::CaseReport report = collector->finish(base::printable(label), checks, *ended);
    report::add_remarks(report, read.diagnostics);
    if (outcome.kind == CaseOutcome::Kind::kFailed) report.status = report::ReportStatus::kFailed;
    report.run.text = shown_text(read.sources.front());
    options.report(std::move(report));
  }
  return outcome;
}

/// A case that was not run has its line on the page, too.
void report_fault(const Candidate& candidate, const Reading& reading, const CaseOutcome& outcome,
                  const CheckCaseOptions& options) {
  if (!options.report || outcome.kind != CaseOutcome::Kind::kNotRun) return;
  const bool read = reading.read && reading.read->value;
  report::CaseReport report = report::not_run_report(
      base::printable(candidate.label), read ? reading.read->value->title : "", outcome.messages);
  if (reading.read && !reading.read->sources.empty()) {
    report.run.text = shown_text(reading.read->sources.front());
  }
  options.report(std::move(report));
}

}  // namespace

std::size_t Reading::checks() const {
  return read && can_run(*read) ? read->value->checks.size() : 0;
}

std::vector<std::string> Reading::inputs() const {
  std::vector<std::string> files;
  if (!read) return files;
  if (read->value) files = cases::input_files(*read->value);
  files.insert(files.end(), read->data_files.begin(), read->data_files.end());
  for (const base::SourceText& source : read->sources) files.push_back(source.name());
  for (const base::Diagnostic& diagnostic : read->diagnostics.sorted()) {
    if (!diagnostic.file.empty()) files.push_back(diagnostic.file);
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

Reading read_candidate(const Candidate& candidate, const read::ReadOptions& options) {
  const auto start = Clock::now();
  const std::string& path = candidate.path;
  Reading reading;
  if (!candidate.fault.empty()) {
    reading.failure = failure(path, base::kExitEnvironment, "error", candidate.fault);
  } else if (auto read = guarded(path, [&] {
               read::ReadOptions own = options;
               own.standard_input = !candidate.is_searched;
               return read::read_case(path, own);
             })) {
    reading.read = std::move(*read);
  } else {
    reading.failure = std::move(read.error());
  }
  reading.seconds = seconds_since(start);
  return reading;
}

std::optional<CaseOutcome> check_case(const Candidate& candidate, const Reading& reading,
                                      const CheckCaseOptions& options) {
  const auto start = Clock::now();
  try {
    auto outcome = guarded(candidate.path, [&] {
      if (!reading.read) return reading.failure;
      if (!can_run(*reading.read)) return refused(candidate.path, *reading.read);
      return run_and_judge(*reading.read, candidate.label, options);
    });
    CaseOutcome result = outcome ? std::move(*outcome) : std::move(outcome.error());
    result.inputs = reading.inputs();
    report_fault(candidate, reading, result, options);
    result.seconds = reading.seconds + seconds_since(start);
    return result;
  } catch (const GivenUp&) {
    return std::nullopt;
  }
}

}  // namespace slipbench::driver::suite
