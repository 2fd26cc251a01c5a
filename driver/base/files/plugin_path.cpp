// SPDX-License-Identifier: Apache-2.0
#include "driver/base/files/plugin_path.hpp"

#include <array>
#include <system_error>

namespace slipbench::driver::base {

namespace fs = std::filesystem;

std::optional<fs::path> plugin_path(std::string_view name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& place :
       std::array{program / name, program.parent_path() / "lib" / "slipbench" / name}) {
    if (fs::exists(place, error)) return place;
  }
  return std::nullopt;
}

}  // namespace slipbench::driver::base
