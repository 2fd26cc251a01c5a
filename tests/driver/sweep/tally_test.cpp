// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/tally.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/report/sweep_page.hpp"
#include "driver/sweep/samples.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

/// A sweep of 4000 samples in rows of four, of which those with mu below 0 fail.
Sweep sweep_in(const TemporaryFolder& folder) {
  folder.write("slot.yaml", kSlot);
  const fs::path file = folder.write(
      "s.yaml",
      "slipbench: 1\nsweep:\n  case: slot.yaml\n  samples: 1000\n"
      "  sobol_indices: true\n"
      "  vary: {mu: {uniform: [-0.001, 0.3]}, k: {uniform: [100, 1000]}}\n"
      "  collect: {end: {last: CSF1}, rises: {first_passage: {of: CSF1, above: 9}}}\n");
  ReadSweep read = read_sweep(file.string());
  REQUIRE(read.value.has_value());
  return std::move(*read.value);
}

struct Given {
  TemporaryFolder folder;
  Sweep sweep = sweep_in(folder);
  std::string identity = std::string(64, 'a');
  fs::path path = folder.path() / "s.tally";

  std::unique_ptr<RunningTally> open(const std::optional<Part>& part = {}) const {
    auto tally = RunningTally::open(path, sweep, identity, part, false);
    INFO((tally ? "" : tally.error()));
    REQUIRE(tally.has_value());
    return std::move(*tally);
  }
  std::string fault() const {
    const auto tally = RunningTally::open(path, sweep, identity, {}, false);
    REQUIRE_FALSE(tally.has_value());
    REQUIRE(tally.error().starts_with(path.string() + ": "));
    return tally.error().substr(path.string().size() + 2);
  }
  /// Runs samples that the tally lacks; returns how many.
  std::size_t run(RunningTally& tally, SampleRange range) const {
    std::size_t count = 0;
    run_sweep(sweep,
              {.first = range.first,
               .end = range.end,
               .recall = [&](Chunk& chunk) { return tally.has(chunk); },
               .finished =
                   [&](const Chunk& chunk) {
                     tally.add(chunk);
                     count += chunk.count;
                   }},
              [](const SampleOutcome&) {});
    return count;
  }
  /// All that is told of a tally.
  std::string told(const Tally& tally) const {
    return tally.summary.text() + tally.summary.to_json().dump() + tally.indices->csv() +
           sweep_page(sweep, tally.summary, tally.indices, tally.kept);
  }
  std::string told_of_all() const {
    Tally tally(sweep);
    run_sweep(sweep, {}, [&](const SampleOutcome& one) { tally.add(one); });
    return told(tally);
  }
};

TEST_CASE("Tallies of parts tell the same as one run, whoever ran what in which order") {
  const Given given;
  const std::string whole = given.told_of_all();
  CHECK_THAT(whole, Catch::Contains("samples failed, the first is "));
  std::vector<fs::path> paths;
  for (const std::size_t number : std::vector<std::size_t>{3, 1, 4, 2}) {
    const Part part{number, 4};
    const fs::path path = given.folder.path() / (result_name(given.sweep, part) + ".tally");
    auto tally = RunningTally::open(path, given.sweep, given.identity, part, false);
    REQUIRE(tally.has_value());
    given.run(**tally, part.range(given.sweep));
    CHECK((*tally)->finish().empty());
    paths.push_back(path);
  }
  auto joined = join_tallies(paths, given.sweep, given.identity);
  REQUIRE(joined.has_value());
  CHECK(given.told(*joined) == whole);
  std::sort(paths.begin(), paths.end());
  CHECK(tallies_in(given.folder.path(), given.sweep) == paths);

  paths.push_back(paths.front());
  CHECK_THAT(join_tallies(paths, given.sweep, given.identity).error(),
             Catch::Contains("s.1of4.tally: has samples that another one has, too"));
  paths = {paths[0], paths[3]};
  CHECK(join_tallies(paths, given.sweep, given.identity).error() ==
        "missing are samples 1000 to 2999: parts 2/4, 3/4");
}

TEST_CASE("A run goes on from its tally, by any number of threads") {
  const Given given;
  const std::string whole = given.told_of_all();
  std::size_t before = 0;
  {
    const auto tally = given.open();
    before = given.run(*tally, {512, 2048});
    CHECK(before == 1536);
    CHECK(tally->finish().empty());
  }
  const auto tally = given.open();
  CHECK(tally->recalled() == before);
  std::vector<Chunk> chunks;
  Samples samples(given.sweep);
  for (std::size_t first = 0; first < 4000; first += 128) {
    chunks.emplace_back(given.sweep, first, std::min<std::size_t>(128, 4000 - first));
    samples.take(chunks.back().values);
    run_chunk(given.sweep, chunks.back());
  }
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < chunks.size(); i += 3) {
        if (!tally->has(chunks[i])) tally->add(chunks[i]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(tally->finish().empty());
  CHECK(tally->total().missing(4000).empty());
  CHECK(tally->total().done.size() == 1);
  CHECK(given.told(tally->total().tally) == whole);
  // What is written is the whole of it.
  CHECK(given.told(read_tally(given.path, given.sweep, given.identity)->tally) == whole);
}

TEST_CASE("A chunk of which some samples are there is no part of a tally") {
  const Given given;
  const auto tally = given.open();
  given.run(*tally, {0, 128});
  Chunk chunk(given.sweep, 64, 128);
  run_chunk(given.sweep, chunk);
  CHECK_FALSE(tally->has(chunk));
  CHECK(tally->finish().empty());
  const auto again = given.open();
  again->add(chunk);
  CHECK_THAT(again->finish(), Catch::Contains("has some samples of a chunk and not all"));
}

TEST_CASE("A tally that is damaged or foreign is refused in a sentence") {
  const Given given;
  {
    const auto tally = given.open(Part{1, 2});
    given.run(*tally, {0, 256});
    CHECK(tally->finish().empty());
  }
  const std::string bytes = file_text(given.path);
  for (const std::size_t length : {bytes.size() - 1, bytes.size() / 2, bytes.find("# part") + 9}) {
    given.folder.write("s.tally", bytes.substr(0, length));
    CHECK(given.fault() == "is damaged: not what was written");
  }
  std::string wrong = bytes;
  wrong[bytes.size() / 2] ^= 1;
  given.folder.write("s.tally", wrong);
  CHECK(given.fault() == "is damaged: not what was written");
  given.folder.write("s.tally", "id,mu\n1,2\n");
  CHECK(given.fault() == "is no tally of a sweep");
  given.folder.write("s.tally", bytes);
  CHECK(read_tally(given.path, given.sweep, given.identity)->part->count == 2);
  Given other;
  other.path = given.path;
  other.identity[5] = 'b';
  CHECK(other.fault() ==
        "is of another state of this sweep: an input, a setting or the program has changed since");
  other.sweep.file = "t.yaml";
  CHECK(other.fault() == "is of another sweep, or of another version of tallies");
}

}  // namespace
}  // namespace slipbench::driver::sweep
