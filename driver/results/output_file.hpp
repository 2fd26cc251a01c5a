// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace slipbench::driver {

/// A file that appears under its name only when it is complete: it is written in the same folder
/// under a name of its own and renamed by `commit`. Dropped before that, interrupted or failed, it
/// leaves nothing behind. Errors are sentences that name the file and the system's reason; after
/// the first one, writing does nothing.
class OutputFile {
 public:
  /// Errors: a folder that is missing, is no folder or cannot be written to; a target that exists
  /// and is no regular file; a target that is one of `inputs` (by whatever name).
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

  const std::filesystem::path& target() const { return target_; }
  /// The name under which it is being written.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  friend tl::expected<void, std::string> commit(std::span<OutputFile* const> files);

  static constexpr std::size_t kFlushSize = std::size_t{256} << 10U;

  OutputFile() = default;
  void flush();
  void drop();

  std::filesystem::path target_;
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

}  // namespace slipbench::driver
