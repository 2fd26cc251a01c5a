// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slipbench::driver::base {

/// One name for each file, however its folder is written: an absolute path in which the links of
/// the folder are followed, but not the file's own. A case and a link to it are two cases, as they
/// are two names in one folder.
class RealFiles {
 public:
  std::string of(const std::string& path);

 private:
  std::map<std::filesystem::path, std::filesystem::path> folders_;  ///< those seen so far
};

/// The same for a folder; a slash at its end makes no difference.
std::string real_folder(const std::string& path);

}  // namespace slipbench::driver::base
