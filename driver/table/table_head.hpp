// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slipbench::driver::table {

/// The part before the rows of a result: where they come from, and the names of the columns.
struct TableHead {
  std::string lines;  ///< of a CSV file that begin with "#", each with its end
  std::vector<std::string> columns;
};

/// Returns all that stands before the rows of a CSV file.
std::string csv_head(const TableHead& head);

/// Format of a file with rows of numbers.
///   - CSV: the lines of the head, the names, a line a row.
///   - npy: version 1 (with names beyond ASCII 3) of NumPy's format, one dimension of records with
///   a double (f8, little endian)
///     a column; it has no place for the lines of the head.
///   - HDF5: a contiguous dataset of doubles a column, with its unit as an attribute; the lines of
///     the head are attributes of the root.
enum class TableFormat : std::uint8_t { kCsv, kNpy, kHdf5 };

/// The formats by their words, which are endings of file names, too.
inline constexpr std::array<std::string_view, 3> kTableFormats{"csv", "npy", "h5"};

/// Returns the format that an ending stands for (".csv", ".npy", ".h5", ".hdf5"), or nothing.
std::optional<TableFormat> format_of(const std::filesystem::path& file);
/// The same of a word of kTableFormats.
std::optional<TableFormat> format_named(std::string_view word);

/// Returns the unit that the head states for a column, "mm" in "# columns: CP1 [mm], ..", or
/// nothing.
std::string unit_of(const TableHead& head, std::string_view column);

}  // namespace slipbench::driver::table
