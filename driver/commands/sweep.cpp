// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/interruption.hpp"
#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/shell_word.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/emit_slurm.hpp"
#include "driver/commands/sweep_files.hpp"
#include "driver/sweep/journal.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/tally.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// The command line by which an interrupted sweep is gone on with.
std::string typed(const SweepOptions& options) {
  std::string text = "slipbench sweep " + base::shell_word(options.file);
  if (options.folder != ".") text += " -o " + base::shell_word(options.folder);
  for (const std::string& one : options.settings) text += " --set " + base::shell_word(one);
  if (options.allow_outside) text += " --allow-outside";
  if (options.threads > 0) text += fmt::format(" -j {}", options.threads);
  if (!options.part.empty()) text += " --part " + options.part;
  if (options.no_rows) text += " --no-rows";
  if (options.format != "csv") text += " --format " + options.format;
  if (!options.report.empty()) text += " --report " + base::shell_word(options.report);
  return base::printable(text);
}

/// State of a run, to go on from: its rows in a journal, or without rows a tally.
struct Kept {
  std::unique_ptr<sweep::Journal> journal = nullptr;
  std::unique_ptr<sweep::RunningTally> tally = nullptr;
  std::size_t recalled = 0;  ///< samples that need not be run
};

/// Opens what is kept of a run, and says what is there to go on from. Returns a sentence if it
/// cannot.
std::string keep(const OpenSweep& open, const std::string& name,
                 const std::optional<sweep::Part>& part, const SweepOptions& options, Kept& kept) {
  const auto path = [&](const char* ending) { return fs::path(options.folder) / (name + ending); };
  std::string what = "what was run";
  if (options.no_rows) {
    auto tally =
        sweep::RunningTally::open(path(".tally"), open.sweep, open.identity, part, options.force);
    if (!tally) return tally.error() + "; --force begins anew";
    kept.tally = std::move(*tally);
    kept.recalled = kept.tally->recalled();
    what += ", but for the last seconds,";
  } else {
    using Use = sweep::Journal::Use;
    auto journal = sweep::Journal::open(path(".journal"), open.sweep, open.identity,
                                        options.force ? Use::kAnew : Use::kGoOn);
    if (!journal) return journal.error() + "; --force begins anew";
    kept.journal = std::move(*journal);
    for (const sweep::JournalRecord& record : kept.journal->records()) {
      kept.recalled += record.count;
    }
    if (kept.journal->dropped() > 0) {
      terminal::print_error(
          fmt::format("slipbench: warning: {}: the last record is not whole and is run again\n",
                      base::printable(kept.journal->path().string())));
    }
  }
  base::say_when_interrupted(fmt::format(
      "slipbench: interrupted; {} is kept in {}, and this goes on:\n  {}\n", what,
      base::printable((kept.tally ? kept.tally->path() : kept.journal->path()).string()),
      typed(options)));
  return {};
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  if (const std::string fault = folder_fault(options.folder, "sweep"); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  std::optional<sweep::Part> part;
  if (!options.part.empty()) {
    part = sweep::part_of(options.part);
    if (!part) {
      return terminal::refuse(base::kExitBadInput,
                              "--part " + base::printable(options.part) +
                                  ": wants a part and how many there are, such as 2/8");
    }
    if (options.format != "csv") {
      return terminal::refuse(base::kExitBadInput,
                              "--format " + options.format +
                                  ": parts are csv; 'slipbench merge' writes what is wanted");
    }
  }
  const auto open = open_sweep(options.file, options.settings, options.allow_outside);
  if (!open) return open.error();
  if (options.emit == "slurm") return emit_slurm(*open, options);
  sweep::SweepOptions run;
  run.threads = options.threads > 0 ? static_cast<unsigned>(options.threads) : base::core_count();
  const sweep::SampleRange range = part.value_or(sweep::Part()).range(open->sweep);
  run.first = range.first;
  run.end = range.end;

  const auto result =
      SweepResult::create(*open, {options.folder, part, options.format, options.report,
                                  options.no_rows, options.no_output, options.force});
  if (!result) return terminal::refuse(base::kExitEnvironment, result.error());
  Kept kept;
  if (!options.no_output) {
    if (std::string fault = keep(*open, (*result)->name(), part, options, kept); !fault.empty()) {
      return terminal::refuse(base::kExitEnvironment, fault);
    }
  }
  if (kept.journal) {
    run.recall = [&](sweep::Chunk& chunk) { return kept.journal->recall(chunk); };
    run.finished = [&](const sweep::Chunk& chunk) { kept.journal->append(chunk); };
  }
  if (kept.tally) {
    run.recall = [&](sweep::Chunk& chunk) { return kept.tally->has(chunk); };
    run.finished = [&](const sweep::Chunk& chunk) { kept.tally->add(chunk); };
  }

  const auto start = std::chrono::steady_clock::now();
  {
    terminal::Progress line("samples");
    run.progress = [&](std::size_t done, std::size_t failed) {
      line.step(terminal::WorkDone{done, range.end - range.first, failed});
    };
    sweep::run_sweep(open->sweep, run, [&](const sweep::SampleOutcome& outcome) {
      if (!kept.tally) (*result)->take(outcome);
    });
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string how = fmt::format("{:.2g} s", seconds);
  if (kept.recalled > 0) {
    how += fmt::format(", {} of the samples from the run before", kept.recalled);
  }
  fs::path also;
  if (kept.tally) {
    if (const std::string fault = kept.tally->finish(); !fault.empty()) {
      return terminal::refuse(base::kExitEnvironment, fault);
    }
    // Of a part the tally is the result.
    if (part) also = kept.tally->path();
    (*result)->take(kept.tally->total().tally);
  }
  const int code = (*result)->finish(how, also);
  base::say_when_interrupted({});
  if (code == base::kExitEnvironment) return code;
  if (kept.journal) kept.journal->remove();
  if (kept.tally && !part) kept.tally->remove();
  return code;
}

}  // namespace slipbench::driver::commands
