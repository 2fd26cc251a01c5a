// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "driver/base/text/diagnostic.hpp"
#include "driver/base/text/standard_input.hpp"
#include "driver/read/file_kind.hpp"
#include "driver/terminal/print.hpp"

namespace slipbench::driver::commands {

namespace fs = std::filesystem;

std::string folder_fault(const std::string& folder, std::string_view whose) {
  constexpr std::array<std::string_view, 9> kEndings{".csv",  ".json", ".yaml", ".yml", ".txt",
                                                     ".html", ".svg",  ".png",  ".pdf"};
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return {};
  const std::string ending = fs::path(folder).extension().string();
  if (folder != "-" && std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) {
    return {};
  }
  return fmt::format("-o {}: wanted a folder, not a file: results are called after their {}",
                     folder, whose);
}

std::string named_case(const std::string& path) {
  std::error_code error;
  if (path == base::kStandardInput) return path;
  if (fs::exists(fs::symlink_status(path, error))) return path;
  std::string found;
  for (const std::string_view ending : read::kCaseEndings) {
    const std::string file = path + std::string(ending);
    if (!fs::is_regular_file(file, error)) continue;
    if (found.empty()) {
      found = file;
    } else {
      terminal::print_error(fmt::format("slipbench: warning: there are {0} and {1}; {0} is taken\n",
                                        base::printable(found), base::printable(file)));
    }
  }
  return found.empty() ? path : found;
}

}  // namespace slipbench::driver::commands
