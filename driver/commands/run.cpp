// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "driver/analysis/compare_integration.hpp"
#include "driver/analysis/converge.hpp"
#include "driver/analysis/explain.hpp"
#include "driver/analysis/solver_report.hpp"
#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/json.hpp"
#include "driver/base/text/one_line.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/base/units/parameters.hpp"
#include "driver/bench/run_case.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/case/input_files.hpp"
#include "driver/check/check.hpp"
#include "driver/check/kept_rows.hpp"
#include "driver/check/run_document.hpp"
#include "driver/check/verdict_text.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/outlook.hpp"
#include "driver/read/read_case.hpp"
#include "driver/results/events.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/reproducer.hpp"
#include "driver/results/row_writer.hpp"
#include "driver/results/run_files.hpp"
#include "driver/results/summary.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// The files of a result.
struct ResultFiles {
  base::OutputFile rows;
  // Not there if the rows go to standard output.
  std::optional<base::OutputFile> events;
  std::optional<base::OutputFile> summary;
  std::optional<base::OutputFile> solver;
};

bool prints_rows(const RunOptions& options) { return options.folder == "-" && !options.no_output; }

/// The file of a result.
fs::path result_file(const cases::Case& problem, const fs::path& folder,
                     const std::string& extension) {
  return folder / (results::case_stem(problem) + extension);
}

/// The ending of the rows' file.
std::string rows_extension(const RunOptions& options) { return "." + options.format; }

base::FileMark mark_of(const cases::Case& problem, std::string_view extension) {
  base::FileMark mark = results::result_mark(problem, extension == ".json");
  const auto format = table::format_of("rows" + std::string(extension));
  if (!format || *format == table::TableFormat::kCsv) return mark;
  return table::mark_of(*format, results::row_head(problem, results::output_columns(problem)),
                        mark);
}

tl::expected<ResultFiles, std::string> create_files(const cases::Case& problem,
                                                    const RunOptions& options,
                                                    const base::Overwriting& overwriting) {
  if (prints_rows(options)) {
    auto rows =
        base::OutputFile::create(fs::temp_directory_path() / "rows.csv", {}, base::kNeverNamed);
    if (!rows) return tl::unexpected(std::move(rows.error()));
    return ResultFiles{std::move(*rows), {}, {}, {}};
  }
  const auto create = [&](const std::string& extension) {
    return base::OutputFile::create(result_file(problem, options.folder, extension),
                                    mark_of(problem, extension), overwriting);
  };
  auto rows = create(rows_extension(options));
  if (!rows) return tl::unexpected(rows.error());
  ResultFiles files{std::move(*rows), {}, {}, {}};
  const auto add = [&](const char* extension,
                       std::optional<base::OutputFile>& file) -> tl::expected<void, std::string> {
    auto created = create(extension);
    if (!created) return tl::unexpected(std::move(created.error()));
    file.emplace(std::move(*created));
    return {};
  };
  auto added = add(".events.csv", files.events);
  if (added) added = add(".json", files.summary);
  if (added && options.solver_report) added = add(".solver.csv", files.solver);
  if (!added) return tl::unexpected(std::move(added.error()));
  return files;
}

/// Prints a file that is complete.
tl::expected<void, std::string> print_file(base::OutputFile& file) {
  if (auto closed = file.close(); !closed) return closed;
  std::ifstream in(file.temporary(), std::ios::binary);
  std::array<char, std::size_t{1} << 16U> piece{};
  while (in.read(piece.data(), piece.size()), in.gcount() > 0) {
    terminal::print_data({piece.data(), static_cast<std::size_t>(in.gcount())});
  }
  return {};
}

std::string shown(const fs::path& path) { return path.lexically_normal().string(); }

std::string notes_text(const base::Diagnostics& diagnostics) {
  std::string text;
  for (const std::string& note : base::lines_of(diagnostics, base::Severity::kNote)) {
    text += "  note: " + note + "\n";
  }
  return text;
}

/// Everything but errors and notes, which have their own places.
base::Diagnostics warnings_of(const base::Diagnostics& diagnostics) {
  base::Diagnostics warnings;
  for (base::Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity == base::Severity::kWarning) warnings.add(std::move(diagnostic));
  }
  return warnings;
}

