// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>

#include "driver/table/table_head.hpp"

namespace slipbench::driver::table {

/// Rows of numbers that are read from a file, some at a time.
class TableReader {
 public:
  virtual ~TableReader() = default;
  virtual const TableHead& head() const = 0;

  /// Reads the next rows, as many as there is room for; none at the end. Error: a sentence.
  /// \param numbers room for whole rows
  virtual tl::expected<std::size_t, std::string> read(std::span<double> numbers) = 0;
};

/// Opens a file by its ending. A CSV file is one as this program writes it: lines with "#", names,
/// rows of numbers between commas, of which some may be nan. Error: it cannot be read, or is no
/// table; a sentence that begins with its path.
tl::expected<std::unique_ptr<TableReader>, std::string> open_table(
    const std::filesystem::path& file);

}  // namespace slipbench::driver::table
