// SPDX-License-Identifier: Apache-2.0
#include "driver/farm/run_farm.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "driver/farm/run_shared.hpp"
#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/rows.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::farm {
namespace {

sweep::Sweep sweep_of(const TemporaryFolder& folder, int samples) {
  folder.write("slot.yaml", sweep::kSlot);
  const auto file = folder.write(
      "s.yaml", "slipbench: 1\nsweep:\n  case: slot.yaml\n  samples: " + std::to_string(samples) +
                    "\n  vary: {mu: {uniform: [-0.001, 0.3]}, k: {uniform: [100, 1000]}}\n"
                    "  collect: {end: {last: CSF1}, slips: {count: stick_to_slip}}\n");
  sweep::ReadSweep read = sweep::read_sweep(file.string());
  REQUIRE(read.value.has_value());
  return std::move(*read.value);
}

/// Chunks that some ranks have run, each rank a thread, by their order.
std::vector<sweep::Chunk> run_ranks(const sweep::Sweep& given, const std::vector<char>& done,
                                    std::size_t ranks) {
  std::atomic<std::uint64_t> counter{0};
  std::mutex mutex;
  std::vector<sweep::Chunk> chunks;
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    threads.emplace_back([&, rank] {
      Farm farm;
      farm.rank = rank;
      farm.ranks = ranks;
      farm.advance = [&](std::uint64_t count) { return counter.fetch_add(count); };
      // An expression is of one thread: every rank has read the sweep itself.
      const sweep::Sweep own = sweep::read_sweep(given.file).value.value();
      run_farm(own, done, farm, [&](const sweep::Chunk& chunk) {
        const std::scoped_lock lock(mutex);
        chunks.push_back(chunk);
      });
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::sort(chunks.begin(), chunks.end(),
            [](const sweep::Chunk& a, const sweep::Chunk& b) { return a.first < b.first; });
  return chunks;
}

std::string rows_of(const sweep::SampleOutcome& outcome) {
  std::string text;
  sweep::append_row(outcome, text);
  return text + std::string(outcome.failure) + "\n";
}

TEST_CASE("ranks run every chunk once, to the rows of one run") {
  const TemporaryFolder folder;
  const sweep::Sweep given = sweep_of(folder, 1000);
  std::string expected;
  run_sweep(given, {}, [&](const sweep::SampleOutcome& one) { expected += rows_of(one); });
  const std::vector<char> none = done_chunks(given);
  REQUIRE(none.size() == (1000 + sweep::chunk_size(given) - 1) / sweep::chunk_size(given));
  for (const std::size_t ranks : {1U, 2U, 5U, 40U}) {
    INFO(ranks << " ranks");
    std::string found;
    for (const sweep::Chunk& chunk : run_ranks(given, none, ranks)) {
      for (std::size_t i = 0; i < chunk.count; ++i) found += rows_of(chunk.outcome(i));
    }
    CHECK(found == expected);
  }
}

TEST_CASE("ranks leave out the chunks that are done, and only whole ones are") {
  const TemporaryFolder folder;
  const sweep::Sweep given = sweep_of(folder, 1000);
  const std::size_t size = sweep::chunk_size(given);
  std::vector<char> done = done_chunks(given);
  const std::vector<sweep::JournalRecord> records{{0, size},
                                                  {2 * size, size - 1},
                                                  {3 * size + 1, size},
                                                  {(done.size() - 1) * size, 1000 % size}};
  mark_done(given, records, done);
  CHECK(std::count(done.begin(), done.end(), 1) == 2);
  CHECK(done.front() == 1);
  CHECK(done.back() == 1);
  const std::vector<sweep::Chunk> chunks = run_ranks(given, done, 3);
  REQUIRE(chunks.size() == done.size() - 2);
  for (std::size_t i = 0; i < chunks.size(); ++i) CHECK(chunks[i].first == (i + 1) * size);
  std::fill(done.begin(), done.end(), char{1});
  CHECK(run_ranks(given, done, 2).empty());
}

TEST_CASE("items are run once, and all ranks get what all made") {
  constexpr std::size_t kRanks = 3;
  std::atomic<std::uint64_t> counter{7};
  std::atomic<int> runs{0};
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<double> gathered;
  std::size_t gatherers = 0;
  std::size_t starters = 0;
  const auto wait_for = [&](std::unique_lock<std::mutex>& lock, const std::size_t& count) {
    changed.notify_all();
    changed.wait(lock, [&] { return count == kRanks; });
  };
  std::vector<std::vector<std::vector<double>>> made(kRanks);
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < kRanks; ++rank) {
    threads.emplace_back([&, rank] {
      Farm farm;
      farm.advance = [&](std::uint64_t count) { return counter.fetch_add(count); };
      farm.restart = [&] {
        std::unique_lock lock(mutex);
        if (++starters == kRanks) counter = 0;
        wait_for(lock, starters);
      };
      farm.gather = [&](std::span<const double> own) {
        std::unique_lock lock(mutex);
        gathered.insert(gathered.end(), own.begin(), own.end());
        ++gatherers;
        wait_for(lock, gatherers);
        return gathered;
      };
      made[rank] = run_shared(farm, 50, [&](std::size_t i) {
        ++runs;
        return std::vector<double>(i % 4, 0.5 * static_cast<double>(i));
      });
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(runs == 50);
  for (const auto& all : made) {
    REQUIRE(all.size() == 50);
    for (std::size_t i = 0; i < all.size(); ++i) {
      CHECK(all[i] == std::vector<double>(i % 4, 0.5 * static_cast<double>(i)));
    }
  }
}

TEST_CASE("batches shrink towards the end, and are never empty") {
  CHECK(batch_size(0, 3) == 1);
  CHECK(batch_size(1, 1000) == 1);
  CHECK(batch_size(8000, 10) == 100);
  // All is taken in so few steps: a rank asks some dozen times, whatever there is to do.
  std::uint64_t left = 8'000'000;
  int steps = 0;
  for (; left > 0; ++steps) left -= std::min(left, batch_size(left, 64));
  CHECK(steps < 64 * 120);
}

}  // namespace
}  // namespace slipbench::driver::farm