/// Tells whether the case names data files that are not found from `folder`.
bool reads_data_elsewhere(const cases::Case& problem, const fs::path& folder) {
  std::error_code ignored;
  return cases::input_files(problem).size() > 1 &&
         !fs::equivalent(folder, fs::absolute(problem.file).parent_path(), ignored);
}

/// Writes the smallest case that fails in the same way beside where the result would be.
int write_reproducer(const read::ReadCase& read, const bench::SimulationFailure& failure,
                     const fs::path& folder, const base::Overwriting& overwriting) {
  const cases::Case& problem = *read.value;
  const fs::path target = result_file(problem, folder, ".failed.yaml");
  auto file = base::OutputFile::create(target, results::reproducer_mark(problem), overwriting);
  if (!file) return terminal::refuse(base::kExitEnvironment, file.error());
  file->append(base::sealed(results::reproducer(read.sources.front(), problem, failure)));
  base::OutputFile* const alone[] = {&*file};
  if (auto committed = base::commit(alone); !committed) {
    return terminal::refuse(base::kExitEnvironment, committed.error());
  }
  terminal::print_error(
      "  a case that fails the same way: " + shown(target) +
      (reads_data_elsewhere(problem, folder) ? " (move it beside the case's data files)" : "") +
      "\n");
  return base::kExitNumerical;
}

