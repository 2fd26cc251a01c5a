// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/history/history_error.hpp"

namespace slipbench::driver {

/// Reads chosen columns of a CSV file row by row, in blocks: the memory does not grow with the
/// file.
///
/// The file is text: comment lines that start with '#', one header row with the columns' names,
/// then rows of numbers. Columns are separated by ',', ';' or tabs (the header shows which), lines
/// end with LF or CRLF, a UTF-8 byte order mark is skipped, names and numbers may stand in double
/// quotes, the decimal mark is '.' whatever the locale. Columns nobody asked for may hold anything.
/// Every error names the line, and the column where one is concerned.
class CsvReader {
 public:
  /// Opens `file` and finds `columns` in its header. `shown_name` is how errors name the file; its
  /// path when empty.
  ///
  /// Errors of the kind kEnvironment: missing, unreadable, or no regular file (a directory, a FIFO,
  /// a device; never waits for one). Of the kind kInput: empty, no header row, no such column or
  /// two of that name, a trailing separator, UTF-16, lines that end with CR only.
  static tl::expected<CsvReader, HistoryError> open(const std::filesystem::path& file,
                                                    std::span<const std::string> columns,
                                                    std::string shown_name = {});

  CsvReader(CsvReader&&) noexcept;
  CsvReader& operator=(CsvReader&&) noexcept;
  ~CsvReader();

  /// Reads the next row into `values`, one number for each of the columns given to `open` and in
  /// that order; false at the end of the file.
  ///
  /// Errors: a row with more or fewer fields than the header, a blank line before the last row, a
  /// trailing separator, a field that is not a finite number in the range of a double (text, nan,
  /// 1,5, 1e400), no row at all. After an error, and at the end, the reader stays where it is.
  tl::expected<bool, HistoryError> next(std::span<double> values);

  /// The same, and the fields as they are written (without quotes and blanks), valid until the next
  /// call.
  tl::expected<bool, HistoryError> next(std::span<double> values,
                                        std::span<std::string_view> texts);

  /// Goes back to before the first row. Error: the file cannot be read again.
  tl::expected<void, HistoryError> rewind();

  /// The line of the last row read, counted from 1; the header's line before the first row.
  long line() const;

  /// The names of all columns of the file.
  std::span<const std::string> header() const;

  /// How errors name the file.
  const std::string& name() const;

  /// An input error at the line of the last row read.
  tl::unexpected<HistoryError> error_here(std::string message) const;

 private:
  struct File;
  explicit CsvReader(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace slipbench::driver
