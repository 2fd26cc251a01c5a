// SPDX-License-Identifier: Apache-2.0
#include "driver/results/csv_writer.hpp"

#include <fmt/format.h>

#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/result_layout.hpp"
#include "law/update/penalty_predictor.hpp"

namespace slipbench::driver::results {
namespace {

/// Lists the force columns of each definition: "# friction: sliding = CSFC(CSF2 CSF3),
/// spinning = CSM1".
std::string friction_line(const ResultLayout& layout) {
  std::string text;
  for (const FrictionColumns& friction : layout.friction) {
    const std::string forces = fmt::format("{}", fmt::join(friction.forces, " "));
    text += (text.empty() ? "# friction: " : ", ") + friction.name + " = " +
            (friction.coupled ? "CSFC(" + forces + ")" : forces);
  }
  return text.empty() ? text : text + "\n";
}

/// Returns where direction 1 of an orthotropic definition points in its two components: "#
/// direction1: friction1 = 0.6 0.8".
std::string direction_line(const ResultLayout& layout) {
  std::string text;
  for (const FrictionColumns& friction : layout.friction) {
    const auto first = layout.directions.find(friction.name);
    if (first == layout.directions.end()) continue;
    text += (text.empty() ? "# direction1: " : ", ") + friction.name + " = " +
            base::format_number(first->second[0]) + " " + base::format_number(first->second[1]);
  }
  return text.empty() ? text : text + "\n";
}

double representative_force(const cases::CaseDefinition& definition,
                            const law::FrictionState& state) {
  const law::SlipSpace& slip = definition.law.slip;
  if (!definition.coupled && slip.dimension == 1) return slip.scale[0] * state.force[0];
  return law::equivalent_force(definition.law, state);
}

}  // namespace

double representative_force(const cases::CaseDefinition& definition,
                            const bench::DefinitionRow& row) {
  return representative_force(definition, row.update.state);
}

double limited_force(const cases::CaseDefinition& definition, const bench::DefinitionRow& row) {
  if (!definition.law.formulation) return representative_force(definition, row);
  return representative_force(definition, limited_state(definition.law, row));
}

law::FrictionState limited_state(const law::FrictionDefinition& definition,
                                 const bench::DefinitionRow& row) {
  law::FrictionState state = row.update.state;
  if (definition.formulation && law::smooths(*definition.formulation)) {
    state.force = row.penalty.raw;
  }
  return state;
}

CsvWriter::CsvWriter(const cases::Case& problem, std::vector<Column> columns,
                     base::OutputFile& file)
    : case_(&problem), columns_(std::move(columns)), file_(&file) {
  file.append(provenance_lines(problem));
  const ResultLayout layout = layout_of(problem, columns_);
  file.append(friction_line(layout));
  file.append(direction_line(layout));
  std::string units;
  for (const Column& column : columns_) {
    units += (units.empty() ? "# columns: " : ", ") + column.name + " [" +
             base::unit_text(column.dimension, problem.units) + "]";
  }
  file.append(units + "\n");
  std::string header;
  for (const Column& column : columns_) header += (header.empty() ? "" : ",") + column.name;
  file.append(header + "\n");
}

void CsvWriter::write(const bench::Row& row) {
  std::string& text = file_->buffer();
  for (const Column& column : columns_) {
    base::append_number(text, column_value(column, *case_, row));
    text += ',';
  }
  text.back() = '\n';
  file_->flush_if_full();
}

}  // namespace slipbench::driver::results
