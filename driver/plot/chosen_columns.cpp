// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/chosen_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/base/text/suggestions.hpp"
#include "driver/plot/definition.hpp"

namespace slipbench::driver::plot {
namespace {

bool has(const results::ResultLayout& layout, const std::string& name) {
  return std::find(layout.columns.begin(), layout.columns.end(), name) != layout.columns.end();
}

}  // namespace

tl::expected<results::ResultLayout, PlotFailure> layout_for_plot(const ResultRows& rows) {
  const auto opened =
      base::CsvReader::open(rows.file, std::vector<std::string>{"t"}, rows.shown_name);
  if (!opened) return unreadable(rows.shown_name, opened.error());
  results::ResultLayout layout = results::read_layout(rows.file, opened->header());
  if (std::string fault = results::result_fault(layout, rows.file); !fault.empty()) {
    return unreadable(rows.shown_name,
                      {base::HistoryError::Kind::kInput, rows.shown_name, 0, 0, std::move(fault)});
  }
  return layout;
}

tl::expected<results::PlotColumn, PlotFailure> chosen_column(const ResultRows& rows,
                                                             const results::ResultLayout& layout,
                                                             const std::string& name) {
  if (has(layout, name)) {
    const auto unit = layout.column_units.find(name);
    return results::PlotColumn{name, unit == layout.column_units.end() ? "" : unit->second};
  }
  const std::vector<std::string_view> names(layout.columns.begin(), layout.columns.end());
  return failed(
      base::kExitBadInput,
      fmt::format("{}: has no column '{}'; {}; the first line without '#' of a result "
                  "lists its columns, 'slipbench list quantities' tells what they are",
                  rows.shown_name, name,
                  base::did_you_mean(name, names, "it has " + base::few_in_words(names))));
}

tl::expected<UsualColumns, PlotFailure> usual_columns(const ResultRows& rows,
                                                      const results::ResultLayout& layout) {
  UsualColumns usual;
  results::PlotData data = results::select_plot_columns(layout);
  if (data.definitions.empty()) return usual;
  std::vector<std::string> names;
  for (const results::PlotColumn& column : data.columns) names.push_back(column.name);
  data.lowest.assign(names.size(), std::numeric_limits<double>::infinity());
  data.highest.assign(names.size(), -std::numeric_limits<double>::infinity());
  const auto read = results::each_row(rows.file, rows.shown_name, names,
                                      [&](std::span<const double> row, std::int64_t) {
                                        for (std::size_t k = 0; k < row.size(); ++k) {
                                          data.lowest[k] = std::min(data.lowest[k], row[k]);
                                          data.highest[k] = std::max(data.highest[k], row[k]);
                                        }
                                      });
  if (!read) return unreadable(rows.shown_name, read.error());
  const results::PlotDefinition& definition = data.definitions.front();
  if (definition.components.empty()) {
    usual.force = column_of(data, main_force(definition)).name;
    return usual;
  }
  const std::size_t shown = shown_component(data, definition);
  usual.force = column_of(data, definition.components[shown]).name;
  if (!moves(data, definition.positions[shown])) return usual;
  usual.position = column_of(data, definition.positions[shown]).name;
  // CP1 goes with CV1, CPR1 with CVR1.
  const std::string velocity = "CV" + usual.position.substr(2);
  if (has(layout, velocity)) usual.velocity = velocity;
  return usual;
}

std::string column_label(const results::PlotColumn& column) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kWords{
      {{"t", "time"},
       {"CSF", "friction force"},
       {"CSM", "friction moment"},
       {"CPR", "angle"},
       {"CP", "position"},
       {"CVR", "angular velocity"},
       {"CV", "velocity"},
       {"FN", "normal force"}}};
  for (const auto& [begins, word] : kWords) {
    const bool whole = begins == "t";
    if (whole ? column.name == begins : column.name.starts_with(begins)) {
      return axis_label(word, column);
    }
  }
  return axis_label(column.name, {"", column.unit});
}

}  // namespace slipbench::driver::plot
