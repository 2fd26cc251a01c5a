// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/journal.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "driver/sweep/merge.hpp"
#include "driver/sweep/read_sweep.hpp"
#include "driver/sweep/rows.hpp"
#include "tests/driver/support/files_for_test.hpp"
#include "tests/driver/support/temporary_folder.hpp"
#include "tests/driver/sweep/sweep_for_test.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;
using Use = Journal::Use;

/// A sweep of 1000 samples, of which those with mu below 0 fail.
Sweep sweep_in(const TemporaryFolder& folder) {
  folder.write("slot.yaml", kSlot);
  const fs::path file =
      folder.write("s.yaml",
                   "slipbench: 1\nsweep:\n  case: slot.yaml\n  samples: 1000\n"
                   "  vary: {mu: {uniform: [-0.001, 0.3]}, k: {uniform: [100, 1000]}}\n"
                   "  collect: {end: {last: CSF1}, slips: {count: stick_to_slip}}\n");
  ReadSweep read = read_sweep(file.string());
  REQUIRE(read.value.has_value());
  return std::move(*read.value);
}

struct Given {
  TemporaryFolder folder;
  Sweep sweep = sweep_in(folder);
  std::string identity = std::string(64, 'a');
  fs::path path = folder.path() / "s.journal";

  std::unique_ptr<Journal> open(Use use = Use::kGoOn) const {
    auto journal = Journal::open(path, sweep, identity, use);
    INFO((journal ? "" : journal.error()));
    REQUIRE(journal.has_value());
    return std::move(*journal);
  }
  std::string fault(Use use = Use::kGoOn) const {
    const auto journal = Journal::open(path, sweep, identity, use);
    REQUIRE_FALSE(journal.has_value());
    REQUIRE(journal.error().starts_with(path.string() + ": "));
    return journal.error().substr(path.string().size() + 2);
  }
  /// The lines of samples, as a run gives them.
  std::string rows(const SweepOptions& options) const {
    std::string text;
    run_sweep(sweep, options, [&](const SampleOutcome& one) {
      append_row(one, text);
      text += std::string(one.failure) + "\n";
    });
    return text;
  }
  /// Runs some samples into the journal.
  void run(std::size_t first, std::size_t end) const {
    const auto journal = open();
    rows({.first = first, .end = end, .finished = [&](const Chunk& one) { journal->append(one); }});
    CHECK(journal->error().empty());
  }
};

TEST_CASE("A sweep goes on from a journal with the same rows and runs only what is missing") {
  const Given given;
  const std::string whole = given.rows({.threads = 2});
  given.run(256, 640);
  for (const bool cut : {false, true}) {
    // The second time, the last record is torn.
    if (cut) fs::resize_file(given.path, fs::file_size(given.path) - 5);
    const auto journal = given.open();
    CHECK((journal->dropped() > 0) == cut);
    std::size_t run = 0;
    SweepOptions options;
    options.recall = [&](Chunk& chunk) { return journal->recall(chunk); };
    options.finished = [&](const Chunk& chunk) { run += chunk.count; };
    CHECK(given.rows(options) == whole);
    CHECK(run == (cut ? 1000 - 256 : 1000 - 384));
  }
}

TEST_CASE("A torn journal is cut where its last whole record ends, wherever it was torn") {
  const Given given;
  given.run(0, 256);
  const std::string bytes = file_text(given.path);
  const std::string whole = given.rows({});
  const std::size_t head = bytes.find("least first\n") + 12;
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, head, head + 3, head + 30,
                                   bytes.size() / 2, bytes.size() - 1}) {
    INFO(length << " bytes");
    given.folder.write("s.journal", bytes.substr(0, length));
    const auto journal = given.open();
    CHECK(journal->records().size() == (length > head + (bytes.size() - head) / 2 ? 1 : 0));
    given.rows({.end = 256,
                .recall = [&](Chunk& chunk) { return journal->recall(chunk); },
                .finished = [&](const Chunk& one) { journal->append(one); }});
  }
  CHECK(given.open()->records().size() == 2);
}

