// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/data_path.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

namespace slipbench::driver::base {
namespace {

namespace fs = std::filesystem;

/// Tells whether a file lies in a folder that the program was built from or in.
bool lies_in_build(const fs::path& file) {
  const auto real = [](const fs::path& path) {
    std::error_code error;
    return fs::weakly_canonical(path, error);
  };
  const auto lies_in_real = [&](const fs::path& folder) {
    return !folder.empty() && lies_in(real(file), folder);
  };
  return lies_in_real(real(SLIPBENCH_SOURCE_DIR)) || lies_in_real(real(SLIPBENCH_BINARY_DIR));
}

/// Returns the file of the module that this code was loaded from; nothing for a program, of which
/// the system tells the words that it was called by.
fs::path own_module() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_module), &info) == 0) return {};
  const fs::path file = info.dli_fname == nullptr ? "" : info.dli_fname;
  return file.is_absolute() && file.extension() == ".so" ? file : fs::path();
}

/// Returns the folder of what is installed with PREFIX/bin/FILE, or with a module of Python,
/// PREFIX/lib/python3/dist-packages/slipbench/FILE; nothing for a file elsewhere.
fs::path installed_with(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const fs::path packages = folder.parent_path();
  const fs::path share = fs::path("share") / "slipbench";
  if (folder.filename() == "bin") return packages / share;
  if (packages.filename() != "dist-packages" && packages.filename() != "site-packages") return {};
  return packages.parent_path().parent_path().parent_path() / share;
}

}  // namespace

bool lies_in(const fs::path& path, const fs::path& folder) {
  const auto [at_folder, at_path] =
      std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  // A folder written with a slash at its end has an empty last part.
  return at_folder == folder.end() || at_folder->empty();
}

tl::expected<fs::path, HistoryError> resolve_data_path(const fs::path& case_folder,
                                                       std::string_view text, bool allow_outside) {
  constexpr std::string_view kHint =
      "a case, fit or deck reads files of its own folder only, unless --allow-outside is given";
  if (text.empty()) return input_error("the file's name is empty");
  if (text.find('\0') != std::string_view::npos) {
    return input_error("the file's name contains a NUL character");
  }
  if (text.front() == '~') {
    return input_error(fmt::format("'{}': '~' is not expanded; write the path out", text));
  }
  if (text.find("://") != std::string_view::npos) {
    return input_error(fmt::format("'{}' is an address; the path of a file is wanted", text));
  }
  const fs::path relative(text);
  const fs::path folder = case_folder.empty() ? fs::path(".") : case_folder;
  const fs::path path = folder / relative;
  if (allow_outside) return path;

  if (relative.is_absolute()) {
    return input_error(fmt::format("'{}' is an absolute path; {}", text, kHint));
  }
  if (std::find(relative.begin(), relative.end(), fs::path("..")) != relative.end()) {
    return input_error(fmt::format("'{}' contains '..'; {}", text, kHint));
  }
  std::error_code failure;
  const fs::path real_folder = fs::weakly_canonical(fs::absolute(folder), failure);
  const fs::path real_path =
      failure ? fs::path{} : fs::weakly_canonical(fs::absolute(path), failure);
  if (failure) {
    return environment_error(std::string(text),
                             fmt::format("cannot be followed: {}", failure.message()));
  }
  if (!lies_in(real_path, real_folder)) {
    return input_error(fmt::format("'{}' is a link out of the folder; {}", text, kHint));
  }
  return path;
}

std::optional<std::filesystem::path> shipped_path(const std::filesystem::path& name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path module = own_module();
  std::vector<fs::path> folders;
  for (const fs::path& file : {program, module}) {
    if (file.empty()) continue;
    if (const fs::path folder = installed_with(file); !folder.empty()) folders.push_back(folder);
    // Once installed, the folder that it was built in may be anyone's.
    if (lies_in_build(file)) folders.emplace_back(SLIPBENCH_SOURCE_DIR);
  }
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / name, error)) return folder / name;
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::base
