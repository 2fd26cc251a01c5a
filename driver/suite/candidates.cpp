// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/candidates.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string without_extension(const fs::path& path) {
  return (path.parent_path() / path.stem()).lexically_normal().generic_string();
}

bool is_searched(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name != "bad" && !name.starts_with('.');
}

/// Adds the paths of the cases below `top`, in no order.
void search(const fs::path& top, std::vector<fs::path>& found, std::vector<std::string>& faults) {
  std::vector<fs::path> folders = {top};
  while (!folders.empty()) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
      std::error_code ignored;
      if (it->is_directory(ignored)) {
        if (!it->is_symlink(ignored) && is_searched(it->path())) folders.push_back(it->path());
      } else if (it->path().extension() == ".yaml") {
        found.push_back(it->path());
      }
    }
    if (error) faults.push_back(folder.string() + ": " + error.message());
  }
}

/// Keeps the first of several that are the same file.
void remove_repeated(std::vector<Candidate>& cases) {
  std::set<fs::path> seen;
  std::erase_if(cases, [&](const Candidate& candidate) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(candidate.path, error);
    return !error && !seen.insert(real).second;
  });
}

}  // namespace

Candidates find_candidates(std::span<const std::string> paths) {
  Candidates all;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      all.cases.push_back({path, without_extension(path)});
      continue;
    }
    std::vector<fs::path> files;
    search(path, files, all.faults);
    std::vector<Candidate> found;
    for (const fs::path& file : files) {
      const fs::path shown = paths.size() == 1 ? file.lexically_relative(path) : file;
      found.push_back({file.string(), without_extension(shown)});
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.label < b.label; });
    std::move(found.begin(), found.end(), std::back_inserter(all.cases));
  }
  if (paths.size() > 1) remove_repeated(all.cases);
  std::sort(all.faults.begin(), all.faults.end());
  return all;
}

}  // namespace slipbench::driver
