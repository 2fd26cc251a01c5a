// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/real_files.hpp"

#include <system_error>
#include <utility>

namespace slipbench::driver::base {

namespace fs = std::filesystem;

std::string RealFiles::of(const std::string& path) {
  std::error_code error;
  const fs::path file = fs::absolute(path, error);
  if (error) return path;
  auto folder = folders_.find(file.parent_path());
  if (folder == folders_.end()) {
    fs::path real = real_folder(file.parent_path().string());
    folder = folders_.emplace(file.parent_path(), std::move(real)).first;
  }
  return (folder->second / file.filename()).string();
}

std::string real_folder(const std::string& path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) return path;
  if (!real.has_filename()) real = real.parent_path();
  return real.string();
}

}  // namespace slipbench::driver::base
