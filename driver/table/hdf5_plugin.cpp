// SPDX-License-Identifier: Apache-2.0
#include "driver/table/hdf5_plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <system_error>

namespace slipbench::driver::table {
namespace {

namespace fs = std::filesystem;

using Entry = const Hdf5Plugin* (*)();

tl::expected<const Hdf5Plugin*, std::string> load() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const std::array places{program / "slipbench-hdf5.so",
                          program.parent_path() / "lib" / "slipbench" / "slipbench-hdf5.so"};
  for (const fs::path& place : places) {
    if (!fs::exists(place, error)) continue;
    void* const library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      return tl::unexpected(fmt::format("HDF5 cannot be used: {}", dlerror()));
    }
    const auto entry = reinterpret_cast<Entry>(dlsym(library, "slipbench_hdf5"));
    const Hdf5Plugin* const plugin = entry == nullptr ? nullptr : entry();
    if (plugin == nullptr || std::string_view(plugin->version) != SLIPBENCH_VERSION) {
      return tl::unexpected(
          fmt::format("HDF5 cannot be used: {} is of another version", place.string()));
    }
    return plugin;
  }
  return tl::unexpected(fmt::format(
      "HDF5 cannot be used: there is no {}; it is built where CMake finds HDF5 (Debian: "
      "libhdf5-dev). csv and npy need nothing",
      places[0].string()));
}

}  // namespace

tl::expected<const Hdf5Plugin*, std::string> hdf5_plugin() {
  static const tl::expected<const Hdf5Plugin*, std::string> kPlugin = load();
  return kPlugin;
}

}  // namespace slipbench::driver::table
