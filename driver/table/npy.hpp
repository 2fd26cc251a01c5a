// SPDX-License-Identifier: Apache-2.0
// The head of NumPy's .npy files (format: numpy.lib.format; version 1, with names beyond ASCII 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace slipbench::driver::table {

/// Returns all that stands before the records; equally long for any number of rows.
/// Error: the names of so many columns have no room in it, in a sentence.
tl::expected<std::string, std::string> npy_head(std::span<const std::string> columns,
                                                std::uint64_t rows);

/// Returns the text by which a file of these columns is known: it stands in its head.
std::string npy_columns(std::span<const std::string> columns);

/// The things that a head says.
struct NpyHead {
  std::vector<std::string> columns;
  std::uint64_t rows = 0;
  std::size_t size = 0;  ///< bytes before the records
};

/// Reads the head of a file from its first bytes. Error: it is no .npy file, or not of records of
/// doubles as npy_head writes them, or of a plain array of doubles in two dimensions (whose columns
/// are called c1, c2, ..); a sentence.
tl::expected<NpyHead, std::string> read_npy_head(std::string_view begin);

}  // namespace slipbench::driver::table
