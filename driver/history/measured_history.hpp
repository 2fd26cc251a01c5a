// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/history_error.hpp"
#include "driver/base/units/units.hpp"

namespace slipbench::driver::history {

/// One driven quantity of a measured history.
struct MeasuredColumn {
  std::size_t quantity = 0;         ///< The driver's number for the quantity; only handed back.
  std::string column;               ///< The column's name in the file.
  base::UnitConversion conversion;  ///< From the column's unit to the case's.
};

/// Origin of a measured history.
struct MeasuredSource {
  base::DataSource data;
  std::string time_column;
  base::UnitConversion time_conversion;
  std::vector<MeasuredColumn> columns;
  bool hold = false;  ///< How the quantities behave between rows; see `between_rows`.
};

/// The value at time `t` between the rows (t0, v0) and (t1, v1), t0 < t1.
///
/// Without `hold` the quantity goes linearly from one row to the next. With `hold` it keeps the
/// earlier row's value and takes the later row's at t1: what an instrument reports that samples and
/// holds, or a valve that is switched. Either way an increment that ends at a row's time ends with
/// the row's values; `hold` is felt by whatever divides the time between two rows.
double between_rows(double t0, double v0, double t1, double v1, double t, bool hold);

/// Rows of measured data as the driver's increments, streamed: the memory does not depend on the
/// number of rows. A row's time is the end of the increment that leads to it; the first row is
/// where the history starts.
class MeasuredHistory {
 public:
  /// Opens the file and finds its columns. Errors: those of `CsvReader::open`.
  static tl::expected<MeasuredHistory, base::HistoryError> open(MeasuredSource source);

  /// Reads the next row; false at the end. Errors: those of `CsvReader::next`; times that do not
  /// increase (naming both); a single row; a number that the change of unit makes infinite.
  tl::expected<bool, base::HistoryError> advance();

  /// Time of the last row read, in the case's unit.
  double time() const { return time_; }

  /// The last row's values in the order of the source's columns, in the case's units.
  std::span<const double> values() const { return std::span<const double>(row_).subspan(1); }

  /// The line of the last row read, counted from 1.
  long line() const { return reader_.line(); }

  /// Goes back to before the last two rows that were read up to time 0, or else the first: what
  /// lies before a step is read once, however often the step is repeated. Error: the file cannot be
  /// read again.
  tl::expected<void, base::HistoryError> rewind();

  const MeasuredSource& source() const { return source_; }

  /// Returns how errors name the file.
  const std::string& name() const { return reader_.name(); }

  /// An input error at the line of the last row read.
  tl::unexpected<base::HistoryError> error_here(std::string message) const;

 private:
  MeasuredHistory(MeasuredSource source, base::CsvReader reader);

  MeasuredSource source_;
  base::CsvReader reader_;
  std::vector<double> row_;  ///< Time, then the values.
  double time_ = 0.0;
  long rows_ = 0;

  /// State before a row.
  struct Before {
    base::CsvReader::Place place;
    double raw_time = 0.0;
    double time = 0.0;
    long rows = 0;
  };
  Before before_;  ///< before the row that is being read
  Before last_;    ///< before the row read last
  Before start_;   ///< before the two rows from which a step begins; the first row at first
};

}  // namespace slipbench::driver::history
