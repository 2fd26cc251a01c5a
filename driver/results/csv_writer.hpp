// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "driver/base/files/output_file.hpp"
#include "driver/bench/simulation.hpp"
#include "driver/case/case.hpp"
#include "driver/results/columns.hpp"

namespace slipbench::driver::results {

/// Writes the rows of a run as CSV: provenance lines, the header, and a line a row with the
/// shortest numbers that read back to the same double.
class CsvWriter {
 public:
  /// Writes provenance and header. Both `problem` and `file` must outlive the writer.
  CsvWriter(const cases::Case& problem, std::vector<Column> columns, base::OutputFile& file);
  void write(const bench::Row& row);

 private:
  const cases::Case* case_;
  std::vector<Column> columns_;
  base::OutputFile* file_;
};

/// The friction force a definition is known by: that of its component, signed, or P of a coupled
/// definition.
double representative_force(const cases::CaseDefinition& definition,
                            const bench::DefinitionRow& row);

/// The same of the force that the limit bounds: with a filter, that before it.
double limited_force(const cases::CaseDefinition& definition, const bench::DefinitionRow& row);

/// The state of a row with the force that the limit bounds.
law::FrictionState limited_state(const law::FrictionDefinition& definition,
                                 const bench::DefinitionRow& row);

}  // namespace slipbench::driver::results
