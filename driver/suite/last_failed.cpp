// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/last_failed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "driver/results/output_file.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
  std::error_code error;
  const fs::path there = fs::absolute(path, error).lexically_normal();
  return error ? path : there.string();
}

/// The folder of what may be forgotten; a relative one does not count (XDG base directories).
std::optional<fs::path> cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) return fs::path(cache) / "slipbench";
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) {
    return fs::path(home) / ".cache" / "slipbench";
  }
  return std::nullopt;
}

/// FNV-1a, 64 bit: the same on every machine.
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 14695981039346656037U;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return h;
}

}  // namespace

LastFailed::LastFailed(std::span<const std::string> paths) {
  std::set<std::string> folders;
  for (const std::string& path : paths) folders.insert(absolute(path));
  head_ = "slipbench: cases that did not pass last time, of\n";
  for (const std::string& folder : folders) head_ += folder + "\n";
  head_ += "\n";
  const auto folder = cache_folder();
  if (!folder) return;
  file_ = *folder / fmt::format("failed-{:016x}", hash(head_));
  std::ifstream in(*file_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!text.starts_with(head_)) return;
  std::size_t begin = head_.size();
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    failed_.insert(text.substr(begin, end - begin));
  }
}

void LastFailed::order(std::vector<Candidate>& cases) const {
  if (failed_.empty()) return;
  std::stable_partition(cases.begin(), cases.end(), [&](const Candidate& candidate) {
    return failed_.contains(absolute(candidate.path));
  });
}

void LastFailed::note(const Candidate& candidate, bool well) {
  if (well) {
    failed_.erase(absolute(candidate.path));
  } else {
    failed_.insert(absolute(candidate.path));
  }
}

void LastFailed::write(std::span<const Candidate> cases) const {
  if (!file_) return;
  std::string text = head_;
  for (const Candidate& candidate : cases) {
    const std::string path = absolute(candidate.path);
    // A name of several lines would not be read back.
    if (failed_.contains(path) && path.find('\n') == std::string::npos) text += path + "\n";
  }
  std::error_code ignored;
  fs::create_directories(file_->parent_path(), ignored);
  auto file = OutputFile::create(*file_);
  if (!file) return;
  file->append(text);
  OutputFile* const alone[] = {&*file};
  static_cast<void>(commit(alone));
}

}  // namespace slipbench::driver
