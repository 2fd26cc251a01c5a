// SPDX-License-Identifier: Apache-2.0
#include "driver/results/csv_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "driver/case/quantity.hpp"
#include "driver/results/provenance.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

/// Which force columns belong to which definition: "# friction: sliding = CSFC(CSF2 CSF3),
/// spinning = CSM1".
std::string friction_line(const Case& problem) {
  std::string text;
  for (const CaseDefinition& definition : problem.definitions) {
    const law::SlipSpace& slip = definition.law.slip;
    std::string components;
    for (int k = 0; k < slip.dimension; ++k) {
      components += (components.empty() ? "" : " ") +
                    force_column("CSF", slip.component[static_cast<std::size_t>(k)]);
    }
    if (definition.coupled) components = "CSFC(" + components + ")";
    text += (text.empty() ? "# friction: " : ", ") + definition.name + " = " + components;
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

const char* regime_name(law::Regime regime) {
  if (regime == law::Regime::kOpen) return "open";
  return regime == law::Regime::kStick ? "stick" : "slip";
}

double representative_force(const CaseDefinition& definition, const DefinitionRow& row) {
  const law::SlipSpace& slip = definition.law.slip;
  const auto& y = row.update.state.force;
  if (!definition.coupled && slip.dimension == 1) return slip.scale[0] * y[0];
  double sum = 0.0;
  for (const double entry : y) sum += entry * entry;
  return std::sqrt(sum);
}

CsvWriter::CsvWriter(const Case& problem, std::vector<Column> columns, OutputFile& file)
    : case_(&problem), columns_(std::move(columns)), file_(&file) {
  file.append(provenance_lines(problem));
  file.append(friction_line(problem));
  std::string units;
  for (const Column& column : columns_) {
    units += (units.empty() ? "# columns: " : ", ") + column.name + " [" +
             unit_text(column.dimension, problem.units) + "]";
  }
  file.append(units + "\n");
  std::string header;
  for (const Column& column : columns_) header += (header.empty() ? "" : ",") + column.name;
  file.append(header + "\n");
}

void CsvWriter::write(const Row& row) {
  std::string& text = file_->buffer();
  for (const Column& column : columns_) {
    append_number(text, column_value(column, *case_, row));
    text += ',';
  }
  text.back() = '\n';
  file_->flush_if_full();
}

EventWriter::EventWriter(const Case& problem, OutputFile& file) : case_(&problem), file_(&file) {
  std::string text = provenance_lines(problem);
  text += "t,definition,from,to,force,limit,accumulated_slip";
  for (Column& column : result_columns(problem)) {
    if (column.source != ColumnSource::kPosition || !column.name.starts_with("CP")) continue;
    text += "," + column.name;
    positions_.push_back(std::move(column));
  }
  file.append(text + "\n");
}

void EventWriter::write(const Row& row) {
  if (row.index == 0) {
    regimes_.clear();
    for (const DefinitionRow& here : row.definitions) {
      regimes_.push_back(here.update.state.regime);
    }
    return;
  }
  for (std::size_t d = 0; d < row.definitions.size(); ++d) {
    const DefinitionRow& here = row.definitions[d];
    const law::Regime to = here.update.state.regime;
    const law::Regime from = std::exchange(regimes_[d], to);
    if (from == to) continue;
    std::string& text = file_->buffer();
    append_number(text, row.time);
    text.append(",").append(case_->definitions[d].name).append(",");
    text.append(regime_name(from)).append(",").append(regime_name(to));
    for (const double number : {representative_force(case_->definitions[d], here),
                                here.update.limit, here.update.state.accumulated_slip}) {
      text += ',';
      append_number(text, number);
    }
    for (const Column& position : positions_) {
      text += ',';
      append_number(text, column_value(position, *case_, row));
    }
    text += '\n';
    file_->flush_if_full();
  }
}

}  // namespace slipbench::driver
