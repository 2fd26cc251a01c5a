// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// The lines of a regular file, read in blocks. Its state is open to the reader of rows, which
/// works in the buffer itself.
struct LineReader {
  std::string name;  ///< how errors name the file
  int descriptor = -1;
  std::vector<char> buffer;
  std::size_t begin = 0;      ///< The first byte not yet read.
  std::size_t lines_end = 0;  ///< Behind the last complete line in the buffer.
  std::size_t end = 0;        ///< Behind the last byte in the buffer.
  bool at_end = false;        ///< Whether the file has no more bytes for the buffer.
  off_t buffer_offset = 0;    ///< Where in the file the buffer's first byte comes from.
  long next_line = 1;         ///< The line at `begin`.

  LineReader() = default;
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  ~LineReader();

  /// Errors are of the kind kEnvironment, as CsvReader::open says.
  tl::expected<void, HistoryError> open(const std::filesystem::path& file);

  /// Makes at least one complete line available at `begin`, unless the file has ended: then
  /// begin == lines_end. The last line gets the line end it may lack. Errors: the file cannot be
  /// read; a line of more than a megabyte.
  tl::expected<void, HistoryError> fill();

  /// The line at `begin`, which must be there, without its end; `begin` moves behind it.
  std::string_view take_line();

  /// Returns where in the file the line at `begin` starts.
  off_t offset() const { return buffer_offset + static_cast<off_t>(begin); }

  /// Goes back to where line `line` starts. Error: the file cannot be read again.
  tl::expected<void, HistoryError> go_back(off_t offset, long line);

  /// The first bytes of the file, a block of them at most; the place in the file stays.
  std::string head() const;

  /// An input error at a byte of a line.
  tl::unexpected<HistoryError> error(long line, std::size_t offset, std::string message) const;
};

}  // namespace slipbench::driver::base
