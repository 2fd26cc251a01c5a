// SPDX-License-Identifier: Apache-2.0
#include "driver/results/csv_writer.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver::results {
namespace {

/// So many rows become text together.
constexpr std::size_t kTogether = 4096;

void append_rows(std::span<const double> numbers, std::size_t width, base::OutputFile& file) {
  std::string& text = file.buffer();
  for (std::size_t i = 0; i < numbers.size(); i += width) {
    base::append_numbers(text, numbers.subspan(i, width));
    text.back() = '\n';
    file.flush_if_full();
  }
}

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

}  // namespace

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
  for (const Column& column : columns_) numbers_.push_back(column_value(column, *case_, row));
  if (numbers_.size() >= kTogether * columns_.size()) hand_over();
}

void CsvWriter::finish() {
  if (formatting_.valid()) formatting_.get();
  append_rows(numbers_, columns_.size(), *file_);
  numbers_.clear();
}

void CsvWriter::hand_over() {
  if (formatting_.valid()) formatting_.get();
  std::swap(numbers_, on_way_);
  numbers_.clear();
  try {
    formatting_ =
        std::async(std::launch::async, [this] { append_rows(on_way_, columns_.size(), *file_); });
  } catch (const std::system_error&) {
    append_rows(on_way_, columns_.size(), *file_);  // the system gives no more threads
  }
}

}  // namespace slipbench::driver::results
