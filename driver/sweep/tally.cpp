// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "driver/base/files/regular_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/hash.hpp"
#include "driver/sweep/state_bytes.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "# slipbench tally ";
constexpr std::string_view kPart = "# part: ";

std::string first_lines(const Sweep& sweep) {
  return fmt::format("{}1\n# sweep: {}\n", kMark, file_name(sweep));
}

std::string head_of(const Sweep& sweep, const std::string& identity) {
  return fmt::format("{}# identity: {}\n# samples: {}\n# bytes: {}\n", first_lines(sweep), identity,
                     sweep.samples,
                     std::endian::native == std::endian::little ? "least first" : "most first");
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Tally::Tally(const Sweep& sweep) : summary(sweep), kept(sweep) {
  if (sweep.sobol_indices) indices.emplace(sweep);
}

void Tally::add(const SampleOutcome& outcome) {
  summary.add(outcome);
  kept.add(outcome);
  if (indices) indices->add(outcome);
}

void Tally::add(const Tally& other) {
  summary.add(other.summary);
  kept.add(other.kept);
  if (indices) indices->add(*other.indices);
}

void PartialTally::add(const Chunk& chunk) {
  for (std::size_t i = 0; i < chunk.count; ++i) tally.add(chunk.outcome(i));
  mark({chunk.first, chunk.end()});
}

bool PartialTally::add(const PartialTally& other) {
  for (const auto& [first, end] : other.done) {
    if (touches({first, end})) return false;
  }
  tally.add(other.tally);
  for (const auto& [first, end] : other.done) mark({first, end});
  return true;
}

bool PartialTally::touches(SampleRange range) const {
  const auto after = done.lower_bound(range.end);
  return after != done.begin() && std::prev(after)->second > range.first;
}

bool PartialTally::has(SampleRange range) const {
  const auto after = done.upper_bound(range.first);
  return after != done.begin() && std::prev(after)->second >= range.end;
}

/// Joins a range with those that it meets.
void PartialTally::mark(SampleRange range) {
  auto next = done.lower_bound(range.first);
  if (next != done.begin() && std::prev(next)->second == range.first) {
    next = std::prev(next);
    range.first = next->first;
    next = done.erase(next);
  }
  if (next != done.end() && next->first == range.end) {
    range.end = next->second;
    done.erase(next);
  }
  done[range.first] = range.end;
}

std::vector<SampleRange> PartialTally::missing(std::size_t end) const {
  std::vector<SampleRange> gaps;
  std::size_t next = 0;
  for (const auto& [first, own_end] : done) {
    if (first > next) gaps.push_back({next, first});
    next = own_end;
  }
  if (next < end) gaps.push_back({next, end});
  return gaps;
}

base::FileMark tally_mark(const Sweep& sweep) {
  return {"a tally of " + file_name(sweep), first_lines(sweep)};
}

tl::expected<PartialTally, std::string> read_tally(const fs::path& path, const Sweep& sweep,
                                                   const std::string& identity) {
  auto stream = base::open_regular(path);
  if (!stream) return tl::unexpected(stream.error());
  const std::string file((std::istreambuf_iterator<char>(*stream)), {});
  std::string_view bytes = file;
  const auto fault = [&](const char* what) { return tl::unexpected(path.string() + ": " + what); };
  if (!bytes.starts_with(kMark)) return fault("is no tally of a sweep");
  if (!bytes.starts_with(first_lines(sweep))) {
    return fault("is of another sweep, or of another version of tallies");
  }
  const std::string head = head_of(sweep, identity);
  if (!bytes.starts_with(head)) {
    return fault(
        "is of another state of this sweep: an input, a setting or the program has changed since");
  }
  bytes.remove_prefix(head.size());
  PartialTally read(sweep);
  if (bytes.starts_with(kPart)) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1);
    read.part = part_of(bytes.substr(kPart.size(), end - kPart.size()));
    bytes.remove_prefix(end + 1);
  }
  std::uint64_t hash = 0;
  const bool whole = bytes.size() >= sizeof hash;
  if (whole) std::memcpy(&hash, bytes.data() + bytes.size() - sizeof hash, sizeof hash);
  if (whole) bytes.remove_suffix(sizeof hash);
  StateReader reader(bytes);
  if (whole && base::hash(bytes) == hash) reader(read);
  if (!whole || !reader.complete()) return fault("is damaged: not what was written");
  return read;
}

