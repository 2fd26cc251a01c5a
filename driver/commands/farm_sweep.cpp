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
#include "driver/sweep/journal.hpp"
#include "driver/sweep/merge.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/tally.hpp"
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

/// Finds the files that ranks leave.
std::vector<fs::path> kept_in(const OpenSweep& open, const FarmSweepOptions& options) {
  return options.no_rows ? sweep::tallies_in(options.folder, open.sweep)
                         : sweep::journals_in(options.folder, open.sweep);
}

/// Finds which chunks the files in the folder have. Returns a sentence if one cannot be used.
std::string find_done(const OpenSweep& open, const FarmSweepOptions& options,
                      std::span<char> done) {
  for (const fs::path& path : kept_in(open, options)) {
    if (options.force) {
      std::error_code ignored;  // one that stays is refused where it is opened
      fs::remove(path, ignored);
      continue;
    }
    if (options.no_rows) {
      const auto tally = sweep::read_tally(path, open.sweep, open.identity);
      if (!tally) return tally.error() + "; --force begins anew";
      farm::mark_done(open.sweep, *tally, done);
      continue;
    }
    const auto journal =
        sweep::Journal::open(path, open.sweep, open.identity, sweep::Journal::Use::kRead);
    if (!journal) return journal.error() + "; --force begins anew";
    farm::mark_done(open.sweep, (*journal)->records(), done);
  }
  return {};
}

/// Runs the share of this rank into its journal, or tally. Returns a sentence if it cannot be kept.
std::string run_own_share(const OpenSweep& open, const FarmSweepOptions& options,
                          std::span<const char> done, const farm::Farm& farm) {
  const std::string name = fmt::format("{}.rank{}", sweep::result_name(open.sweep, {}), farm.rank);
  // All begin together, or none: a rank that cannot keep its share must not take one.
  if (options.no_rows) {
    const auto tally = sweep::RunningTally::open(fs::path(options.folder) / (name + ".tally"),
                                                 open.sweep, open.identity, {}, false);
    if (!farm.agree(tally.has_value())) return tally ? "" : tally.error();
    farm::run_farm(open.sweep, done, farm,
                   [&](const sweep::Chunk& chunk) { (*tally)->add(chunk); });
    return (*tally)->finish();
  }
  const auto journal = sweep::Journal::open(fs::path(options.folder) / (name + ".journal"),
                                            open.sweep, open.identity, sweep::Journal::Use::kGoOn);
  if (!farm.agree(journal.has_value())) return journal ? "" : journal.error();
  farm::run_farm(open.sweep, done, farm,
                 [&](const sweep::Chunk& chunk) { (*journal)->append(chunk); });
  return (*journal)->error();
}

/// Brings what all ranks have left into the result. Returns a sentence if it cannot.
std::string join(const OpenSweep& open, const FarmSweepOptions& options,
                 const std::vector<fs::path>& kept, SweepResult& result) {
  constexpr const char* kFolder = "; is the folder of -o the same on all machines?";
  if (options.no_rows) {
    auto tally = sweep::join_tallies(kept, open.sweep, open.identity);
    if (!tally) return tally.error() + kFolder;
    result.take(std::move(*tally));
    return {};
  }
  sweep::Parts parts(open.sweep, open.identity);
  for (const fs::path& path : kept) {
    if (std::string fault = parts.add(path); !fault.empty()) return fault;
  }
  if (const std::string missing = parts.missing_text(); !missing.empty()) return missing + kFolder;
  return parts.for_each([&](const sweep::SampleOutcome& outcome) { result.take(outcome); });
}

/// Writes the result and removes what the ranks have left.
int write_result(const OpenSweep& open, const FarmSweepOptions& options, std::size_t recalled,
                 const farm::Farm& farm, SweepResult& result) {
  const std::vector<fs::path> kept = kept_in(open, options);
  if (const std::string fault = join(open, options, kept, result); !fault.empty()) {
    return terminal::refuse(base::kExitEnvironment, fault);
  }
  std::string how = fmt::format("by {} {}", farm.ranks, farm.ranks == 1 ? "rank" : "ranks");
  if (recalled > 0) how += fmt::format(", {} of the chunks from a run before", recalled);
  const int code = result.finish(how);
  std::error_code ignored;  // one that stays is no fault of the result
  for (const fs::path& path : kept) {
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
                                               .no_rows = options.no_rows,
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
    fault = run_own_share(*open, options, done, farm);
    ready = farm.agree(fault.empty());
  }
  if (!fault.empty()) return terminal::refuse(base::kExitEnvironment, fault);
  if (!ready || farm.rank != 0) return base::kExitOk;
  const auto recalled = static_cast<std::size_t>(std::count(done.begin(), done.end(), 1));
  return write_result(*open, options, recalled, farm, *result);
}

}  // namespace slipbench::driver::commands