TEST_CASE("A journal that is damaged, foreign or in use is refused in a sentence") {
  const Given given;
  given.run(0, 300);
  const std::string bytes = file_text(given.path);
  std::string wrong = bytes;
  wrong[wrong.find("least first\n") + 12 + 24 + 100] ^= 1;
  given.folder.write("s.journal", wrong);
  CHECK(given.fault() == "is damaged: the record at byte " +
                             std::to_string(bytes.find("least first\n") + 12) +
                             " is not what was written");
  wrong = bytes;
  wrong[wrong.find("least first\n") + 12 + 9] ^= 1;
  given.folder.write("s.journal", wrong);
  CHECK_THAT(given.fault(), Catch::Matchers::StartsWith("is damaged"));
  given.folder.write("s.journal", "id,mu\n1,2\n");
  CHECK(given.fault() == "is there already and is no journal");
  given.folder.write("s.journal", bytes);
  Given other;
  other.identity[5] = 'b';
  other.path = given.path;
  CHECK(other.fault() ==
        "is of another state of this sweep: an input, a setting or the program has changed since");
  other.sweep.file = "t.yaml";
  CHECK(other.fault() == "is of another sweep, or of another version of journals");
  {
    const auto open = given.open();
    CHECK(given.fault() == "is being written by another run of this sweep");
  }
  CHECK(given.open(Use::kAnew)->records().empty());
}

TEST_CASE("The identity of a sweep changes with its files and settings, not with their names") {
  const Given given;
  const fs::path a = given.folder.write("a.csv", "1\n");
  const fs::path b = given.folder.write("b.csv", "1\n");
  const fs::path c = given.folder.write("c.csv", "2\n");
  const auto of = [&](const fs::path& file, const Sweep& sweep) {
    const std::string files[] = {file.string()};
    return identity_of(sweep, files);
  };
  CHECK(of(a, given.sweep) == of(b, given.sweep));
  CHECK(of(a, given.sweep) != of(c, given.sweep));
  Sweep other = given.sweep;
  other.settings.push_back({"mu", "0.3"});
  CHECK(of(a, given.sweep) != of(a, other));
  CHECK(of(a, given.sweep).size() == 64);
}

/// Writes the rows of a part, as `sweep --part` does.
fs::path write_part(const Given& given, const Part& part) {
  std::string text = table::csv_head(rows_head(given.sweep, given.identity, part));
  run_sweep(given.sweep,
            {.first = part.range(given.sweep).first, .end = part.range(given.sweep).end},
            [&](const SampleOutcome& one) { append_row(one, text); });
  return given.folder.write(result_name(given.sweep, part) + ".csv", text);
}

/// Joins parts; the lines of all samples.
std::string joined(Parts& parts) {
  std::string text;
  REQUIRE(parts.missing_text().empty());
  const std::string fault =
      parts.for_each([&](const SampleOutcome& one) { append_row(one, text); });
  CHECK(fault.empty());
  return text;
}

TEST_CASE("Parts and journals that overlap are joined to the whole, failures among them") {
  const Given given;
  std::string whole;
  std::vector<std::string> failures;
  run_sweep(given.sweep, {}, [&](const SampleOutcome& one) {
    append_row(one, whole);
    if (!one.failure.empty()) failures.emplace_back(one.failure);
  });
  REQUIRE(failures.size() > 1);
  Parts of_rows(given.sweep, given.identity);
  for (const std::size_t number : {3U, 1U, 2U}) {
    CHECK(of_rows.add(write_part(given, {number, 3})).empty());
  }
  CHECK(joined(of_rows) == whole);
  Parts mixed(given.sweep, given.identity);
  given.run(600, 1000);
  CHECK(mixed.add(given.path).empty());
  CHECK(mixed.missing() == std::vector<SampleRange>{{0, 600}});
  CHECK(mixed.add(write_part(given, {2, 3})).empty());
  CHECK(mixed.missing_text() == "missing are samples 0 to 332: part 1/3");
  CHECK(mixed.add(write_part(given, {1, 3})).empty());
  std::vector<std::string> told;
  CHECK(mixed
            .for_each([&](const SampleOutcome& one) {
              if (!one.failure.empty()) told.emplace_back(one.failure);
            })
            .empty());
  CHECK(told.size() == failures.size());
  CHECK(told.front() == failures.front());
}

