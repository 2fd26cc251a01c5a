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
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "driver/results/interruption.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// The file that a name leads to: links are followed, also one to a file that is not there yet.
/// Errors: links in a circle; a link to an open descriptor, such as /dev/stdout, which has no name
/// that a complete file could be given.
tl::expected<fs::path, std::string> behind_links(const fs::path& target) {
  constexpr int kMostLinks = 40;
  fs::path place = target;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
    if (fs::absolute(place, error).lexically_normal().string().starts_with("/proc/")) {
      return tl::unexpected(target.string() + ": is no regular file");
    }
    const fs::path next = fs::read_symlink(place, error);
    if (error || links == kMostLinks) {
      return tl::unexpected(fmt::format("{}: cannot be written: {}", target.string(),
                                        error ? error.message() : reason(ELOOP)));
    }
    // Not normalised: "folder/.." of a folder that is a link is not where the name says.
    place = folder_of(place) / next;
  }
  return place;
}

/// What is wrong with writing to `place`, which `target` leads to, or nothing.
std::string obstacle(const fs::path& target, const fs::path& place,
                     std::span<const std::string> inputs) {
  std::error_code error;
  const fs::path folder = folder_of(place);
  const fs::file_status where = fs::status(folder, error);
  if (!fs::exists(where)) {
    return fmt::format("{}: the folder {} does not exist", target.string(), folder.string());
  }
  if (!fs::is_directory(where)) {
    return fmt::format("{}: {} is not a folder", target.string(), folder.string());
  }
  const fs::file_status there = fs::status(place, error);
  if (fs::is_directory(there)) return fmt::format("{}: is a folder", target.string());
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    return fmt::format("{}: is no regular file", target.string());
  }
  return input_fault(target, inputs);
}

}  // namespace

std::string input_fault(const fs::path& target, std::span<const std::string> inputs) {
  for (const std::string& input : inputs) {
    if (!is_same_file(target, input)) continue;
    return fmt::format("{}: is an input ({}) and is not overwritten; choose another name or folder",
                       target.string(), input);
  }
  return {};
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  if (fs::exists(a, error) || fs::exists(b, error)) return false;
  const auto place = [&](const fs::path& path) {
    const fs::path followed = behind_links(path).value_or(path);
    return fs::weakly_canonical(folder_of(followed), error) / followed.filename();
  };
  return place(a) == place(b);
}

FolderLocks::FolderLocks(std::span<const fs::path> files) {
  // In one order, whoever locks: two programs never wait for each other in a circle.
  std::set<fs::path> sorted;
  std::error_code ignored;
  for (const fs::path& file : files) {
    sorted.insert(fs::weakly_canonical(folder_of(behind_links(file).value_or(file)), ignored));
  }
  for (const fs::path& folder : sorted) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) continue;
    flock(descriptor, LOCK_EX);
    descriptors_.push_back(descriptor);
  }
}

FolderLocks::~FolderLocks() {
  for (const int descriptor : descriptors_) close(descriptor);
}

tl::expected<OutputFile, std::string> OutputFile::create(const fs::path& wanted,
                                                         std::span<const std::string> inputs) {
  const fs::path target = wanted.lexically_normal();
  const auto place = behind_links(target);
  if (!place) return tl::unexpected(place.error());
  if (std::string fault = obstacle(target, *place, inputs); !fault.empty()) {
    return tl::unexpected(std::move(fault));
  }
  OutputFile file;
  file.target_ = target;
  file.place_ = *place;
  std::string name = (folder_of(*place) / ("." + place->filename().string() + ".XXXXXX")).string();
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
      place_(std::move(other.place_)),
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
  std::vector<fs::path> places;
  for (const OutputFile* file : files) places.push_back(file->place_);
  const FolderLocks locks(places);
  return commit(files, locks);
}

tl::expected<void, std::string> commit(std::span<OutputFile* const> files,
                                       const FolderLocks& /*locks*/) {
  for (OutputFile* file : files) {
    if (auto closed = file->close(); !closed) return closed;
  }
  const InterruptionPause pause;
  for (OutputFile* file : files) {
    if (rename(file->temporary_.c_str(), file->place_.c_str()) != 0) {
      return tl::unexpected(
          fmt::format("{}: cannot be written: {}", file->target_.string(), reason(errno)));
    }
    forget_file(std::exchange(file->registered_, -1));
    file->temporary_.clear();
  }
  return {};
}

}  // namespace slipbench::driver
