// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/sweep_files.hpp"
#include "driver/sweep/merge.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/tally.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace fs = std::filesystem;

namespace {

constexpr const char* kTally = ".tally";

/// Finds the files that are to be joined: with rows, or tallies. Errors are sentences.
tl::expected<std::vector<fs::path>, std::string> parts_of(const OpenSweep& open,
                                                          const MergeOptions& options) {
  std::vector<fs::path> files(options.parts.begin(), options.parts.end());
  if (files.empty()) {
    files = sweep::parts_in(options.folder, open.sweep);
    for (const auto& others : {sweep::journals_in(options.folder, open.sweep),
                               sweep::tallies_in(options.folder, open.sweep)}) {
      files.insert(files.end(), others.begin(), others.end());
    }
  }
  if (files.empty()) {
    return tl::unexpected(options.folder + ": has no part of " + sweep::file_name(open.sweep) +
                          "; name the parts, or their folder with -o");
  }
  const auto tallies = std::count_if(
      files.begin(), files.end(), [](const fs::path& file) { return file.extension() == kTally; });
  if (tallies > 0 && tallies < static_cast<std::ptrdiff_t>(files.size())) {
    return tl::unexpected(fmt::format(
        "{} of {} files are tallies, which have no rows: name those that are to be joined", tallies,
        files.size()));
  }
  if (tallies > 0 && options.format != "csv") {
    return tl::unexpected("--format " + options.format + ": tallies have no rows");
  }
  return files;
}

int merge_tallies(const OpenSweep& open, const MergeOptions& options,
                  const std::vector<fs::path>& files, const std::string& how) {
  auto tally = sweep::join_tallies(files, open.sweep, open.identity);
  if (!tally) return terminal::refuse(base::kExitBadInput, tally.error());
  const auto result = SweepResult::create(open, {.folder = options.folder,
                                                 .report = options.report,
                                                 .no_rows = true,
                                                 .force = options.force});
  if (!result) return terminal::refuse(base::kExitEnvironment, result.error());
  (*result)->take(std::move(*tally));
  return (*result)->finish(how);
}

int merge_rows(const OpenSweep& open, const MergeOptions& options,
               const std::vector<fs::path>& files, const std::string& how) {
  sweep::Parts parts(open.sweep, open.identity);
  for (const fs::path& file : files) {
    if (const std::string fault = parts.add(file); !fault.empty()) {
      return terminal::refuse(base::kExitBadInput, fault);
    }
  }
  if (const std::string missing = parts.missing_text(); !missing.empty()) {
    return terminal::refuse(base::kExitBadInput,
                            sweep::file_name(open.sweep) + ": the parts are not all: " + missing);
  }
  const auto result = SweepResult::create(open, {.folder = options.folder,
                                                 .format = options.format,
                                                 .report = options.report,
                                                 .force = options.force});
  if (!result) return terminal::refuse(base::kExitEnvironment, result.error());
  {
    terminal::Progress line("samples");
    std::size_t done = 0;
    const std::string fault = parts.for_each([&](const sweep::SampleOutcome& outcome) {
      (*result)->take(outcome);
      line.step(terminal::WorkDone{++done, open.sweep.samples, 0});
    });
    if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  }
  return (*result)->finish(how);
}

}  // namespace

int merge_command(const MergeOptions& options) {
  if (const std::string fault = folder_fault(options.folder, "sweep"); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  auto open = open_sweep(options.file, options.settings, options.allow_outside);
  if (!open) return open.error();
  for (const std::string& part : options.parts) {
    std::error_code ignored;
    if (!fs::exists(part, ignored)) {
      return terminal::refuse(base::kExitEnvironment, base::printable(part) + ": is not there");
    }
  }
  auto files = parts_of(*open, options);
  if (!files) return terminal::refuse(base::kExitBadInput, files.error());
  for (const fs::path& file : *files) open->inputs.push_back(file.string());
  const std::string how =
      fmt::format("joined from {} {}", files->size(), files->size() == 1 ? "part" : "parts");
  return files->front().extension() == kTally ? merge_tallies(*open, options, *files, how)
                                              : merge_rows(*open, options, *files, how);
}

}  // namespace slipbench::driver::commands
