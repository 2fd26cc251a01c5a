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
#include "driver/commands/arguments.hpp"
#include "driver/commands/emit_slurm.hpp"
#include "driver/commands/sweep_files.hpp"
#include "driver/sweep/journal.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

/// The command line by which an interrupted sweep is gone on with.
std::string typed(const SweepOptions& options) {
  std::string text = "slipbench sweep " + shell_word(options.file);
  if (options.folder != ".") text += " -o " + shell_word(options.folder);
  for (const std::string& one : options.settings) text += " --set " + shell_word(one);
  if (options.allow_outside) text += " --allow-outside";
  if (options.threads > 0) text += fmt::format(" -j {}", options.threads);
  if (!options.part.empty()) text += " --part " + options.part;
  if (options.format != "csv") text += " --format " + options.format;
  if (!options.report.empty()) text += " --report " + shell_word(options.report);
  return base::printable(text);
}

/// Opens the journal of a sweep that writes a result, and says what is there to go on from.
tl::expected<std::unique_ptr<sweep::Journal>, std::string> open_journal(
    const OpenSweep& open, const std::string& name, const SweepOptions& options) {
  using Use = sweep::Journal::Use;
  const std::filesystem::path path = std::filesystem::path(options.folder) / (name + ".journal");
  auto journal = sweep::Journal::open(path, open.sweep, open.identity,
                                      options.force ? Use::kAnew : Use::kGoOn);
  if (!journal) return tl::unexpected(journal.error() + "; --force begins anew");
  if ((*journal)->dropped() > 0) {
    terminal::print_error(
        fmt::format("slipbench: warning: {}: the last record is not whole and is run again\n",
                    base::printable(path.string())));
  }
  return journal;
}

/// Samples of the journal that need not be run.
std::size_t recalled_samples(const sweep::Journal& journal) {
  std::size_t samples = 0;
  for (const sweep::JournalRecord& record : journal.records()) samples += record.count;
  return samples;
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
    if (options.no_rows) {
      return terminal::refuse(base::kExitBadInput,
                              "--no-rows: a part is its rows, without which it cannot be joined");
    }
  }
  const auto open = open_sweep(options.file, options.settings, options.allow_outside);
  if (!open) return open.error();
  if (options.emit == "slurm") return emit_slurm(*open, options);
  const std::size_t samples = open->sweep.samples;
  sweep::SweepOptions run;
  run.threads = options.threads > 0 ? static_cast<unsigned>(options.threads) : base::core_count();
  run.first = part.value_or(sweep::Part()).first(samples);
  run.end = part.value_or(sweep::Part()).end(samples);

  const auto result =
      SweepResult::create(*open, {options.folder, part, options.format, options.report,
                                  options.no_rows, options.no_output, options.force});
  if (!result) return terminal::refuse(base::kExitEnvironment, result.error());
  std::unique_ptr<sweep::Journal> journal;
  std::size_t recalled = 0;
  if (!options.no_output && !options.no_rows) {
    auto opened = open_journal(*open, (*result)->name(), options);
    if (!opened) return terminal::refuse(base::kExitEnvironment, opened.error());
    journal = std::move(*opened);
    recalled = recalled_samples(*journal);
    run.recall = [&](sweep::Chunk& chunk) { return journal->recall(chunk); };
    run.finished = [&](const sweep::Chunk& chunk) { journal->append(chunk); };
    base::say_when_interrupted(
        fmt::format("slipbench: interrupted; what was run is kept in {}, and this goes on:\n  {}\n",
                    base::printable(journal->path().string()), typed(options)));
  }

  const auto start = std::chrono::steady_clock::now();
  {
    terminal::Progress line("samples");
    run.progress = [&](std::size_t done, std::size_t failed) {
      line.step(terminal::WorkDone{done, run.end - run.first, failed});
    };
    sweep::run_sweep(open->sweep, run,
                     [&](const sweep::SampleOutcome& outcome) { (*result)->take(outcome); });
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string how = fmt::format("{:.2g} s", seconds);
  if (recalled > 0) how += fmt::format(", {} of the samples from the run before", recalled);
  const int code = (*result)->finish(how);
  base::say_when_interrupted({});
  if (journal && code != base::kExitEnvironment) journal->remove();
  return code;
}

}  // namespace slipbench::driver::commands
