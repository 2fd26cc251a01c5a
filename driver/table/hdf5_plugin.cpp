// SPDX-License-Identifier: Apache-2.0
#include "driver/table/hdf5_plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string_view>

#include "driver/base/files/plugin_path.hpp"

namespace slipbench::driver::table {
namespace {

constexpr const char* kFile = "slipbench-hdf5.so";

using Entry = const Hdf5Plugin* (*)();

tl::expected<const Hdf5Plugin*, std::string> load() {
  // The program itself can be opened, unless it is linked to load nothing (slipbench_static).
  if (dlopen(nullptr, RTLD_NOW) == nullptr) {
    return tl::unexpected(
        fmt::format("HDF5 cannot be used: {}; csv and npy need nothing", dlerror()));
  }
  const auto place = base::plugin_path(kFile);
  if (!place) {
    return tl::unexpected(fmt::format(
        "HDF5 cannot be used: there is no {}; it is built where CMake finds HDF5 (Debian: "
        "libhdf5-dev). csv and npy need nothing",
        kFile));
  }
  void* const library = dlopen(place->c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return tl::unexpected(fmt::format("HDF5 cannot be used: {}", dlerror()));
  }
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "slipbench_hdf5"));
  const Hdf5Plugin* const plugin = entry == nullptr ? nullptr : entry();
  if (plugin == nullptr || std::string_view(plugin->version) != SLIPBENCH_VERSION) {
    return tl::unexpected(
        fmt::format("HDF5 cannot be used: {} is of another version", place->string()));
  }
  return plugin;
}

}  // namespace

tl::expected<const Hdf5Plugin*, std::string> hdf5_plugin() {
  static const tl::expected<const Hdf5Plugin*, std::string> kPlugin = load();
  return kPlugin;
}

}  // namespace slipbench::driver::table
