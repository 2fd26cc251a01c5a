// SPDX-License-Identifier: Apache-2.0
#include "driver/farm/run_farm.hpp"

#include <algorithm>
#include <memory>

#include "driver/sweep/packed_run.hpp"
#include "driver/sweep/samples.hpp"

namespace slipbench::driver::farm {

std::uint64_t batch_size(std::uint64_t left, std::size_t ranks) {
  // The last to finish was at most this part of a rank's work behind when it took its batch.
  constexpr std::uint64_t kBatchesARank = 8;
  return std::max<std::uint64_t>(1, left / (kBatchesARank * ranks));
}

std::vector<char> done_chunks(const sweep::Sweep& sweep) {
  const std::size_t size = sweep::chunk_size(sweep);
  return std::vector<char>((sweep.samples + size - 1) / size);
}

void mark_done(const sweep::Sweep& sweep, std::span<const sweep::JournalRecord> records,
               std::span<char> done) {
  const std::size_t size = sweep::chunk_size(sweep);
  for (const sweep::JournalRecord& record : records) {
    const bool whole =
        record.first % size == 0 && record.count == std::min(size, sweep.samples - record.first);
    if (whole) done[record.first / size] = 1;
  }
}

void mark_done(const sweep::Sweep& sweep, const sweep::PartialTally& tally, std::span<char> done) {
  const std::size_t size = sweep::chunk_size(sweep);
  for (std::size_t i = 0; i < done.size(); ++i) {
    const std::size_t first = i * size;
    if (tally.has({first, std::min(first + size, sweep.samples)})) done[i] = 1;
  }
}

void run_farm(const sweep::Sweep& sweep, std::span<const char> done, const Farm& farm,
              const std::function<void(const sweep::Chunk&)>& finished) {
  const std::size_t size = sweep::chunk_size(sweep);
  const auto open = static_cast<std::uint64_t>(std::count(done.begin(), done.end(), 0));
  const std::unique_ptr<sweep::PackedRun> packed = open > 0 ? sweep::packed_run(sweep) : nullptr;
  sweep::Samples samples(sweep);
  std::size_t next_sample = 0;
  std::size_t chunk = 0;     // the batches of a rank follow each other,
  std::uint64_t before = 0;  // and so many chunks before this one were open
  std::uint64_t from = 0;
  while (true) {
    const std::uint64_t batch = batch_size(open - std::min(from, open), farm.ranks);
    from = farm.advance(batch);
    if (from >= open) return;
    const std::uint64_t end = std::min(from + batch, open);
    for (; before < end; ++chunk) {
      if (done[chunk] != 0) continue;
      if (before++ < from) continue;
      const std::size_t first = chunk * size;
      sweep::Chunk work(sweep, first, std::min(size, sweep.samples - first));
      samples.skip(first - next_sample);
      samples.take(work.values);
      next_sample = work.end();
      sweep::run_chunk(sweep, work, packed.get());
      finished(work);
    }
  }
}

}  // namespace slipbench::driver::farm
