// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "driver/base/text/tics.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/loops.hpp"
#include "driver/plot/numbers.hpp"

namespace slipbench::driver::plot {
namespace {

/// The panel of force over motion, or those of the paths in a plane.
void tell_loop(PlotScript& script, const results::PlotData& data,
               const results::PlotDefinition& definition) {
  const auto translations = translations_of(data, definition);
  const bool planar = translations.size() >= 2;
  const double parts = planar ? 2.5 : 5.0;  // the panels of a planar motion are small
  script.add("PLANAR", planar ? 1 : 0);
  tell_limit_ellipse(script, data, definition, parts);
  const std::size_t shown = planar ? translations[0] : shown_component(data, definition);
  const int main = main_force(definition);
  const int loop = definition.components.empty() ? main : definition.components[shown];
  const bool same_unit = column_of(data, loop).unit == column_of(data, main).unit;
  script.add("LIMIT_IN_LOOP", definition.limit >= 0 && same_unit ? 1 : 0);
  const auto axis = [&](const std::string& letter, std::size_t k) {
    const int force = definition.components.empty() ? main : definition.components[k];
    const int position = definition.positions.empty() ? -1 : definition.positions[k];
    const auto p = static_cast<std::size_t>(position < 0 ? 0 : position);
    script.add("FORCE_" + letter, force + 1);
    script.add("FORCE_" + letter + "_LABEL", force_label(data, force));
    script.add("MOTION_" + letter, position + 1);
    script.add("MOTION_" + letter + "_LABEL", motion_label(data, position));
    script.add("MOTION_" + letter + "_FORMAT", tic_format(data.lowest[p], data.highest[p]));
    script.add("MOVES_" + letter, moves(data, position) ? 1 : 0);
    script.add("PLACE_" + letter, data.lowest[p]);
    script.add("STILL_" + letter, !moves(data, position) && !moves(data, force) ? 1 : 0);
    script.add("MOTION_" + letter + "_STEP", wide_tic_step(data.lowest[p], data.highest[p], parts));
  };
  axis("X", shown);
  axis("Y", planar ? translations[1] : shown);
}

}  // namespace

tl::expected<void, PlotFailure> draw_friction(const PlotOptions& options,
                                              const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options, "friction.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data =
      result_for_plot(options, picture, results::PlotDetail::kForces, WithLoops::kYes);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  const std::size_t count = drawn_definitions(*data);
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_rows(script, *data);
  tell_loops(script, *data);
  for (std::size_t i = 0; i < count; ++i) {
    tell_force(script, *data, data->definitions[i]);
    tell_loop(script, *data, data->definitions[i]);
  }
  return draw(script, drawn_title(*data), 60 + 440 * count, *begun);
}

}  // namespace slipbench::driver::plot
