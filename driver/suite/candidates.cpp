// SPDX-License-Identifier: Apache-2.0
#include "driver/suite/candidates.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
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

/// Tells whether a link leads to a folder below `top` that is not searched by its own name, either.
bool is_passed_over(const fs::path& link, const fs::path& top) {
  std::error_code error;
  const fs::path root = fs::canonical(top, error);
  const fs::path target = error ? fs::path() : fs::canonical(link, error);
  if (error || !base::lies_in(target, root)) return false;
  const fs::path below = target.lexically_relative(root);
  return below != "." && !std::all_of(below.begin(), below.end(), is_searched);
}

/// Returns the cases below `top`, in no order; those with a fault have no label of their own yet.
std::vector<Candidate> search(const fs::path& top, bool allow_outside) {
  std::vector<Candidate> found;
  const auto leads_out = [&](const fs::path& link) {
    return !base::resolve_data_path(top, link.lexically_relative(top).string(), allow_outside);
  };
  std::vector<fs::path> folders = {top};
  while (!folders.empty()) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
      const fs::path& path = it->path();
      std::error_code ignored;
      const bool is_folder = it->is_directory(ignored);
      const bool is_link = it->is_symlink(ignored);
      if (is_folder ? !is_searched(path) : !read::has_case_ending(path) || is_hidden(path)) {
        continue;
      }
      if (is_link && leads_out(path)) {
        found.push_back({path.string(),
                         {},
                         is_folder
                             ? "is a link out of the folder and not searched; name it to have its "
                               "cases run, or give --allow-outside if it holds their data"
                             : "is a link out of the folder; name the file itself to have "
                               "it run"});
      } else if (is_folder) {
        if (!is_link) {
          folders.push_back(path);
        } else if (is_passed_over(path, top)) {
          found.push_back({path.string(),
                           {},
                           "is a link to a folder that is not searched (hidden, in a hidden one, "
                           "or 'bad'); name it to have its cases run"});
        }
      } else if (!read::is_no_case(path)) {
        found.push_back({path.string()});
      }
    }
    if (error) found.push_back({folder.string(), {}, "cannot be searched: " + error.message()});
  }
  return found;
}

/// Keeps the first of several that are the same file; one that is named or found elsewhere takes
/// the place of one with a fault.
std::vector<Candidate> without_repeated(std::vector<Candidate> cases) {
  base::RealFiles real_files;
  std::map<std::string, std::size_t> places;
  std::vector<Candidate> kept;
  for (Candidate& one : cases) {
    const auto [at, is_new] = places.emplace(real_files.of(one.path), kept.size());
    if (is_new) {
      kept.push_back(std::move(one));
    } else if (one.fault.empty()) {
      Candidate& first = kept[at->second];
      if (!first.fault.empty()) first = std::move(one);
    }
  }
  return kept;
}

/// Tells whether a link leads to a folder that is searched by its own name.
bool is_searched_too(const std::string& link, std::span<const std::string> paths) {
  std::error_code error;
  const fs::path target = fs::canonical(link, error);
  return !error && std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
    std::error_code missing;
    const fs::path folder = fs::canonical(path, missing);
    return !missing && base::lies_in(target, folder) && !is_passed_over(link, path);
  });
}

}  // namespace

std::vector<Candidate> find_candidates(std::span<const std::string> paths, bool allow_outside) {
  std::vector<Candidate> all;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      all.push_back({path, label_of(path)});
      continue;
    }
    std::vector<Candidate> found = search(path, allow_outside);
    if (found.empty() && paths.size() > 1) {
      found.push_back({path, {}, "has no case (*.yaml, *.yml)"});
    }
    for (Candidate& one : found) {
      one.is_searched = true;
      const fs::path file = one.path;
      one.label = label_of(paths.size() == 1 ? file.lexically_relative(path) : file);
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& a, const Candidate& b) { return a.label < b.label; });
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  if (paths.size() == 1) return all;
  std::erase_if(all, [&](const Candidate& one) {
    std::error_code ignored;
    return !one.fault.empty() && fs::is_symlink(one.path, ignored) &&
           fs::is_directory(one.path, ignored) && is_searched_too(one.path, paths);
  });
  return without_repeated(std::move(all));
}

}  // namespace slipbench::driver::suite
