// SPDX-License-Identifier: Apache-2.0
#include "driver/results/row_writer.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "driver/base/csv/comment_lines.hpp"
#include "driver/base/text/format_number.hpp"
#include "driver/results/provenance.hpp"
#include "driver/results/result_layout.hpp"

namespace slipbench::driver::results {
namespace {

/// So many rows are written together.
constexpr std::size_t kTogether = 4096;

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

table::TableHead row_head(const cases::Case& problem, std::span<const Column> columns) {
  table::TableHead head;
  head.lines = provenance_lines(problem);
  const std::vector<Column> all(columns.begin(), columns.end());
  const ResultLayout layout = layout_of(problem, all);
  head.lines += friction_line(layout) + direction_line(layout);
  std::string units;
  for (const Column& column : columns) {
    units += (units.empty() ? std::string(base::kColumnsMark) : ", ") + column.name + " [" +
             base::unit_text(column.dimension, problem.units) + "]";
    head.columns.push_back(column.name);
  }
  head.lines += units + "\n";
  return head;
}

tl::expected<std::unique_ptr<RowWriter>, std::string> RowWriter::create(const cases::Case& problem,
                                                                        std::vector<Column> columns,
                                                                        table::TableFormat format,
                                                                        base::OutputFile& file) {
  auto table = table::TableWriter::create(format, row_head(problem, columns), file);
  if (!table) return tl::unexpected(std::move(table.error()));
  return std::unique_ptr<RowWriter>(new RowWriter(problem, std::move(columns), std::move(*table)));
}

void RowWriter::write(const bench::Row& row) {
  for (const Column& column : columns_) numbers_.push_back(column_value(column, *case_, row));
  if (numbers_.size() >= kTogether * columns_.size()) hand_over();
}

void RowWriter::bring() {
  if (formatting_.valid()) formatting_.get();
  table_.write(numbers_);
  numbers_.clear();
}

tl::expected<void, std::string> RowWriter::finish() {
  bring();
  return table_.finish();
}

void RowWriter::hand_over() {
  if (formatting_.valid()) formatting_.get();
  std::swap(numbers_, on_way_);
  numbers_.clear();
  try {
    formatting_ = std::async(std::launch::async, [this] { table_.write(on_way_); });
  } catch (const std::system_error&) {
    table_.write(on_way_);  // the system gives no more threads
  }
}

}  // namespace slipbench::driver::results
