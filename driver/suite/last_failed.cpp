// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/last_failed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string_view>
#include <system_error>

#include "driver/base/files/output_file.hpp"
#include "driver/base/text/hash.hpp"

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

LastFailed::LastFailed(std::span<const std::string> paths) {
  std::set<std::string> folders;
  for (const std::string& path : paths) folders.insert(base::real_folder(path));
  head_ = "slipbench: cases that did not pass last time, of\n";
  for (const std::string& folder : folders) head_ += folder + "\n";
  head_ += "\n";
  const auto folder = cache_folder();
  if (!folder) return;
  file_ = *folder / fmt::format("failed-{:016x}", base::hash(head_));
  std::ifstream in(*file_, std::ios::binary);
  kept_.assign(std::istreambuf_iterator<char>(in), {});
  if (!kept_.starts_with(head_)) return;
  std::size_t begin = head_.size();
  for (std::size_t end = 0; (end = kept_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    failed_.insert(kept_.substr(begin, end - begin));
  }
}

std::vector<std::size_t> LastFailed::order(std::span<const Candidate> cases) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!failed_.empty()) {
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
      return failed_.contains(real_files_.of(cases[i].path));
    });
  }
  return order;
}

void LastFailed::note(const Candidate& candidate, bool well) {
  if (!well) {
    failed_.insert(real_files_.of(candidate.path));
  } else if (!failed_.empty()) {
    failed_.erase(real_files_.of(candidate.path));
  }
}

void LastFailed::write(std::span<const Candidate> cases) {
  if (!file_) return;
  std::string text = head_;
  if (!failed_.empty()) {
    for (const Candidate& candidate : cases) {
      const std::string path = real_files_.of(candidate.path);
      // A name of several lines would not be read back.
      if (failed_.contains(path) && path.find('\n') == std::string::npos) text += path + "\n";
    }
  }
  // A suite that never failed leaves no trace.
  if (text == kept_ || (text == head_ && kept_.empty())) return;
  auto file = base::OutputFile::create(*file_, {.start = head_});
  if (!file) return;
  file->append(text);
  base::OutputFile* const alone[] = {&*file};
  static_cast<void>(base::commit(alone));
}

}  // namespace slipbench::driver::suite
