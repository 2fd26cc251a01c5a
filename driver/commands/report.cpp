// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/files/real_files.hpp"
#include "driver/base/files/work_crew.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/read/read_case.hpp"
#include "driver/report/page.hpp"
#include "driver/report/read_result.hpp"
#include "driver/report/report.hpp"
#include "driver/suite/candidates.hpp"
#include "driver/suite/check_case.hpp"
#include "driver/suite/run_suite.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// Source of one place of the page.
struct Source {
  suite::Candidate candidate;
  bool is_result = false;
};

bool names_result(const std::string& path) {
  std::error_code ignored;
  return fs::path(path).extension() == ".csv" && !fs::is_directory(path, ignored);
}

/// Results as they are given, cases as `check` finds them, in the order of the command line.
std::vector<Source> find_sources(std::span<const std::string> inputs, bool allow_outside) {
  std::vector<Source> sources;
  const auto add_cases = [&](std::span<const std::string> paths) {
    for (suite::Candidate& candidate : suite::find_candidates(paths, allow_outside))
      sources.push_back({std::move(candidate), false});
  };
  base::RealFiles real_files;
  std::set<std::string> results;   // a result counts once
  std::vector<std::string> cases;  // neighbours are searched together: a case counts once
  for (const std::string& input : inputs) {
    if (!names_result(input)) {
      cases.push_back(input);
      continue;
    }
    if (!results.insert(real_files.of(input)).second) continue;
    add_cases(cases);
    cases.clear();
    const fs::path path = fs::path(input).lexically_normal();
    sources.push_back({{input, (path.parent_path() / path.stem()).generic_string()}, true});
  }
  add_cases(cases);
  return sources;
}

/// The files that are read, as far as they are known before the cases are: of a result also those
/// beside it.
std::vector<std::string> known_inputs(std::span<const Source> sources) {
  std::vector<std::string> inputs;
  for (const Source& source : sources) {
    const std::string& path = source.candidate.path;
    inputs.push_back(path);
    if (!source.is_result) continue;
    for (const char* extension : {".json", ".events.csv"}) {
      inputs.push_back(fs::path(path).replace_extension(extension).string());
    }
  }
  return inputs;
}

std::string first_of(std::span<const std::string> faults) {
  const auto first = std::find_if(faults.begin(), faults.end(),
                                  [](const std::string& fault) { return !fault.empty(); });
  return first == faults.end() ? "" : *first;
}

/// The page's title where none is given: the only input's name, or nothing.
std::string title_of(std::span<const std::string> inputs) {
  if (inputs.size() == 1) {
    const fs::path path = fs::path(inputs.front()).lexically_normal();
    std::string last =
        path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
    if (!last.empty() && last != "." && last != "..") return last;
  }
  return {};
}

}  // namespace

int report_command(const ReportOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  if (options.output == "-")
    return terminal::refuse(base::kExitBadInput, "-o -: wanted the name of a file");
  const std::vector<Source> sources = find_sources(options.inputs, options.allow_outside);
  if (sources.empty()) {
    return terminal::refuse(base::kExitBadInput,
                            "no case (*.yaml, *.yml) found; there is nothing to report");
  }
  std::optional<report::LiveBench> bench;
  if (options.live) {
    auto found = report::read_live_bench();
    if (!found) return terminal::refuse(base::kExitEnvironment, "--live: " + found.error());
    bench.emplace(std::move(*found));
  }
  // Before the work: a page that cannot be written is known at once.
  const std::vector<std::string> inputs = known_inputs(sources);
  const base::Overwriting overwriting{inputs, options.force};
  if (const auto page =
          base::OutputFile::create(options.output, report::report_page_mark(), overwriting);
      !page) {
    return terminal::refuse(base::kExitEnvironment, page.error());
  }
  const read::ReadOptions read_options{*settings, options.allow_outside};
  const unsigned threads = base::core_count();
  std::vector<suite::Reading> readings(sources.size());
  std::vector<std::string> overwritten(sources.size());
  const auto read = [&](std::size_t place) {
    readings[place] = suite::read_candidate(sources[place].candidate, read_options);
    overwritten[place] = base::input_fault(options.output, readings[place].inputs());
  };
  const bool ahead = sources.size() <= suite::kReadAhead;
  if (ahead) {
    terminal::SharedProgress progress("cases read", sources.size());
    base::for_each_index(sources.size(), threads, [&](std::size_t place) {
      if (!sources[place].is_result) read(place);
      progress.done();
    });
  }
  if (const std::string fault = first_of(overwritten); !fault.empty()) {
    return terminal::refuse(base::kExitEnvironment, fault);
  }

  report::ReportCollection collection(sources.size());
  std::vector<int> codes(sources.size(), base::kExitOk);
  std::vector<std::string> messages(sources.size());
  std::vector<std::vector<std::string>> data_files(sources.size());
  {
    terminal::SharedProgress progress("cases", sources.size());
    base::for_each_index(sources.size(), threads, [&](std::size_t place) {
      const auto& [candidate, is_result] = sources[place];
      if (is_result) {
        report::ReadResult result =
            report::read_result(candidate.path, candidate.label, report::most_rows(sources.size()));
        codes[place] = result.code;
        messages[place] = result.report.message;
        collection.put(place, std::move(result.report));
        progress.done(codes[place] == base::kExitOk);
        return;
      }
      if (!ahead) read(place);
      const suite::Reading reading = std::exchange(readings[place], suite::Reading{});
      if (bench && reading.read) data_files[place] = reading.read->data_files;
      suite::CheckCaseOptions check_options;
      check_options.stopped = [&](std::size_t rows) {
        progress.tick(rows);
        return false;
      };
      check_options.report_rows = report::most_rows(sources.size());
      check_options.report = [&](report::CaseReport&& report) {
        collection.put(place, std::move(report));
      };
      const auto outcome = suite::check_case(candidate, reading, check_options);
      // A failed check is the page's matter, not this command's.
      codes[place] = outcome->code == base::kExitCheckFailed ? base::kExitOk : outcome->code;
      messages[place] = outcome->messages;
      progress.done(outcome->well());
    });
  }
  if (const std::string fault = first_of(overwritten); !fault.empty()) {
    return terminal::refuse(base::kExitEnvironment, fault);
  }

  const std::string title = options.title.empty() ? title_of(options.inputs) : options.title;
  for (std::size_t place = 0; bench && place < sources.size(); ++place) {
    bench->files.push_back(report::file_texts(sources[place].candidate.path, data_files[place]));
  }
  const auto size = report::write_report(options.output, collection, title, overwriting,
                                         bench ? &*bench : nullptr);
  if (!size) return terminal::refuse(base::kExitEnvironment, size.error());
  for (const std::string& message : messages) terminal::print_error(message);
  const report::ReportTotals totals = collection.totals();
  std::string line = fmt::format("{}: {} case{}, {} failed", options.output, totals.cases,
                                 totals.cases == 1 ? "" : "s", totals.failed);
  if (totals.not_run > 0) line += fmt::format(", {} not run", totals.not_run);
  terminal::print(line + ", " + report::size_text(*size) + "\n");
  // With nothing to look at, the reason counts; otherwise the page is what was asked for.
  if (totals.not_run < totals.cases) {
    const bool missed = std::any_of(sources.begin(), sources.end(), [](const Source& source) {
      return !source.candidate.fault.empty();
    });
    return missed ? base::kExitEnvironment : base::kExitOk;
  }
  int code = base::kExitOk;
  for (const int one : codes) code = base::worse(code, one);
  return code;
}

}  // namespace slipbench::driver::commands
