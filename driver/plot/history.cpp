// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "driver/base/text/tics.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"

namespace slipbench::driver::plot {
namespace {

/// From the lowest to the highest of some columns, 0 included, with room above and below.
struct AxisRange {
  double low = 0.0;
  double high = 0.0;
  double above = 0.08;  ///< room, as a part of the range

  void include(const results::PlotData& data, int column) {
    if (column < 0) return;
    const auto k = static_cast<std::size_t>(column);
    low = std::min(low, data.lowest[k]);
    high = std::max(high, data.highest[k]);
  }
  void tell(PlotScript& script, const std::string& name) const {
    const double range = high > low ? high - low : 1.0;
    const double bottom = low - (low < 0.0 ? 0.08 : 0.04) * range;
    const double top = high + above * range;
    script.add(name + "_LOW", bottom);
    script.add(name + "_HIGH", top);
    script.add(name + "_STEP", base::tic_step(top - bottom, 4.0));
  }
};

/// The motions of a definition on two axes, for translations and rotations.
void tell_motion(PlotScript& script, const results::PlotData& data,
                 const results::PlotDefinition& definition) {
  std::string columns;
  std::string names;
  std::string axes;
  std::string labels[2];
  AxisRange range[2];
  std::string first;
  for (const int position : definition.positions) {
    if (position < 0) continue;
    const results::PlotColumn& column = column_of(data, position);
    const bool angle = column.name.starts_with("CPR");
    if (first.empty()) first = angle ? "angle" : "position";
    const std::size_t axis = (angle ? "angle" : "position") == first ? 0 : 1;
    columns += fmt::format("{}{}", columns.empty() ? "" : " ", position + 1);
    names += (names.empty() ? "" : " ") + column.name;
    axes += fmt::format("{}{}", axes.empty() ? "" : " ", axis + 1);
    labels[axis] = axis_label(angle ? "angle" : "position", {"", column.unit});
    range[axis].include(data, position);
  }
  script.add("MOTIONS", columns.empty() ? "0" : columns);
  script.add("MOTION_NAMES", names);
  script.add("MOTION_AXES", axes.empty() ? "1" : axes);
  script.add("MOTION_LABEL", labels[0]);
  script.add("MOTION2_LABEL", labels[1]);
  range[0].tell(script, "MOTION");
  range[1].tell(script, "MOTION2");
}

/// The axis of the force's panel, which is too low for a long label.
void tell_force_axis(PlotScript& script, const results::PlotData& data,
                     const results::PlotDefinition& definition) {
  const int main = main_force(definition);
  const results::PlotColumn& column = column_of(data, main);
  const bool both_sides =
      definition.total >= 0 || data.lowest[static_cast<std::size_t>(main)] < 0.0;
  script.add("SHORT_LABEL",
             axis_label(is_moment(data, definition) ? "moment" : "force", {"", column.unit}));
  script.add("FORCE_STEP",
             base::tic_step((both_sides ? 2.3 : 1.2) * top_of(data, definition), 4.0));
}

void tell_state(PlotScript& script, const results::PlotData& data,
                const results::PlotDefinition& definition) {
  AxisRange normal;
  AxisRange mu;
  AxisRange energy;
  normal.include(data, definition.normal_force);
  mu.include(data, definition.mu);
  std::string unit;
  for (const int column : {definition.dissipation, definition.stored_energy, definition.work}) {
    energy.include(data, column);
    if (column >= 0) unit = column_of(data, column).unit;
  }
  mu.above = 0.4;  // a constant coefficient beside a constant normal force would cover it
  normal.tell(script, "NORMAL");
  mu.tell(script, "MU");
  energy.tell(script, "ENERGY");
  const int force = definition.normal_force;
  script.add("NORMAL", force + 1);
  script.add("NORMAL_LABEL",
             force < 0 ? ""
                       : axis_label(is_moment(data, definition) ? "normal moment" : "normal force",
                                    {"", column_of(data, force).unit}));
  script.add("MU", definition.mu + 1);
  script.add("DISSIPATION", definition.dissipation + 1);
  script.add("STORED", definition.stored_energy + 1);
  script.add("WORK", definition.work + 1);
  script.add("ENERGY_LABEL", axis_label("energy", {"", unit}));
}

}  // namespace

tl::expected<void, PlotFailure> draw_history(const PlotOptions& options,
                                             const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options, "history.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data = result_for_plot(options, picture, results::PlotDetail::kState);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  const std::size_t count = drawn_definitions(*data);
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_rows(script, *data);
  for (std::size_t i = 0; i < count; ++i) {
    const results::PlotDefinition& definition = data->definitions[i];
    tell_force(script, *data, definition);
    tell_force_axis(script, *data, definition);
    tell_motion(script, *data, definition);
    tell_state(script, *data, definition);
  }
  return draw(script, drawn_title(*data), 60 + 1000 * ((count + 1) / 2), *begun);
}

}  // namespace slipbench::driver::plot
