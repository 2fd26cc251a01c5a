// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/sweep.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/files/output_file.hpp"
#include "driver/base/files/work_crew.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/results/provenance.hpp"
#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep_summary.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;

/// A part of the samples, `number` of `count`, both from 1 on.
struct Part {
  std::size_t number = 1;
  std::size_t count = 1;

  /// Returns the first sample of part i, counted from 0, of the samples there are.
  std::size_t first(std::size_t i, std::size_t samples) const {
    // Samples and parts are below 2^31: the product has room.
    return i * samples / count;
  }
};

/// Reads "2/8"; nothing if it is none.
std::optional<Part> part_of(const std::string& text) {
  Part part;
  if (text.empty()) return part;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, part.count);
  constexpr std::size_t kMost = 1'000'000'000;
  const bool good = count.ec == std::errc() && count.ptr == end && part.number >= 1 &&
                    part.number <= part.count && part.count <= kMost;
  return good ? std::optional(part) : std::nullopt;
}

std::string file_name(const sweep::Sweep& sweep) {
  return base::printable(fs::path(sweep.file).filename().string());
}

/// The first lines of the result, and the names of its columns.
std::string header_of(const sweep::Sweep& sweep) {
  std::string text =
      fmt::format("# slipbench {}\n# sweep: {}\n# title: {}\n# case: {}\nid",
                  results::program_version(), file_name(sweep), base::printable(sweep.title),
                  base::printable(fs::path(sweep.case_path).filename().string()));
  for (const sweep::VariedParameter& one : sweep.varied) text += "," + one.name;
  for (const sweep::Collected& one : sweep.collected) text += "," + one.name;
  return text + "\n";
}

void append_row(const sweep::SampleOutcome& outcome, std::string& text) {
  fmt::format_to(std::back_inserter(text), "{}", outcome.id);
  for (const double value : outcome.values) fmt::format_to(std::back_inserter(text), ",{}", value);
  for (const double value : outcome.numbers) fmt::format_to(std::back_inserter(text), ",{}", value);
  text += '\n';
}

}  // namespace

int sweep_command(const SweepOptions& options) {
  if (const std::string fault = folder_fault(options.folder, "sweep"); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  const auto part = part_of(options.part);
  if (!part) {
    return terminal::refuse(base::kExitBadInput,
                            "--part " + base::printable(options.part) +
                                ": wants a part and how many there are, such as 2/8");
  }
  const auto settings = base::parse_settings(options.settings);
  if (!settings) return terminal::refuse(base::kExitBadInput, settings.error());
  sweep::ReadSweep read = sweep::read_sweep(options.file, {*settings, options.allow_outside});
  if (!read.value) {
    terminal::print_error(base::render(read.diagnostics, read.sources));
    terminal::print_error(base::summary(read.diagnostics) + ", nothing was run\n");
    return read.environment_failure ? base::kExitEnvironment : base::kExitBadInput;
  }
  const sweep::Sweep& sweep = *read.value;
  sweep::SweepOptions run;
  run.threads = options.threads > 0 ? static_cast<unsigned>(options.threads) : base::core_count();
  run.first = part->first(part->number - 1, sweep.samples);
  run.end = part->first(part->number, sweep.samples);

  const std::string stem = fs::path(sweep.file).stem().string();
  const std::string name =
      options.part.empty() ? stem : fmt::format("{}.{}of{}", stem, part->number, part->count);
  std::vector<std::string> inputs = read.data_files;
  inputs.push_back(options.file);
  inputs.push_back(sweep.case_path);
  std::optional<base::OutputFile> file;
  if (!options.no_output) {
    const base::FileMark mark{"a result of " + file_name(sweep), "# slipbench ",
                              "\n# sweep: " + file_name(sweep) + "\n", true};
    auto made = base::OutputFile::create(fs::path(options.folder) / (name + ".csv"), mark,
                                         {inputs, options.force});
    if (!made) return terminal::refuse(base::kExitEnvironment, made.error());
    file.emplace(std::move(*made));
    file->append(header_of(sweep));
  }

  sweep::SweepSummary summary(sweep);
  const auto start = std::chrono::steady_clock::now();
  {
    terminal::Progress line("samples");
    run.progress = [&](std::size_t done, std::size_t failed) {
      line.step(terminal::WorkDone{done, run.end - run.first, failed});
    };
    sweep::run_sweep(sweep, run, [&](const sweep::SampleOutcome& outcome) {
      summary.add(outcome);
      if (file) {
        append_row(outcome, file->buffer());
        file->flush_if_full();
      }
    });
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string text = fmt::format(
      "{}: {} samples of {}, {:.2g} s\n{}", base::printable(name), run.end - run.first,
      base::printable(fs::path(sweep.case_path).filename().string()), seconds, summary.text());
  if (file) {
    base::OutputFile* const files[] = {&*file};
    if (auto committed = base::commit(files); !committed) {
      return terminal::refuse(base::kExitEnvironment, committed.error());
    }
    text += "  " + file->target().lexically_normal().string() + "\n";
  }
  terminal::print(text);
  return summary.failed() > 0 ? base::kExitNumerical : base::kExitOk;
}

}  // namespace slipbench::driver::commands
