// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/csv/data_source.hpp"
#include "driver/base/text/history_error.hpp"

namespace slipbench::driver::base {

/// So many columns a file has, at most: every check that names the file looks through them.
inline constexpr std::size_t kMostColumns = 10'000;

/// Reads chosen columns of a CSV file row by row, in blocks: the memory does not grow with the
/// file.
///
/// The file is text, UTF-8 (its names may be Latin-1): comment lines that start with '#', one
/// header row with at most kMostColumns names, then rows of numbers. Lines end with LF or CRLF, a
/// UTF-8 byte order mark is skipped, names and numbers may stand in double quotes; separator and
/// decimal mark are those of the format, whatever the locale. A column is found by its name in the
/// header, or by that without the unit behind it: 'Force' is 'Force (N)' too. Columns that are not
/// asked for may hold anything. Every error names the line, the column where one is concerned, and
/// the option of a data source that would read the file if there is one.
class CsvReader {
 public:
  /// Opens the file and finds `columns` in its header.
  ///
  /// Errors of the kind kEnvironment: missing, unreadable, or no regular file (a directory, a FIFO,
  /// a device; never waits for one). Of the kind kInput: empty, no header row, no such column or
  /// two of that name, a trailing separator, no row of units where the format has one, UTF-16,
  /// lines that end with CR only.
  static tl::expected<CsvReader, HistoryError> open(const DataSource& source,
                                                    std::span<const std::string> columns);

  /// Opens a file of the default format. `shown_name` is how errors name it; its path when empty.
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
  /// 1,5, 1e400), no row at all. A sample that is missing is refused, held, or its row left out, as
  /// the format says. After an error, and at the end, the reader stays where it is.
  tl::expected<bool, HistoryError> next(std::span<double> values);

  /// The same, and the fields as they are written (without quotes and blanks; empty where a value
  /// was held), valid until the next call.
  tl::expected<bool, HistoryError> next(std::span<double> values,
                                        std::span<std::string_view> texts);

  /// A place between two rows of the file.
  struct Place {
    off_t offset = 0;
    long next_line = 0;
    long row_line = 0;              ///< of the row before it
    long rows = 0;                  ///< before it
    std::vector<double> held = {};  ///< for the samples that are missing behind it
  };

  /// Sets `place` to the one behind the last row read; allocates nothing if it was a place of this
  /// reader before.
  void note_place(Place* place) const;

  /// Goes back to a place of the file. Error: the file cannot be read again.
  tl::expected<void, HistoryError> go_back(const Place& place);

  /// Goes back to before the first row. Error: the file cannot be read again.
  tl::expected<void, HistoryError> rewind();

  /// The line of the last row read, counted from 1; the header's line before the first row.
  long line() const;

  /// The names of all columns of the file.
  std::span<const std::string> header() const;

  /// The column of the file that is meant by a name; nothing if there is none, or more than one.
  std::optional<std::size_t> find(std::string_view column) const;

  /// The unit that the file states for a column: in its row of units, or else behind the name in
  /// the header, or else in a line "# columns: NAME [unit], .." above it, as the program's own
  /// files have it ("-" where it says there is none). Empty if it states none, and for what is no
  /// unit ("Force (left)").
  std::string_view unit(std::string_view column) const;

  /// The unit that the line above the header states for a column, or empty.
  std::string_view unit_above(std::string_view column) const;

  /// "; write {file: rig.csv, skip: 4}" if so written the file would have these columns and rows of
  /// numbers below them; empty otherwise.
  std::string remedy(std::span<const std::string> columns) const;

  /// The samples that were missing up to here, since the first row.
  const MissingSamples& missing() const;

  /// Returns how errors name the file.
  const std::string& name() const;

  /// An input error at the line of the last row read.
  tl::unexpected<HistoryError> error_here(std::string message) const;

 private:
  struct File;
  explicit CsvReader(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

/// The end of what count_missing says where less than half of the file is there.
inline constexpr std::string_view kMostIsMissing = "; that is most of the file";

/// Reads the whole file for what is missing in these columns, in words; reads nothing if nothing
/// may be missing. Errors: those of CsvReader.
tl::expected<std::string, HistoryError> count_missing(const DataSource& source,
                                                      std::span<const std::string> columns);

}  // namespace slipbench::driver::base
