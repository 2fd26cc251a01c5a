// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/sweep/run_sweep.hpp"

namespace slipbench::driver::sweep {

/// Fingerprint of everything that the rows of a sweep depend on: program version, settings, and the
/// bytes of the files it is read from; not their names, nor which part is run, nor by how many
/// threads. 64 hexadecimal digits.
/// \param files the sweep, its case and what they name
std::string identity_of(const Sweep& sweep, std::span<const std::string> files);

/// Chunk in a journal.
struct JournalRecord {
  std::size_t first = 0;
  std::size_t count = 0;
  std::uint64_t offset = 0;  ///< of its numbers in the file
  std::uint32_t words = 0;   ///< bytes of its failures
};

/// Finished chunks of a sweep, in a file that only grows: a head in text, then a record a chunk
/// with a checksum each. What an interruption leaves can be gone on with: a last record that is not
/// whole is dropped, anything else that is wrong is refused.
///   head    lines that start with "# ": version, sweep, identity, samples, numbers a sample, order
///           of bytes
///   record  first sample (8 bytes), samples (4), bytes of the failures (4), hash of these (8); the
///           numbers (8 each, sample by sample); for each failure its sample (4), bytes (4),
///           sentence; hash of numbers and failures (8). The hash is FNV-1a.
class Journal {
 public:
  enum class Use : std::uint8_t {
    kGoOn,  ///< add to it; made if it is missing. Nobody else may write it meanwhile.
    kAnew,  ///< the same, but whatever is there goes, even a file that is no journal
    kRead,  ///< must be there; is not changed
  };

  /// Opens a journal and checks all of it. Errors are sentences that begin with its path.
  static tl::expected<std::unique_ptr<Journal>, std::string> open(const std::filesystem::path& path,
                                                                  const Sweep& sweep,
                                                                  const std::string& identity,
                                                                  Use use);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The chunks that were there when it was opened, in the order of the samples.
  std::span<const JournalRecord> records() const { return records_; }
  /// Bytes of a last record that was not whole.
  std::uint64_t dropped() const { return dropped_; }

  /// Brings back the numbers and failures of a record, not the values.
  tl::expected<void, std::string> read(const JournalRecord& record, Chunk& chunk) const;
  /// Brings back what is in the journal of just these samples; false if it is not. Any thread.
  bool recall(Chunk& chunk) const;

  /// Adds a chunk. Any thread. After the first error nothing more is added.
  void append(const Chunk& chunk);
  /// Says why something could not be added, in a sentence, or nothing.
  std::string error() const;

  /// Removes the file: what it kept is at its place.
  void remove();

 private:
  Journal(std::filesystem::path path, const Sweep& sweep);
  std::string lock(Use use) const;
  std::string check_head(const std::string& head, Use use);
  std::string check_records(std::uint64_t begin);
  std::string cut(std::uint64_t length);
  std::string damaged(std::uint64_t offset) const;

  std::filesystem::path path_;
  std::size_t samples_;
  std::size_t depth_;  ///< numbers a sample
  int descriptor_ = -1;
  std::uint64_t length_ = 0;
  std::uint64_t dropped_ = 0;
  std::vector<JournalRecord> records_;
  mutable std::mutex mutex_;
  std::string error_;
};

}  // namespace slipbench::driver::sweep
