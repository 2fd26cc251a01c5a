// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/merge.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/sweep_files.hpp"
#include "driver/sweep/merge.hpp"
#include "driver/terminal/print.hpp"
#include "driver/terminal/progress.hpp"

namespace slipbench::driver::commands {
namespace fs = std::filesystem;

int merge_command(const MergeOptions& options) {
  if (const std::string fault = folder_fault(options.folder, "sweep"); !fault.empty()) {
    return terminal::refuse(base::kExitBadInput, fault);
  }
  auto open = open_sweep(options.file, options.settings, options.allow_outside);
  if (!open) return open.error();
  std::vector<fs::path> files(options.parts.begin(), options.parts.end());
  if (files.empty()) {
    files = sweep::parts_in(options.folder, open->sweep);
    for (fs::path& one : sweep::journals_in(options.folder, open->sweep)) {
      files.push_back(std::move(one));
    }
    if (files.empty()) {
      return terminal::refuse(base::kExitBadInput, options.folder + ": has no part of " +
                                                       sweep::file_name(open->sweep) +
                                                       "; name the parts, or their folder with -o");
    }
  }
  sweep::Parts parts(open->sweep, open->identity);
  for (const fs::path& file : files) {
    if (const std::string fault = parts.add(file); !fault.empty()) {
      return terminal::refuse(base::kExitBadInput, fault);
    }
    open->inputs.push_back(file.string());
  }
  if (const std::string missing = parts.missing_text(); !missing.empty()) {
    return terminal::refuse(base::kExitBadInput,
                            sweep::file_name(open->sweep) + ": the parts are not all: " + missing);
  }
  const auto result = SweepResult::create(*open, {.folder = options.folder,
                                                  .format = options.format,
                                                  .report = options.report,
                                                  .force = options.force});
  if (!result) return terminal::refuse(base::kExitEnvironment, result.error());
  {
    terminal::Progress line("samples");
    std::size_t done = 0;
    const std::string fault = parts.for_each([&](const sweep::SampleOutcome& outcome) {
      (*result)->take(outcome);
      line.step(terminal::WorkDone{++done, open->sweep.samples, 0});
    });
    if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  }
  return (*result)->finish(
      fmt::format("joined from {} {}", files.size(), files.size() == 1 ? "part" : "parts"));
}

}  // namespace slipbench::driver::commands