int run_one(const read::ReadCase& read, const RunOptions& options,
            const base::Overwriting& overwriting) {
  const auto start = std::chrono::steady_clock::now();
  const cases::Case& problem = *read.value;
  const int every = options.every.value_or(problem.output_every);

  if (const std::string fault = check::memory_fault(problem); !fault.empty()) {
    return terminal::refuse(base::kExitEnvironment, results::case_stem(problem) + ": " + fault);
  }
  std::optional<ResultFiles> files;
  std::unique_ptr<results::RowWriter> rows;
  std::optional<results::EventWriter> events;
  if (!options.no_output) {
    auto created = create_files(problem, options, overwriting);
    if (!created) return terminal::refuse(base::kExitEnvironment, created.error());
    files.emplace(std::move(*created));
    auto writer = results::RowWriter::create(problem, results::output_columns(problem),
                                             *table::format_named(options.format), files->rows);
    if (!writer) return terminal::refuse(base::kExitEnvironment, writer.error());
    rows = std::move(*writer);
    if (files->events) events.emplace(problem, *files->events);
  }

  results::Summary summary(problem);
  std::optional<analysis::SolverReport> solver;
  if (options.solver_report)
    solver.emplace(problem, files && files->solver ? &*files->solver : nullptr);
  std::vector<check::CheckProgress> checks;
  checks.reserve(problem.checks.size());
  for (const cases::Check& check : problem.checks) checks.emplace_back(problem, check);

  bench::Row last;
  std::int64_t count = 0;  // of rows that are written
  Outlook outlook(problem,
                  prints_rows(options) ? fs::temp_directory_path() : fs::path(options.folder));
  const auto follow = [&] {
    terminal::Progress progress(results::case_stem(problem));
    const auto written = [&]() -> std::optional<std::uintmax_t> {
      if (!rows) return std::nullopt;
      rows->bring();
      return rows->bytes();
    };
    const auto take = [&](std::span<const bench::Row> block) {
      summary.add(block);
      if (events) events->write(block);
      for (check::CheckProgress& check : checks) check.add(block);
      if (rows) {
        for (const bench::Row& row : block) {
          if (row.index % every != 0) continue;
          rows->write(row);
          ++count;
        }
        if (block.back().index % every != 0) last = block.back();
      }
      outlook.look(block.back(), written, progress);
    };
    if (!solver) return bench::run_in_blocks(problem, take);
    return bench::follow_case(problem, [&](const bench::Simulation& simulation) {
      solver->add(simulation);
      take({&simulation.row(), 1});
    });
  };
  const auto ended = [&]() -> decltype(follow()) {
    try {
      return follow();
    } catch (const NoRoom& full) {
      return tl::unexpected(
          bench::SimulationFailure{bench::SimulationFailure::Kind::kEnvironment, full.message});
    }
  }();
  if (!ended) {
    terminal::print_error(bench::failure_text(problem, ended.error()));
    int code = bench::exit_code(ended.error());
    if (code == base::kExitNumerical && files && !prints_rows(options)) {
      code = base::worse(code, write_reproducer(read, ended.error(), options.folder, overwriting));
    }
    return code;
  }
  // The end of the run is always in the result.
  if (rows && last.index == summary.increments() && last.index > 0) {
    rows->write(last);
    ++count;
  }
  if (const auto finished = rows ? rows->finish() : tl::expected<void, std::string>(); !finished) {
    return terminal::refuse(base::kExitEnvironment, finished.error());
  }

  std::vector<check::Verdict> verdicts;
  verdicts.reserve(checks.size());
  for (const check::CheckProgress& check : checks) verdicts.push_back(check.verdict());
  const std::vector<std::string> warnings = summary.warnings(*ended);

  std::string written;
  if (files && prints_rows(options)) {
    if (auto printed = print_file(files->rows); !printed) {
      return terminal::refuse(base::kExitEnvironment, printed.error());
    }
  } else if (files) {
    base::json::Value document =
        check::run_document(problem, summary, read.diagnostics, warnings, verdicts);
    document["rows"] = count;  // whoever reads them sees whether some are missing
    std::vector<base::OutputFile*> together = {&files->rows, &*files->events};
    for (base::OutputFile* file : together) {
      if (auto closed = file->close(); !closed) {
        return terminal::refuse(base::kExitEnvironment, closed.error());
      }
    }
    document["files"] = results::list_of_files(together);
    files->summary->append(document.dump(2) + "\n");
    together.push_back(&*files->summary);
    if (files->solver) together.push_back(&*files->solver);
    if (auto committed = base::commit(together); !committed) {
      return terminal::refuse(base::kExitEnvironment, committed.error());
    }
    for (const base::OutputFile* file : together) written += "  " + shown(file->target());
    written += "\n";
  }

  std::string text;
  std::size_t doubts = warnings.size();
  for (const std::string& warning : warnings) text += "  warning: " + warning + "\n";
  for (const check::Verdict& verdict : verdicts) {
    doubts += verdict.warnings.size();
    for (const std::string& warning : verdict.warnings) {
      text += fmt::format("  warning: check '{}': {}\n", verdict.name, warning);
    }
  }
  bool failed = false;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    failed = failed || !verdicts[i].passed;
    if (options.quiet && verdicts[i].passed) continue;
    text += fmt::format("  {}  {}\n", verdicts[i].passed ? "PASS" : "FAIL",
                        check::verdict_text(problem.checks[i], verdicts[i]));
  }
  if (options.strict && doubts > 0) {
    failed = true;
    text += fmt::format("  FAIL  {} warning{} under --strict\n", doubts, doubts == 1 ? "" : "s");
  }
  if (!options.quiet) {
    const auto elapsed = std::chrono::steady_clock::now() - start;
    text = fmt::format("{}: {} increments, {}\n", results::case_stem(problem), summary.increments(),
                       terminal::elapsed_text(elapsed)) +
           summary.text() + (solver ? solver->text() : "") + notes_text(read.diagnostics) + text +
           written;
  } else if (!text.empty()) {
    text = results::case_stem(problem) + ":\n" + text;
  }
  if (prints_rows(options)) {
    terminal::print_error(text);
  } else {
    terminal::print(text);
  }
  return failed ? base::kExitCheckFailed : base::kExitOk;
}

int explain_one(const cases::Case& problem, double time) {
  const auto text = analysis::explain(problem, time);
  if (!text) {
    terminal::print_error(text.error().message);
    return text.error().code;
  }
  terminal::print(*text);
  return base::kExitOk;
}

/// Judges what smaller increments, or none, would change.
int judge_increments(const cases::Case& problem, const RunOptions& options) {
  int code = base::kExitOk;
  const auto tell = [&](const tl::expected<std::string, analysis::CommandFailure>& text) {
    if (text) return terminal::print(*text);
    terminal::print_error(text.error().message);
    code = base::worse(code, text.error().code);
  };
  if (options.compare_integration) tell(analysis::compare_integration(problem));
  if (options.converge) tell(analysis::converge(problem));
  return code;
}

