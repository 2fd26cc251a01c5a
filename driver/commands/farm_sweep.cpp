// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/farm_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <tl/expected.hpp>
#include <utility>

#include "driver/base/files/exit_code.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/commands/arguments.hpp"
#include "driver/commands/sweep_files.hpp"
#include "driver/sweep/merge.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {
namespace {

namespace fs = std::filesystem;
using Opened = tl::expected<OpenSweep, int>;

/// Reads the sweep on all ranks: first on rank 0, so that a fault of the input is told once.
Opened open_on_all(const FarmSweepOptions& options, const farm::Farm& farm) {
  const auto open = [&]() -> Opened {
    if (const std::string fault = folder_fault(options.folder, "sweep"); !fault.empty()) {
      return tl::unexpected(terminal::refuse(base::kExitBadInput, fault));
    }
    return open_sweep(options.file, options.settings, options.allow_outside);
  };
  Opened own = tl::unexpected(base::kExitBadInput);
  if (farm.rank == 0) own = open();
  if (!farm.agree(farm.rank != 0 || own.has_value())) return tl::unexpected(own ? 0 : own.error());
  if (farm.rank != 0) own = open();
  std::string identity = own ? own->identity : "";
  identity.resize(64);
  const std::string mine = identity;
  farm.share(identity);
  if (own && mine != identity) {
    own = tl::unexpected(terminal::refuse(
        base::kExitEnvironment, fmt::format("rank {} reads other inputs, or is another version, "
                                            "than rank 0: all must see the same files",
                                            farm.rank)));
  }
  if (!farm.agree(own.has_value())) return tl::unexpected(own ? 0 : own.error());
  return own;
}

/// Finds which chunks the journals in the folder have. Returns a sentence if one cannot be used.
std::string find_done(const OpenSweep& open, const FarmSweepOptions& options,
                      std::span<char> done) {
  for (const fs::path& path : sweep::journals_in(options.folder, open.sweep)) {
    if (options.force) {
      std::error_code ignored;  // one that stays is refused where it is opened
      fs::remove(path, ignored);
      continue;
    }
    const auto journal =
        sweep::Journal::open(path, open.sweep, open.identity, sweep::Journal::Use::kRead);
    if (!journal) return journal.error() + "; --force begins anew";
    farm::mark_done(open.sweep, (*journal)->records(), done);
  }
  return {};
}

/// Runs the share of this rank into its journal. Returns a sentence if it cannot be kept.
std::string run_own_share(const OpenSweep& open, const fs::path& path, std::span<const char> done,
                          const farm::Farm& farm) {
  const auto journal =
      sweep::Journal::open(path, open.sweep, open.identity, sweep::Journal::Use::kGoOn);
  // All begin together, or none: a rank that cannot keep its share must not take one.
  if (!farm.agree(journal.has_value())) return journal ? "" : journal.error();
  farm::run_farm(open.sweep, done, farm,
                 [&](const sweep::Chunk& chunk) { (*journal)->append(chunk); });
  return (*journal)->error();
}

/// Joins the journals of all ranks and removes them.
int write_result(const OpenSweep& open, const std::vector<fs::path>& journals, std::size_t recalled,
                 const farm::Farm& farm, SweepResult& result) {
  {
    sweep::Parts parts(open.sweep, open.identity);
    for (const fs::path& path : journals) {
      if (const std::string fault = parts.add(path); !fault.empty()) {
        return terminal::refuse(base::kExitEnvironment, fault);
      }
    }
    if (const std::string missing = parts.missing_text(); !missing.empty()) {
      return terminal::refuse(base::kExitEnvironment,
                              missing + "; is the folder of -o the same on all machines?");
    }
    const std::string fault =
        parts.for_each([&](const sweep::SampleOutcome& outcome) { result.take(outcome); });
    if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  }
  std::string how = fmt::format("by {} {}", farm.ranks, farm.ranks == 1 ? "rank" : "ranks");
  if (recalled > 0) how += fmt::format(", {} of the chunks from a run before", recalled);
  const int code = result.finish(how);
  std::error_code ignored;  // a journal that stays is no fault of the result
  for (const fs::path& path : journals) {
    if (code != base::kExitEnvironment) fs::remove(path, ignored);
  }
  return code;
}

}  // namespace

int farm_sweep_command(const FarmSweepOptions& options, const farm::Farm& farm) {
  const Opened open = open_on_all(options, farm);
  if (!open) return open.error();
  std::vector<char> done = farm::done_chunks(open->sweep);
  std::unique_ptr<SweepResult> result;
  std::string fault;
  if (farm.rank == 0) {
    auto created = SweepResult::create(*open, {.folder = options.folder,
                                               .format = options.format,
                                               .report = options.report,
                                               .force = options.force});
    if (created) {
      result = std::move(*created);
      fault = find_done(*open, options, done);
    } else {
      fault = created.error();
    }
  }
  bool ready = farm.agree(fault.empty());
  if (ready) {
    farm.share(done);
    const std::string own = sweep::result_name(open->sweep, {});
    const fs::path path =
        fs::path(options.folder) / fmt::format("{}.rank{}.journal", own, farm.rank);
    fault = run_own_share(*open, path, done, farm);
    ready = farm.agree(fault.empty());
  }
  if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  if (!ready || farm.rank != 0) return base::kExitOk;
  const auto recalled = static_cast<std::size_t>(std::count(done.begin(), done.end(), 1));
  return write_result(*open, sweep::journals_in(options.folder, open->sweep), recalled, farm,
                      *result);
}

}  // namespace slipbench::driver::commands
