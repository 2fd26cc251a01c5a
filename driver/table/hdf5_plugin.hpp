// SPDX-License-Identifier: Apache-2.0
// HDF5 is a plug-in, slipbench-hdf5.so, opened when a file wants it: the library alone would take
// longer to load than a small case to run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/table/table_head.hpp"
#include "driver/table/table_reader.hpp"

namespace slipbench::driver::table {

/// The two things that the plug-in does. It is built with the program: types of C++ pass between
/// them.
struct Hdf5Plugin {
  const char* version;  ///< of the program it was built with
  /// Writes a table to a file that is there and empty. `read` brings its rows, in pieces.
  /// Returns a sentence on error, or nothing.
  std::string (*write)(const std::filesystem::path& file, const TableHead& head,
                       std::span<const std::string> units, std::uint64_t rows,
                       const std::function<std::size_t(std::span<double>)>& read);
  /// Opens a file. Error: it is no table, a sentence.
  tl::expected<std::unique_ptr<TableReader>, std::string> (*open)(
      const std::filesystem::path& file);
};

/// Opens the plug-in, which lies beside the program or in ../lib/slipbench. Error: it does not, or
/// is of another version; a sentence that says what to install.
tl::expected<const Hdf5Plugin*, std::string> hdf5_plugin();

}  // namespace slipbench::driver::table
