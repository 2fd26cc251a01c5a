// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/candidates.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "driver/base/files/data_path.hpp"
#include "driver/base/files/real_files.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/read/file_kind.hpp"

namespace slipbench::driver::suite {
namespace {

namespace fs = std::filesystem;

/// Another extension than that of a case stays: two files are not to be called the same.
std::string label_of(const fs::path& path) {
  if (path == base::kStandardInput) return std::string(base::kStandardInputName);
  const fs::path name = path.extension() == ".yaml" ? path.stem() : path.filename();
  return (path.parent_path() / name).lexically_normal().generic_string();
}

/// Editors and file systems keep locks and notes of their own under such names.
bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

bool is_searched(const fs::path& folder) {
  return folder.filename() != "bad" && !is_hidden(folder);
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
      } else if (read::has_case_ending(it->path()) && !is_hidden(it->path())) {
        const fs::path below = it->path().lexically_relative(top);
        if (it->is_symlink(ignored) && !base::resolve_data_path(top, below.string())) {
          faults.push_back(it->path().string() +
                           ": is a link out of the folder; name the file itself to have it run");
          continue;
        }
        found.push_back(it->path());
      }
    }
    if (error) faults.push_back(folder.string() + ": " + error.message());
  }
}

/// Keeps the first of several that are the same file.
void remove_repeated(std::vector<Candidate>& cases) {
  base::RealFiles real_files;
  std::set<std::string> seen;
  std::erase_if(cases, [&](const Candidate& candidate) {
    return !seen.insert(real_files.of(candidate.path)).second;
  });
}

}  // namespace

Candidates find_candidates(std::span<const std::string> paths) {
  Candidates all;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      all.cases.push_back({path, label_of(path)});
      continue;
    }
    std::vector<fs::path> files;
    search(path, files, all.faults);
    std::vector<Candidate> found;
    for (const fs::path& file : files) {
      if (read::looks_like_no_case(file)) continue;
      const fs::path shown = paths.size() == 1 ? file.lexically_relative(path) : file;
      found.push_back({file.string(), label_of(shown)});
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.label < b.label; });
    std::move(found.begin(), found.end(), std::back_inserter(all.cases));
  }
  if (paths.size() > 1) remove_repeated(all.cases);
  std::sort(all.faults.begin(), all.faults.end());
  return all;
}

}  // namespace slipbench::driver::suite
