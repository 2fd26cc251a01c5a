// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "driver/sweep/journal.hpp"
#include "driver/sweep/run_sweep.hpp"
#include "driver/sweep/sweep.hpp"
#include "driver/sweep/tally.hpp"

namespace slipbench::driver::farm {

/// Programs that share the work, the ranks 0 .. ranks - 1, by what they do together. Every rank
/// calls `agree` and `share` as often as every other, in the same order, and waits there for all.
struct Farm {
  std::size_t rank = 0;
  std::size_t ranks = 1;
  /// Adds to a counter of all ranks, which begins at 0, and returns what it was before.
  std::function<std::uint64_t(std::uint64_t)> advance;
  /// Tells whether it is true of all ranks.
  std::function<bool(bool)> agree;
  /// Gives all ranks the bytes of rank 0, as many as all have room for.
  std::function<void(std::span<char>)> share;
  /// Returns the numbers of all ranks, one rank's after the other's. As `agree`.
  std::function<std::vector<double>(std::span<const double>)> gather;
  /// Sets the counter back to 0. As `agree`.
  std::function<void()> restart;
};

/// Returns how many chunks a rank takes at once when `left` are left: many at first, so that the
/// counter is asked seldom, and one at the end, so that all ranks come to it together.
std::uint64_t batch_size(std::uint64_t left, std::size_t ranks);

/// The chunks of a sweep, in the order of the samples: 1 of those that a record or a tally has,
/// else 0.
std::vector<char> done_chunks(const sweep::Sweep& sweep);
void mark_done(const sweep::Sweep& sweep, std::span<const sweep::JournalRecord> records,
               std::span<char> done);
void mark_done(const sweep::Sweep& sweep, const sweep::PartialTally& tally, std::span<char> done);

/// Runs chunks until no rank has one left to take.
/// \param done of all chunks; the same for every rank
/// \param finished takes each chunk that this rank has run
void run_farm(const sweep::Sweep& sweep, std::span<const char> done, const Farm& farm,
              const std::function<void(const sweep::Chunk&)>& finished);

}  // namespace slipbench::driver::farm