tl::expected<Tally, std::string> join_tallies(std::span<const fs::path> paths, const Sweep& sweep,
                                              const std::string& identity) {
  PartialTally total(sweep);
  std::vector<Part> parts;
  for (const fs::path& path : paths) {
    const auto read = read_tally(path, sweep, identity);
    if (!read) return tl::unexpected(read.error());
    if (!total.add(*read)) {
      return tl::unexpected(path.string() +
                            ": has samples that another one has, too: they would count twice");
    }
    if (read->part) parts.push_back(*read->part);
  }
  std::string missing = missing_text(sweep, total.missing(sweep.samples), parts);
  if (!missing.empty()) return tl::unexpected(std::move(missing));
  return std::move(total.tally);
}

std::vector<fs::path> tallies_in(const fs::path& folder, const Sweep& sweep) {
  return files_in(folder, sweep, R"((\.rank\d+|\.\d+of\d+)?\.tally)");
}

RunningTally::RunningTally(fs::path path, const Sweep& sweep, const std::string& identity)
    : path_(std::move(path)),
      sweep_(&sweep),
      identity_(&identity),
      before_(sweep),
      total_(sweep),
      written_(now()) {}

tl::expected<std::unique_ptr<RunningTally>, std::string> RunningTally::open(
    const fs::path& path, const Sweep& sweep, const std::string& identity,
    const std::optional<Part>& part, bool anew) {
  std::unique_ptr<RunningTally> running(new RunningTally(path, sweep, identity));
  running->anew_ = anew;
  std::error_code none;
  if (!anew && fs::exists(path, none)) {
    auto read = read_tally(path, sweep, identity);
    if (!read) return tl::unexpected(read.error());
    running->recalled_ = read->samples();
    running->before_ = *read;
    running->total_ = std::move(*read);
  }
  running->total_.part = part;
  // That it cannot be written is told before anything is run.
  running->write();
  if (!running->error_.empty()) return tl::unexpected(running->error_);
  return running;
}

bool RunningTally::has(const Chunk& chunk) const { return before_.has({chunk.first, chunk.end()}); }

void RunningTally::add(const Chunk& chunk) {
  // An interruption costs a second, or where writing takes long so much that it stays 2 % of all.
  constexpr double kShortest = 1.0;
  constexpr double kTimesWriting = 50.0;
  std::unique_ptr<PartialTally> own;
  {
    const std::lock_guard lock(mutex_);
    if (!free_.empty()) {
      own = std::move(free_.back());
      free_.pop_back();
    }
  }
  if (!own) own = std::make_unique<PartialTally>(*sweep_);
  own->add(chunk);
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(own));
  if (now() - written_ < std::max(kShortest, kTimesWriting * writing_)) return;
  fold();
  write();
}

/// Brings what threads have added into the total.
void RunningTally::fold() {
  for (const auto& one : free_) {
    if (!total_.add(*one) && error_.empty()) {
      error_ = path_.string() + ": has some samples of a chunk and not all";
    }
  }
  free_.clear();
}

void RunningTally::write() {
  if (!error_.empty()) return;
  const double begin = now();
  auto file = base::OutputFile::create(path_, tally_mark(*sweep_), {.force = anew_});
  if (!file) {
    error_ = file.error();
    return;
  }
  StateWriter state;
  state(total_);
  file->append(head_of(*sweep_, *identity_));
  if (total_.part) {
    file->append(fmt::format("{}{}/{}\n", kPart, total_.part->number, total_.part->count));
  }
  file->append(state.bytes());
  StateWriter hash;
  std::uint64_t number = base::hash(state.bytes());
  hash(number);
  file->append(hash.bytes());
  base::OutputFile* const files[] = {&*file};
  if (auto committed = base::commit(files); !committed) error_ = committed.error();
  written_ = now();
  writing_ = written_ - begin;
}

std::string RunningTally::finish() {
  const std::lock_guard lock(mutex_);
  fold();
  write();
  return error_;
}

void RunningTally::remove() const {
  std::error_code ignored;  // one that stays is no fault of the result
  fs::remove(path_, ignored);
}

}  // namespace slipbench::driver::sweep
