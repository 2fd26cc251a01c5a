// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace slipbench::driver {

/// Whether two names mean one file, be it there or not; links are followed.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Why `target` must not be written: it is one of the files that are read. A sentence, or nothing.
std::string input_fault(const std::filesystem::path& target, std::span<const std::string> inputs);

/// Makes programs that complete files in the same folders wait for each other, as long as it
/// exists; where the file system has no locks they do not.
class FolderLocks {
 public:
  /// Locks the folders of files that are about to be completed, links followed.
  explicit FolderLocks(std::span<const std::filesystem::path> files);
  ~FolderLocks();
  FolderLocks(const FolderLocks&) = delete;
  FolderLocks& operator=(const FolderLocks&) = delete;

 private:
  std::vector<int> descriptors_;
};

/// A file that appears under its name only when it is complete: it is written in the same folder
/// under a name of its own and renamed by `commit`. A name that is a link stays one: the file that
/// it leads to is written, beside itself. Dropped before that, interrupted or failed, it leaves
/// nothing behind. Errors are sentences that name the file and the system's reason; after
/// the first one, writing does nothing.
class OutputFile {
 public:
  /// Errors: a folder that is missing, is no folder or cannot be written to; a target that exists
  /// and is no regular file (a folder, a device, a descriptor such as /dev/stdout); links in a
  /// circle; a target that is one of `inputs` (by whatever name).
  static tl::expected<OutputFile, std::string> create(const std::filesystem::path& target,
                                                      std::span<const std::string> inputs = {});

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  /// The buffer, for appending to; `flush_if_full` after each piece keeps it small.
  std::string& buffer() { return buffer_; }
  void flush_if_full() {
    if (buffer_.size() >= kFlushSize) flush();
  }
  void append(std::string_view text) {
    buffer_ += text;
    flush_if_full();
  }

  /// Writes what is left and closes, for others to read under the temporary name.
  tl::expected<void, std::string> close();

  /// The name it was asked for by.
  const std::filesystem::path& target() const { return target_; }
  /// The name under which it is being written.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  friend tl::expected<void, std::string> commit(std::span<OutputFile* const> files);
  friend tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                                const FolderLocks& locks);

  static constexpr std::size_t kFlushSize = std::size_t{256} << 10U;

  OutputFile() = default;
  void flush();
  void drop();

  std::filesystem::path target_;
  std::filesystem::path place_;  ///< where it will be, links followed
  std::filesystem::path temporary_;
  std::string buffer_;
  std::string error_;
  int descriptor_ = -1;
  int registered_ = -1;
};

/// Completes files that belong together, all or none: writes what is left, closes them and gives
/// them their names. Two programs that complete files in one folder do so one after the other.
/// The error is that of the first file that has one; then none appears under its name.
tl::expected<void, std::string> commit(std::span<OutputFile* const> files);
/// The same for somebody who holds the locks of the files' folders already, to look at what is
/// there before it is replaced.
tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                       const FolderLocks& locks);

}  // namespace slipbench::driver
