// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <future>
#include <memory>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"
#include "driver/table/table_writer.hpp"

namespace slipbench::driver::results {

/// Returns the head of the rows of a run: provenance, the units and the names of the columns.
table::TableHead row_head(const cases::Case& problem, std::span<const Column> columns);

/// Writes the rows of a run. Many rows become text on a thread of their own, beside the run; the
/// bytes do not depend on it.
class RowWriter {
 public:
  /// Writes what stands before the rows. Both `problem` and `file` must outlive the writer; the
  /// file is the writer's own until it has brought its rows. Error: that of TableWriter::create.
  static tl::expected<std::unique_ptr<RowWriter>, std::string> create(const cases::Case& problem,
                                                                      std::vector<Column> columns,
                                                                      table::TableFormat format,
                                                                      base::OutputFile& file);
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;

  void write(const bench::Row& row);
  /// Brings all rows to the file, which others may look at until the next row.
  void bring();
  /// Bytes that what was brought takes of the disk, in the end.
  std::uintmax_t bytes() const { return table_.bytes(); }
  /// Brings all rows and completes the file but for its name. Error: a sentence.
  tl::expected<void, std::string> finish();

 private:
  RowWriter(const cases::Case& problem, std::vector<Column> columns, table::TableWriter table)
      : case_(&problem), columns_(std::move(columns)), table_(std::move(table)) {}
  void hand_over();

  const cases::Case* case_;
  std::vector<Column> columns_;
  table::TableWriter table_;
  std::vector<double> numbers_;   ///< of rows that are still to be written
  std::vector<double> on_way_;    ///< of those that are being written
  std::future<void> formatting_;  ///< the last member: it is waited for before the others go
};

}  // namespace slipbench::driver::results
