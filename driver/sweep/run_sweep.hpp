// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "driver/sweep/packed_run.hpp"
#include "driver/sweep/sweep.hpp"

namespace slipbench::driver::sweep {

/// Outcome of one sample.
struct SampleOutcome {
  std::size_t id = 0;               ///< from 0 on
  std::span<const double> values;   ///< of the varied parameters
  std::span<const double> numbers;  ///< what was collected; all nan if it failed
  std::string_view failure;         ///< a sentence, or empty
};

/// Successive samples that one thread runs, and what came out.
struct Chunk {
  std::size_t first = 0;
  std::size_t count = 0;
  std::vector<double> values;         ///< of the varied parameters, sample by sample
  std::vector<double> numbers;        ///< what was collected, likewise
  std::vector<std::string> failures;  ///< a sentence each, or empty

  /// Makes room; at least one sample.
  Chunk(const Sweep& sweep, std::size_t first_sample, std::size_t samples);

  std::size_t end() const { return first + count; }
  /// Of sample `first + sample`.
  SampleOutcome outcome(std::size_t sample) const;
};

/// The most samples of a chunk; depends on the sweep only.
std::size_t chunk_size(const Sweep& sweep);

/// Tells whether samples at the edges of what is varied come out of packs as out of runs of their
/// own, in all bits. Only the reader knows for sure what follows from a parameter.
bool agrees(const Sweep& sweep, const PackedRun& packed);

/// Sets up the way of many samples through the history together; null where there is none, or one
/// that does not agree.
/// \param sweep must outlive it
std::unique_ptr<PackedRun> packed_run(const Sweep& sweep);

/// Runs the samples of a chunk, whose values are there, on the caller's thread.
/// \param packed of the sweep, which saves time and changes nothing; or null
void run_chunk(const Sweep& sweep, Chunk& chunk, const PackedRun* packed = nullptr);

struct SweepOptions {
  unsigned threads = 1;
  std::size_t first = 0;                                      ///< sample
  std::size_t end = std::numeric_limits<std::size_t>::max();  ///< the samples end before it
  std::size_t chunk = 0;  ///< samples that a thread takes at once; 0: chunk_size
  bool packs = true;      ///< samples that can go together do: it saves time and changes nothing
  std::function<void(std::size_t done, std::size_t failed)> progress = {};
  /// Asked before each chunk, by the thread that runs it; after a no the sweep ends early.
  std::function<bool()> go_on = {};
  /// Fills numbers and failures of a chunk that was run before; false if it has to be run. Called
  /// by several threads, as the next one.
  std::function<bool(Chunk&)> recall = {};
  /// Takes a chunk as soon as it was run, in any order.
  std::function<void(const Chunk&)> finished = {};
};

/// Runs all samples and hands out each in the order of their ids, whatever the threads do; memory
/// does not grow with their number. Nothing is thrown by a sample that fails.
void run_sweep(const Sweep& sweep, const SweepOptions& options,
               const std::function<void(const SampleOutcome&)>& take);

}  // namespace slipbench::driver::sweep