TEST_CASE("Parts that do not belong together, or are not whole, are refused") {
  const Given given;
  const fs::path path = write_part(given, {2, 4});
  const std::string text = file_text(path);
  const auto fault = [&](const std::string& changed) {
    given.folder.write("s.2of4.csv", changed);
    const std::string sentence = Parts(given.sweep, given.identity).add(path);
    return sentence.empty() ? sentence : sentence.substr(path.string().size());
  };
  CHECK(fault(text).empty());
  CHECK(fault(text.substr(0, text.size() - 1)) ==
        ": is damaged: the line of sample 499 is not there");
  CHECK(fault(text.substr(0, text.rfind('\n', text.size() - 2) + 1)) == ": ends before sample 499");
  std::string other = text;
  other.replace(other.find(given.identity), 1, "b");
  CHECK(
      fault(other) ==
      ": is of another state of this sweep: an input, a setting or the program has changed since");
  other = text;
  other.replace(other.find("s.yaml"), 1, "t");
  CHECK(fault(other) == ": is of another sweep");
  CHECK(fault("id,mu\n1,2\n") == ": is no part of a sweep");
  other = text;
  other.replace(other.find("\n300,") + 5, 1, "x");
  CHECK(fault(other).empty());  // found when it is read
  Parts parts(given.sweep, given.identity);
  for (const std::size_t number : {1U, 2U, 3U, 4U}) {
    if (number != 2) write_part(given, {number, 4});
    CHECK(parts.add(given.folder.path() / result_name(given.sweep, Part{number, 4}))
              .ends_with("cannot be read: No such file or directory"));
    CHECK(parts.add(given.folder.path() / (result_name(given.sweep, Part{number, 4}) + ".csv"))
              .empty());
  }
  CHECK_THAT(parts.for_each([](const SampleOutcome&) {}),
             Catch::Matchers::EndsWith("is damaged: the line of sample 300 cannot be read, or has "
                                       "other values than the sweep gives it"));
}

TEST_CASE("Parts may be more than files may be open at first, and one too many is told") {
  const Given given;
  constexpr std::size_t kParts = 100;
  std::vector<fs::path> paths;
  paths.reserve(kParts);
  for (std::size_t i = 1; i <= kParts; ++i) paths.push_back(write_part(given, {i, kParts}));
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  REQUIRE(before.rlim_max > 2 * kParts);
  const rlimit few{kParts / 2, before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_NOFILE, &few) == 0);
  std::vector<std::string> faults;
  faults.reserve(kParts);
  Parts parts(given.sweep, given.identity);
  for (const fs::path& path : paths) faults.push_back(parts.add(path));
  Parts others(given.sweep, given.identity);
  setrlimit(RLIMIT_NOFILE, &few);
  const std::string told = others.add(paths[0]);
  setrlimit(RLIMIT_NOFILE, &before);
  CHECK(std::all_of(faults.begin(), faults.end(), [](const auto& fault) { return fault.empty(); }));
  CHECK(parts.missing().empty());
  CHECK(told == paths[0].string() + ": cannot be read: Too many open files");
}

TEST_CASE("The files of a sweep in a folder are known by their names") {
  const Given given;
  for (const char* name : {"s.journal", "s.rank12.journal", "s.2of8.journal", "s.2of8.csv", "s.csv",
                           "s.t.journal", "st.journal", "s.rank1.csv"}) {
    given.folder.write(name, "");
  }
  const auto names = [](const std::vector<fs::path>& files) {
    std::string text;
    for (const fs::path& file : files) text += file.filename().string() + " ";
    return text;
  };
  CHECK(names(journals_in(given.folder.path(), given.sweep)) ==
        "s.2of8.journal s.journal s.rank12.journal ");
  CHECK(names(parts_in(given.folder.path(), given.sweep)) == "s.2of8.csv ");
}

}  // namespace
}  // namespace slipbench::driver::sweep
