// SPDX-License-Identifier: Apache-2.0
#include "driver/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "driver/base/files/output_file.hpp"
#include "driver/base/files/sha256.hpp"
#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/hash.hpp"
#include "driver/results/provenance.hpp"

namespace slipbench::driver::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "# slipbench journal ";
constexpr std::size_t kHeadBytes = 24;  ///< of a record
constexpr std::size_t kHashBytes = 8;

std::string reason() { return std::generic_category().message(errno); }

std::string head_of(const Sweep& sweep, const std::string& identity) {
  return fmt::format(
      "{}1\n# sweep: {}\n# identity: {}\n# samples: {}\n# numbers: {}\n# bytes: {}\n", kMark,
      base::printable(fs::path(sweep.file).filename().string()), identity, sweep.samples,
      sweep.collected.size(),
      std::endian::native == std::endian::little ? "least first" : "most first");
}

template <class Number>
void put(std::string& bytes, Number number) {
  std::array<char, sizeof number> own{};
  std::memcpy(own.data(), &number, sizeof number);
  bytes.append(own.data(), own.size());
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t offset) {
  Number number{};
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

/// Reads as many of the bytes as there are.
std::string bytes_at(int descriptor, std::uint64_t offset, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        pread(descriptor, bytes.data() + done, count - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string failures_text(const Chunk& chunk) {
  std::string text;
  for (std::size_t i = 0; i < chunk.count; ++i) {
    const std::string& sentence = chunk.failures[i];
    if (sentence.empty()) continue;
    put(text, static_cast<std::uint32_t>(i));
    put(text, static_cast<std::uint32_t>(sentence.size()));
    text += sentence;
  }
  return text;
}

/// Brings the failures back; false if they are none of these samples.
bool read_failures(std::string_view text, std::vector<std::string>& failures) {
  std::fill(failures.begin(), failures.end(), std::string());
  while (!text.empty()) {
    if (text.size() < 8) return false;
    const auto sample = number_at<std::uint32_t>(text, 0);
    const auto length = number_at<std::uint32_t>(text, 4);
    text.remove_prefix(8);
    if (sample >= failures.size() || length > text.size()) return false;
    failures[sample] = text.substr(0, length);
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

std::string identity_of(const Sweep& sweep, std::span<const std::string> files) {
  std::string text = fmt::format("slipbench {}\n", results::program_version());
  for (const base::ParameterText& one : sweep.settings) {
    std::visit([&](const auto& value) { text += fmt::format("{} = {}\n", one.name, value); },
               one.value);
  }
  for (const std::string& file : files) text += base::sha256_of_file(file).value_or("-") + "\n";
  return base::sha256_of(text);
}

Journal::Journal(fs::path path, const Sweep& sweep)
    : path_(std::move(path)), samples_(sweep.samples), depth_(sweep.collected.size()) {}

Journal::~Journal() {
  if (descriptor_ >= 0) close(descriptor_);
}

tl::expected<std::unique_ptr<Journal>, std::string> Journal::open(const fs::path& path,
                                                                  const Sweep& sweep,
                                                                  const std::string& identity,
                                                                  Use use) {
  if (use != Use::kRead) {
    if (std::string fault = base::input_fault(path, {}); !fault.empty()) {
      return tl::unexpected(std::move(fault));
    }
  }
  std::unique_ptr<Journal> journal(new Journal(path, sweep));
  constexpr mode_t kReadWrite = 0666;
  const int how = use == Use::kRead ? O_RDONLY : O_RDWR | O_APPEND | O_CREAT;
  // A pipe is not waited for: lock() refuses it.
  journal->descriptor_ = ::open(path.c_str(), how | O_CLOEXEC | O_NONBLOCK, kReadWrite);
  if (journal->descriptor_ < 0) {
    return tl::unexpected(fmt::format("{}: cannot be {}: {}", path.string(),
                                      use == Use::kRead ? "read" : "written", reason()));
  }
  std::string fault = journal->lock(use);
  const std::string head = head_of(sweep, identity);
  if (fault.empty() && use == Use::kAnew) fault = journal->cut(0);
  if (fault.empty()) fault = journal->check_head(head, use);
  if (fault.empty()) fault = journal->check_records(head.size());
  if (fault.empty() && use != Use::kRead && journal->dropped_ > 0) {
    fault = journal->cut(journal->length_);
  }
  if (!fault.empty()) return tl::unexpected(std::move(fault));
  std::stable_sort(
      journal->records_.begin(), journal->records_.end(),
      [](const JournalRecord& a, const JournalRecord& b) { return a.first < b.first; });
  return journal;
}

std::string Journal::lock(Use use) const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    return path_.string() + ": is no regular file";
  }
  // A file system without locks has other errors.
  const int how = use == Use::kRead ? LOCK_SH : LOCK_EX;
  if (flock(descriptor_, how | LOCK_NB) == 0 || errno != EWOULDBLOCK) return {};
  return path_.string() + ": is being written by another run of this sweep";
}

/// Looks at the head, or writes it where there is none.
std::string Journal::check_head(const std::string& head, Use use) {
  const std::string there = bytes_at(descriptor_, 0, head.size());
  if (there == head) return {};
  if (head.starts_with(there)) {
    if (use == Use::kRead) return path_.string() + ": is no whole journal: its head ends early";
    if (std::string fault = cut(0); !fault.empty()) return fault;
    if (write_all(descriptor_, head)) return {};
    return fmt::format("{}: cannot be written: {}", path_.string(), reason());
  }
  if (!there.starts_with(kMark)) return path_.string() + ": is there already and is no journal";
  const auto first_lines = [](const std::string& text) {
    return text.substr(0, text.find("# identity: "));
  };
  return path_.string() + (first_lines(there) == first_lines(head)
                               ? ": is of another state of this sweep: an input, a setting or the "
                                 "program has changed since"
                               : ": is of another sweep, or of another version of journals");
}

std::string Journal::damaged(std::uint64_t offset) const {
  return fmt::format("{}: is damaged: the record at byte {} is not what was written",
                     path_.string(), offset);
}

/// Finds the records, and where a last one that is not whole begins.
std::string Journal::check_records(std::uint64_t begin) {
  const auto size = static_cast<std::uint64_t>(lseek(descriptor_, 0, SEEK_END));
  length_ = begin;
  while (length_ < size) {
    const std::string head = bytes_at(descriptor_, length_, kHeadBytes);
    if (head.size() < kHeadBytes) break;
    const auto marked = std::string_view(head).substr(0, kHeadBytes - kHashBytes);
    if (base::hash(marked) != number_at<std::uint64_t>(head, marked.size())) {
      return damaged(length_);
    }
    JournalRecord record;
    record.first = number_at<std::uint64_t>(head, 0);
    record.count = number_at<std::uint32_t>(head, 8);
    record.words = number_at<std::uint32_t>(head, 12);
    record.offset = length_ + kHeadBytes;
    if (record.count == 0 || record.count > samples_ || record.first > samples_ - record.count) {
      return damaged(length_);
    }
    const std::uint64_t bytes = record.count * depth_ * sizeof(double) + record.words;
    const std::uint64_t end = record.offset + bytes + kHashBytes;
    if (end > size) break;
    const std::string body = bytes_at(descriptor_, record.offset, bytes + kHashBytes);
    if (body.size() < bytes + kHashBytes) break;
    const bool sound = base::hash(std::string_view(body).substr(0, bytes)) ==
                       number_at<std::uint64_t>(body, bytes);
    if (!sound && end < size) return damaged(length_);
    if (!sound) break;
    records_.push_back(record);
    length_ = end;
  }
  dropped_ = size - length_;
  return {};
}

std::string Journal::cut(std::uint64_t length) {
  if (ftruncate(descriptor_, static_cast<off_t>(length)) == 0) return {};
  return fmt::format("{}: cannot be written: {}", path_.string(), reason());
}

tl::expected<void, std::string> Journal::read(const JournalRecord& record, Chunk& chunk) const {
  const std::size_t numbers = record.count * depth_ * sizeof(double);
  const std::string body = bytes_at(descriptor_, record.offset, numbers + record.words);
  if (body.size() < numbers + record.words ||
      !read_failures(std::string_view(body).substr(numbers), chunk.failures)) {
    return tl::unexpected(damaged(record.offset - kHeadBytes));
  }
  std::memcpy(chunk.numbers.data(), body.data(), numbers);
  return {};
}

bool Journal::recall(Chunk& chunk) const {
  auto record = std::lower_bound(
      records_.begin(), records_.end(), chunk.first,
      [](const JournalRecord& one, std::size_t first) { return one.first < first; });
  while (record != records_.end() && record->first == chunk.first && record->count != chunk.count) {
    ++record;
  }
  return record != records_.end() && record->first == chunk.first && read(*record, chunk);
}

void Journal::append(const Chunk& chunk) {
  std::string bytes;
  const std::string failures = failures_text(chunk);
  bytes.reserve(kHeadBytes + chunk.numbers.size() * sizeof(double) + failures.size() + kHashBytes);
  put(bytes, static_cast<std::uint64_t>(chunk.first));
  put(bytes, static_cast<std::uint32_t>(chunk.count));
  put(bytes, static_cast<std::uint32_t>(failures.size()));
  put(bytes, base::hash(bytes));
  for (const double number : chunk.numbers) put(bytes, number);
  bytes += failures;
  put(bytes, base::hash(std::string_view(bytes).substr(kHeadBytes)));
  const std::lock_guard lock(mutex_);
  if (!error_.empty() || write_all(descriptor_, bytes)) return;
  error_ = fmt::format("{}: cannot be written: {}", path_.string(), reason());
}

std::string Journal::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

void Journal::remove() { unlink(path_.c_str()); }

}  // namespace slipbench::driver::sweep
