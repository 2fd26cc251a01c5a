// SPDX-License-Identifier: Apache-2.0
#include "driver/results/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "driver/results/interruption.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// What is wrong with writing to `target`, or nothing.
std::string obstacle(const fs::path& target, std::span<const std::string> inputs) {
  std::error_code error;
  const fs::path folder = folder_of(target);
  const fs::file_status where = fs::status(folder, error);
  if (!fs::exists(where)) {
    return fmt::format("{}: the folder {} does not exist", target.string(), folder.string());
  }
  if (!fs::is_directory(where)) {
    return fmt::format("{}: {} is not a folder", target.string(), folder.string());
  }
  const fs::file_status there = fs::status(target, error);
  if (fs::is_directory(there)) return fmt::format("{}: is a folder", target.string());
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    return fmt::format("{}: is no regular file", target.string());
  }
  for (const std::string& input : inputs) {
    if (fs::equivalent(target, input, error) && !error) {
      return fmt::format("{}: is an input ({}) and is not overwritten; choose another folder (-o)",
                         target.string(), input);
    }
  }
  return {};
}

/// Makes programs that complete files in one folder wait for each other; where the file system has
/// no locks they do not.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
  }
  ~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace

tl::expected<OutputFile, std::string> OutputFile::create(const fs::path& wanted,
                                                         std::span<const std::string> inputs) {
  const fs::path target = wanted.lexically_normal();
  if (std::string fault = obstacle(target, inputs); !fault.empty()) {
    return tl::unexpected(std::move(fault));
  }
  OutputFile file;
  file.target_ = target;
  std::string name = (folder_of(target) / ("." + target.filename().string() + ".XXXXXX")).string();
  {
    const InterruptionPause pause;
    file.descriptor_ = mkostemp(name.data(), O_CLOEXEC);
    if (file.descriptor_ < 0) {
      return tl::unexpected(
          fmt::format("{}: cannot be written: {}", target.string(), reason(errno)));
    }
    file.temporary_ = name;
    file.registered_ = register_file(name);
  }
  // mkostemp lets nobody else read; a result is as readable as any new file.
  const mode_t mask = umask(0);
  umask(mask);
  constexpr mode_t kReadWrite = 0666;
  fchmod(file.descriptor_, kReadWrite & ~mask);
  file.buffer_.reserve(kFlushSize + kFlushSize / 4);
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      buffer_(std::move(other.buffer_)),
      error_(std::move(other.error_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      registered_(std::exchange(other.registered_, -1)) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() { drop(); }

void OutputFile::drop() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (temporary_.empty()) return;
  const InterruptionPause pause;
  unlink(temporary_.c_str());
  forget_file(std::exchange(registered_, -1));
  temporary_.clear();
}

void OutputFile::flush() {
  const char* data = buffer_.data();
  std::size_t left = error_.empty() ? buffer_.size() : 0;
  while (left > 0) {
    const ssize_t written = write(descriptor_, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = fmt::format("{}: cannot be written: {}", target_.string(), reason(errno));
      break;
    }
    data += written;
    left -= static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

tl::expected<void, std::string> OutputFile::close() {
  flush();
  if (descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0 && error_.empty()) {
    error_ = fmt::format("{}: cannot be written: {}", target_.string(), reason(errno));
  }
  if (!error_.empty()) return tl::unexpected(error_);
  return {};
}

tl::expected<void, std::string> commit(std::span<OutputFile* const> files) {
  for (OutputFile* file : files) {
    if (auto closed = file->close(); !closed) return closed;
  }
  if (files.empty()) return {};
  const FolderLock lock(folder_of(files.front()->target_));
  const InterruptionPause pause;
  for (OutputFile* file : files) {
    if (rename(file->temporary_.c_str(), file->target_.c_str()) != 0) {
      return tl::unexpected(
          fmt::format("{}: cannot be written: {}", file->target_.string(), reason(errno)));
    }
    forget_file(std::exchange(file->registered_, -1));
    file->temporary_.clear();
  }
  return {};
}

}  // namespace slipbench::driver
