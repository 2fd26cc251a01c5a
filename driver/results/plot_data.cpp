// SPDX-License-Identifier: Apache-2.0
#include "driver/results/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "driver/base/csv/csv_reader.hpp"
#include "driver/case/quantity.hpp"
#include "driver/results/pixel_columns.hpp"
#include "law/base/notation.hpp"

namespace slipbench::driver::results {
namespace {

/// The position a friction force column goes with: CSF1 with CP1, CSM2 with CPR2, CSF2.ring1 with
/// CP2, which is the flow over all rings where a ring has none of its own.
std::string position_of(const std::string& column) {
  const std::string force = column.substr(0, column.find('.'));
  for (int c = 0; c < law::kComponents; ++c) {
    if (force == cases::force_column("CSF", c)) return cases::motion_name(c);
  }
  return {};
}

/// Chooses the columns to draw and says what they are of each definition.
class Selection {
 public:
  Selection(const ResultLayout& layout, PlotData& data) : layout_(layout), data_(data) {
    for (const std::string& name : layout.columns) places_.emplace(name, -1);
  }

  void select(PlotDetail detail) {
    add("t");
    for (const FrictionColumns& friction : layout_.friction) {
      PlotDefinition definition;
      definition.name = friction.name;
      definition.several = layout_.friction.size() > 1;
      const std::string suffix = definition.several ? "." + friction.name : "";
      if (friction.coupled) definition.total = add("CSFC");
      for (const std::string& force : friction.forces) {
        const int column = add(force);
        if (column < 0) continue;
        definition.components.push_back(column);
        const int own = definition.several ? add(position_of(force) + suffix) : -1;
        definition.positions.push_back(own >= 0 ? own : add(position_of(force)));
      }
      // A belt has another limit in each sense; FLIM is only that of the side its force lies on.
      const std::string& first = friction.forces.empty() ? friction.name : friction.forces.front();
      const std::string of_belt = first.substr(0, first.find('.'));
      definition.limit_below = add(of_belt + "_MIN" + first.substr(of_belt.size()));
      definition.limit = definition.limit_below >= 0
                             ? add(of_belt + "_MAX" + first.substr(of_belt.size()))
                             : add("FLIM" + suffix);
      definition.status = add("STATUS" + suffix);
      if (const auto direction = layout_.directions.find(friction.name);
          direction != layout_.directions.end()) {
        definition.direction = direction->second;
        definition.normal_force = add("FN" + suffix);
        definition.coefficients = {add("MU1" + suffix), add("MU2" + suffix)};
      }
      if (detail == PlotDetail::kState) {
        definition.normal_force = add("FN" + suffix);
        definition.mu = add("MU" + suffix);
        definition.dissipation = add("DISS" + suffix);
        definition.stored_energy = add("STRAIN_E" + suffix);
        definition.work = add("WORK" + suffix);
      }
      if (definition.total >= 0 || !definition.components.empty()) {
        data_.definitions.push_back(std::move(definition));
      }
    }
  }

 private:
  int add(const std::string& name) {
    const auto place = places_.find(name);
    if (place == places_.end()) return -1;
    if (place->second < 0) {
      place->second = static_cast<int>(data_.columns.size());
      const auto unit = layout_.column_units.find(name);
      data_.columns.push_back({name, unit == layout_.column_units.end() ? "" : unit->second});
    }
    return place->second;
  }

  const ResultLayout& layout_;
  PlotData& data_;
  /// Places among the drawn columns, by the names of the result's; -1: not drawn so far.
  std::unordered_map<std::string_view, int> places_;
};

}  // namespace

PlotData select_plot_columns(const ResultLayout& layout, PlotDetail detail) {
  PlotData data;
  data.title = layout.title;
  Selection(layout, data).select(detail);
  return data;
}

tl::expected<void, base::HistoryError> each_row(
    const std::filesystem::path& file, const std::string& shown_name,
    const std::vector<std::string>& columns,
    const std::function<void(std::span<const double>, std::int64_t)>& take) {
  auto reader = base::CsvReader::open(file, columns, shown_name);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  std::vector<double> row(columns.size());
  for (std::int64_t index = 0;; ++index) {
    auto more = reader->next(row);
    if (!more) return tl::unexpected(std::move(more.error()));
    if (!*more) return {};
    take(row, index);
  }
}

tl::expected<PlotData, base::HistoryError> read_plot_data(const std::filesystem::path& file,
                                                          const std::string& shown_name,
                                                          PlotDetail detail, std::size_t pixels) {
  auto opened = base::CsvReader::open(file, std::vector<std::string>{"t"}, shown_name);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  const ResultLayout layout = read_layout(file, opened->header());
  if (std::string fault = result_fault(layout, file); !fault.empty()) {
    return tl::unexpected(
        base::HistoryError{base::HistoryError::Kind::kInput, shown_name, 0, 0, std::move(fault)});
  }
  PlotData data = select_plot_columns(layout, detail);
  if (data.definitions.empty()) {
    return tl::unexpected(base::HistoryError{
        base::HistoryError::Kind::kInput, shown_name, 0, 0,
        "has no friction force to draw (a result of 'slipbench run' has a line '# friction:')"});
  }
  std::vector<std::string> names;
  for (const PlotColumn& column : data.columns) names.push_back(column.name);

  data.lowest.assign(names.size(), std::numeric_limits<double>::infinity());
  data.highest.assign(names.size(), -std::numeric_limits<double>::infinity());
  std::vector<RegimeRecorder> regimes(data.definitions.size());
  std::vector<int> now(data.definitions.size());
  double before = 0.0;
  std::optional<std::string> strange;
  auto read = each_row(file, shown_name, names, [&](std::span<const double> row, std::int64_t at) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      data.lowest[k] = std::min(data.lowest[k], row[k]);
      data.highest[k] = std::max(data.highest[k], row[k]);
    }
    for (std::size_t d = 0; d < regimes.size(); ++d) {
      const int status = data.definitions[d].status;
      if (status < 0) continue;
      // A row tells the regime of the increment that it ends.
      const double number = row[static_cast<std::size_t>(status)];
      const auto regime = regime_of(number);
      if (!regime && !strange) strange = no_regime(number, row[0]);
      if (!regime) continue;
      if (at == 0) regimes[d].begin(*regime, row[0]);
      if (at > 0 && *regime != now[d]) regimes[d].change(*regime, before);
      now[d] = *regime;
    }
    before = row[0];
    data.rows_in_all = at + 1;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  if (strange) {
    return tl::unexpected(base::HistoryError{base::HistoryError::Kind::kInput, shown_name, 0, 0,
                                             std::move(*strange)});
  }
  for (std::size_t d = 0; d < regimes.size(); ++d) {
    data.definitions[d].regimes = regimes[d].end(before);
  }
  PixelColumns columns(names.size(), data.lowest[0], data.highest[0], pixels);
  read = each_row(file, shown_name, names,
                  [&](std::span<const double> row, std::int64_t) { columns.add(row); });
  if (!read) return tl::unexpected(std::move(read.error()));
  data.rows = columns.finish();
  return data;
}

}  // namespace slipbench::driver::results
