// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/merge.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "driver/base/files/regular_file.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/sweep/rows.hpp"
#include "driver/sweep/samples.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowsAtOnce = 128;

}  // namespace

Parts::Parts(const Sweep& sweep, const std::string& identity)
    : sweep_(&sweep), identity_(&identity) {
  // Usually 1024 files may be open, but a farm may have had more ranks.
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);  // where it fails, so does the file that is one too many
}

std::string Parts::add(const fs::path& file) {
  return file.extension() == ".journal" ? add_journal(file) : add_rows(file);
}

std::string Parts::add_journal(const fs::path& file) {
  auto journal = Journal::open(file, *sweep_, *identity_, Journal::Use::kRead);
  if (!journal) return journal.error();
  for (const JournalRecord& record : (*journal)->records()) {
    pieces_.push_back({record.first, record.count, journals_.size(), true, record});
  }
  journals_.push_back(std::move(*journal));
  return {};
}

std::string Parts::add_rows(const fs::path& file) {
  auto opened = base::open_regular(file);
  if (!opened) return opened.error();
  std::ifstream& in = *opened;
  std::string head;
  std::string line;
  std::optional<Part> part;
  constexpr std::string_view kPart = "# part: ";
  constexpr std::size_t kMostLines = 16;
  for (std::size_t i = 0; i < kMostLines && std::getline(in, line); ++i) {
    head += line + "\n";
    if (line.starts_with(kPart)) part = part_of(std::string_view(line).substr(kPart.size()));
    if (!line.starts_with("#")) break;
  }
  if (!part) return file.string() + ": is no part of a sweep";
  const std::string wanted = table::csv_head(rows_head(*sweep_, *identity_, part));
  if (head != wanted) {
    const bool same_sweep =
        head.find("\n# sweep: " + base::in_cells(file_name(*sweep_)) + "\n") != head.npos;
    return file.string() + (same_sweep ? ": is of another state of this sweep: an input, a setting "
                                         "or the program has changed since"
                                       : ": is of another sweep");
  }
  auto [id, end] = part->range(*sweep_);
  auto offset = static_cast<std::uint64_t>(head.size());
  while (std::getline(in, line)) {
    const std::string id_text = std::to_string(id) + ",";
    if (id == end || in.eof() || !line.starts_with(id_text)) {
      return fmt::format("{}: is damaged: the line of sample {} is not there", file.string(), id);
    }
    if (pieces_.empty() || pieces_.back().of_journal || pieces_.back().source != rows_.size() ||
        pieces_.back().count == kRowsAtOnce) {
      pieces_.push_back({id, 0, rows_.size(), false, {.offset = offset}});
    }
    ++pieces_.back().count;
    offset += line.size() + 1;
    ++id;
  }
  if (id < end) return fmt::format("{}: ends before sample {}", file.string(), id);
  parts_.push_back(*part);
  rows_.push_back({file, std::move(in)});
  return {};
}

std::vector<SampleRange> Parts::missing() const {
  std::vector<SampleRange> there;
  there.reserve(pieces_.size());
  for (const Piece& piece : pieces_) there.push_back({piece.first, piece.first + piece.count});
  std::sort(there.begin(), there.end(),
            [](const SampleRange& a, const SampleRange& b) { return a.first < b.first; });
  there.push_back({sweep_->samples, sweep_->samples});
  std::vector<SampleRange> gaps;
  std::size_t next = 0;
  for (const SampleRange& range : there) {
    if (range.first > next) gaps.push_back({next, range.first});
    next = std::max(next, range.end);
  }
  return gaps;
}

std::string Parts::read(const Piece& piece, std::size_t known, Chunk& chunk) {
  if (piece.of_journal) {
    const auto read = journals_[piece.source]->read(piece.record, chunk);
    return read ? "" : read.error();
  }
  Rows& rows = rows_[piece.source];
  rows.file.clear();
  rows.file.seekg(static_cast<std::streamoff>(piece.record.offset));
  const std::size_t depth = sweep_->collected.size();
  const std::size_t width = sweep_->varied.size();
  std::string line;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const bool there = static_cast<bool>(std::getline(rows.file, line));
    if (there && i < known) continue;
    const std::span<double> numbers = std::span(chunk.numbers).subspan(i * depth, depth);
    const std::span<const double> values = std::span(chunk.values).subspan(i * width, width);
    if (!there || !read_row(line, piece.first + i, values, numbers)) {
      return fmt::format(
          "{}: is damaged: the line of sample {} cannot be read, or has other values than the "
          "sweep gives it",
          rows.path.string(), piece.first + i);
    }
  }
  return {};
}

/// Rows do not say whether a sample failed, and why: all that was collected is nan, as it is where
/// there is no number to collect. Such samples are run again.
void Parts::give_reasons(Chunk& chunk, std::size_t from) {
  for (std::size_t i = from; i < chunk.count; ++i) {
    const SampleOutcome outcome = chunk.outcome(i);
    const bool may_have_failed = std::all_of(outcome.numbers.begin(), outcome.numbers.end(),
                                             [](double number) { return std::isnan(number); });
    if (!may_have_failed) continue;
    Chunk again(*sweep_, outcome.id, 1);
    again.values.assign(outcome.values.begin(), outcome.values.end());
    run_chunk(*sweep_, again);
    chunk.failures[i] = again.failures[0];
  }
}

std::string Parts::for_each(const std::function<void(const SampleOutcome&)>& take) {
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [](const Piece& a, const Piece& b) { return a.first < b.first; });
  const std::size_t width = sweep_->varied.size();
  Samples samples(*sweep_);
  std::size_t next = 0;
  for (const Piece& piece : pieces_) {
    const std::size_t end = piece.first + piece.count;
    if (end <= next) continue;
    Chunk chunk(*sweep_, piece.first, piece.count);
    const std::size_t known = next - std::min(next, piece.first);
    samples.take(std::span(chunk.values).subspan(known * width));
    if (std::string fault = read(piece, known, chunk); !fault.empty()) return fault;
    if (!piece.of_journal) give_reasons(chunk, known);
    for (std::size_t i = known; i < piece.count; ++i) take(chunk.outcome(i));
    next = end;
  }
  return {};
}

std::vector<fs::path> journals_in(const fs::path& folder, const Sweep& sweep) {
  return files_in(folder, sweep, R"((\.rank\d+|\.\d+of\d+)?\.journal)");
}

std::vector<fs::path> parts_in(const fs::path& folder, const Sweep& sweep) {
  return files_in(folder, sweep, R"(\.\d+of\d+\.csv)");
}

}  // namespace slipbench::driver::sweep
