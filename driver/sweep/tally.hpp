// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/sweep/kept_samples.hpp"
#include "driver/sweep/part.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sobol_indices.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/sweep/sweep_summary.hpp"

namespace slipbench::driver::sweep {

/// All that is told of samples without their rows. It has the same bits whatever the order in which
/// they come and however they were divided; its memory does not grow with their number.
struct Tally {
  SweepSummary summary;
  std::optional<SobolEstimate> indices;  ///< where the sweep wants them
  KeptSamples kept;

  explicit Tally(const Sweep& sweep);

  /// Takes a sample; with Sobol' indices those of a row come one after the other.
  void add(const SampleOutcome& outcome);
  /// Takes all samples of another tally of the same sweep.
  void add(const Tally& other);

  void fields(auto& archive) {
    archive(summary, kept);
    if (indices) archive(*indices);
  }
};

/// Tally of some samples, and which they are.
struct PartialTally {
  Tally tally;
  std::map<std::size_t, std::size_t> done = {};  ///< first samples of ranges, and their ends
  std::optional<Part> part = std::nullopt;       ///< of the sweep, that was asked for

  explicit PartialTally(const Sweep& sweep) : tally(sweep) {}

  /// Takes the samples of a chunk, of which none may be there yet.
  void add(const Chunk& chunk);
  /// Takes the samples of another one; false, and nothing is taken, if some are there already.
  bool add(const PartialTally& other);
  /// Tells whether all samples of a range are there.
  bool has(SampleRange range) const;
  /// Finds the samples before `end` that are not there.
  std::vector<SampleRange> missing(std::size_t end) const;
  std::size_t samples() const { return tally.summary.samples(); }

  void fields(auto& archive) { archive(tally, done); }

 private:
  void mark(SampleRange range);
  bool touches(SampleRange range) const;
};

/// The head by which a tally file of a sweep, or of a part of it, may be replaced.
base::FileMark tally_mark(const Sweep& sweep);

/// Reads a tally. Errors are sentences that begin with its path: it cannot be read, is of another
/// sweep or of another state of it, or is damaged.
tl::expected<PartialTally, std::string> read_tally(const std::filesystem::path& path,
                                                   const Sweep& sweep, const std::string& identity);

/// Reads tallies that together have every sample once. Errors are sentences.
tl::expected<Tally, std::string> join_tallies(std::span<const std::filesystem::path> paths,
                                              const Sweep& sweep, const std::string& identity);

/// The tallies of a sweep, of its parts and of the ranks of a farm in a folder, sorted by their
/// names.
std::vector<std::filesystem::path> tallies_in(const std::filesystem::path& folder,
                                              const Sweep& sweep);

/// Tally to which many threads add chunks, and which is in a file every second or so, as it is
/// between two chunks: what an interruption leaves can be gone on with.
///   head   lines that start with "# ": version, sweep, identity, samples, part, order of bytes
///   then   the members (state_bytes.hpp), and their FNV-1a hash (8 bytes)
class RunningTally {
 public:
  /// \param sweep,identity must outlive it
  /// \param anew whatever is at that place is replaced; else it is gone on with
  static tl::expected<std::unique_ptr<RunningTally>, std::string> open(
      const std::filesystem::path& path, const Sweep& sweep, const std::string& identity,
      const std::optional<Part>& part, bool anew);

  const std::filesystem::path& path() const { return path_; }
  /// Samples that were in the file when it was opened.
  std::size_t recalled() const { return recalled_; }

  /// Tells whether the samples of a chunk are there. Any thread.
  bool has(const Chunk& chunk) const;
  /// Takes a chunk that was run. Any thread.
  void add(const Chunk& chunk);

  /// Writes the file with all chunks; when none is being added. A sentence if it cannot, or could
  /// not before.
  std::string finish();
  /// Of all chunks, after `finish`.
  const PartialTally& total() const { return total_; }

  /// Removes the file: what it kept is at its place.
  void remove() const;

 private:
  RunningTally(std::filesystem::path path, const Sweep& sweep, const std::string& identity);
  void fold();
  void write();

  std::filesystem::path path_;
  const Sweep* sweep_;
  const std::string* identity_;
  bool anew_ = false;
  std::size_t recalled_ = 0;
  PartialTally before_;  ///< as it was in the file, so that it can be asked without a lock
  std::mutex mutex_;
  PartialTally total_;
  std::vector<std::unique_ptr<PartialTally>> free_;  ///< those that no thread adds to
  double written_ = 0.0;                             ///< when [s]
  double writing_ = 0.0;                             ///< how long that took [s]
  std::string error_;
};

}  // namespace slipbench::driver::sweep
