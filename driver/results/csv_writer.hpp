// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <future>
#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::results {

/// Writes the rows of a run as CSV: provenance lines, the header, and a line a row with the
/// shortest numbers that read back to the same double. Many rows become text on a thread of their
/// own, beside the run; the bytes do not depend on it.
class CsvWriter {
 public:
  /// Writes provenance and header. Both `problem` and `file` must outlive the writer; the file is
  /// the writer's own until finish().
  CsvWriter(const cases::Case& problem, std::vector<Column> columns, base::OutputFile& file);
  void write(const bench::Row& row);
  /// Brings all rows to the file, which others may look at until the next row.
  void finish();

 private:
  void hand_over();

  const cases::Case* case_;
  std::vector<Column> columns_;
  base::OutputFile* file_;
  std::vector<double> numbers_;   ///< of rows that are still to become text
  std::vector<double> on_way_;    ///< of those that are becoming text
  std::future<void> formatting_;  ///< the last member: it is waited for before the others go
};

}  // namespace slipbench::driver::results