/// Two cases that would write the same files, as a sentence; empty if there are none.
std::string collision(const std::vector<std::string>& cases) {
  std::map<std::string, std::string> first;
  for (const std::string& path : cases) {
    const auto [there, added] =
        first.emplace(fs::path(base::source_name(path)).stem().string(), path);
    if (!added) {
      return fmt::format("{} and {} would both write {}.csv; run them into different folders (-o)",
                         there->second, path, there->first);
    }
  }
  return {};
}

/// Returns whether the command writes files at all.
bool writes_files(const RunOptions& options) {
  return !options.no_output && !prints_rows(options) && !options.explain &&
         !options.compare_integration && !options.converge;
}

/// Returns what is wrong with where the results are to go, as a sentence; empty if nothing is.
std::string fault_of_options(const RunOptions& options) {
  if (prints_rows(options) && options.cases.size() > 1) {
    return fmt::format(
        "-o - prints the rows of one case, found {}; run them one by one, or into "
        "a folder",
        options.cases.size());
  }
  std::string fault = options.folder == "-" ? "" : folder_fault(options.folder, "case");
  return fault.empty() ? fault : fault + "; '-o - > FILE' writes the rows of one case to any file";
}

/// A result that cannot be written, for example because it would replace what is no result of the
/// case, as a sentence; empty if there is none.
std::string fault_of_targets(const std::vector<read::ReadCase>& cases, const RunOptions& options,
                             const base::Overwriting& overwriting) {
  for (const read::ReadCase& read : cases) {
    const std::vector<std::string> extensions{rows_extension(options), ".events.csv", ".json",
                                              ".solver.csv"};
    for (const std::string& extension : extensions) {
      if (extension == ".solver.csv" && !options.solver_report) continue;
      std::string fault = base::target_fault(result_file(*read.value, options.folder, extension),
                                             mark_of(*read.value, extension), overwriting);
      if (!fault.empty()) return fault;
    }
  }
  return {};
}

}  // namespace

int run_command(const RunOptions& options) {
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  if (const std::string fault = collision(options.cases); !options.no_output && !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  if (const std::string fault = fault_of_options(options); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  std::vector<read::ReadCase> cases;
  int code = base::kExitOk;
  base::Diagnostics all;
  for (const std::string& path : options.cases) {
    cases.push_back(read::read_case(path, {*settings, options.allow_outside}));
    const read::ReadCase& read = cases.back();
    all.append(read.diagnostics);
    if (read.value && !read.diagnostics.has_errors()) {
      if (const base::Diagnostics warnings = warnings_of(read.diagnostics); !warnings.empty()) {
        terminal::print_error(base::render(warnings, read.sources));
      }
      continue;
    }
    terminal::print_error(base::render(read.diagnostics, read.sources));
    code =
        base::worse(code, read.environment_failure ? base::kExitEnvironment : base::kExitBadInput);
  }
  if (code != base::kExitOk) {
    terminal::print_error(driver::base::summary(all) + ", nothing was run\n");
    return code;
  }
  if (const std::size_t warnings = all.count(base::Severity::kWarning);
      options.strict && warnings > 0) {
    terminal::print_error(fmt::format("{} warning{} under --strict, nothing was run\n", warnings,
                                      warnings == 1 ? "" : "s"));
    return base::kExitBadInput;
  }
  std::vector<std::string> inputs;
  for (const read::ReadCase& read : cases) {
    for (std::string& file : cases::input_files(*read.value)) inputs.push_back(std::move(file));
  }
  const base::Overwriting overwriting{inputs, options.force};
  if (writes_files(options)) {
    const std::string fault = fault_of_targets(cases, options, overwriting);
    if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  }
  for (const read::ReadCase& read : cases) {
    const auto run_it = [&] {
      if (options.explain) return explain_one(*read.value, *options.explain);
      if (options.compare_integration || options.converge) {
        return judge_increments(*read.value, options);
      }
      return run_one(read, options, overwriting);
    };
    code = base::worse(code, run_it());
  }
  return code;
}

}  // namespace slipbench::driver::commands
