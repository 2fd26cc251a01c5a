// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "driver/base/text/tics.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/loops.hpp"
#include "driver/plot/numbers.hpp"

namespace slipbench::driver::plot {
namespace {

constexpr std::size_t kMostLoops = 3;

/// Returns what a column gains from the first row to the last.
double gain(const results::PlotData& data, int column) {
  const auto k = static_cast<std::size_t>(column);
  return data.rows[data.rows.size() - data.columns.size() + k] - data.rows[k];
}

/// "dissipated 27.4 J, 7.76 J in the last full cycle".
std::string energy_text(const results::PlotData& data, const results::PlotDefinition& definition) {
  const int dissipation = definition.dissipation;
  if (dissipation < 0) return {};
  const std::string& unit = column_of(data, dissipation).unit;
  const auto with = [&](double value) {
    return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
  };
  std::string text = "dissipated " + with(gain(data, dissipation));
  if (definition.energy) text += ", " + with(*definition.energy) + " in the last full cycle";
  return text;
}

/// The panels of one definition: the paths of motion and force in a plane, else a loop for each
/// component that moves.
class Panels {
 public:
  Panels(PlotScript& script, const results::PlotData& data,
         const results::PlotDefinition& definition)
      : script_(script), data_(data), definition_(definition) {}

  void tell() {
    tell_force(script_, data_, definition_);
    tell_limit_ellipse(script_, data_, definition_, 4.0);
    const auto translations = translations_of(data_, definition_);
    std::vector<std::size_t> shown;
    if (translations.size() >= 2) {
      shown = {translations[0], translations[1]};
    } else {
      for (std::size_t k = 0; k < definition_.components.size(); ++k) {
        if (moves(data_, definition_.positions[k])) shown.push_back(k);
      }
      if (shown.empty() && !definition_.components.empty()) shown.push_back(0);
      if (shown.size() > kMostLoops) shown.resize(kMostLoops);
    }
    const bool planar = translations.size() >= 2;
    script_.add("PLANAR", planar ? 1 : 0);
    script_.add("PANELS", static_cast<int>(shown.size()));
    script_.add("ENERGY", energy_text(data_, definition_));
    const double parts = shown.size() > 2 ? 3.0 : 5.0;
    for (std::size_t p = 0; p < kMostLoops; ++p)
      tell_loop(p < shown.size() ? shown[p] : 0, p, parts);
  }

 private:
  void tell_loop(std::size_t k, std::size_t panel, double parts) {
    const std::string number = std::to_string(panel + 1);
    const int main = main_force(definition_);
    const bool none = definition_.components.empty();
    const int force = none ? main : definition_.components[k];
    const int position = none ? -1 : definition_.positions[k];
    const auto p = static_cast<std::size_t>(position < 0 ? 0 : position);
    const bool same_unit = column_of(data_, force).unit == column_of(data_, main).unit;
    const double limit = same_unit ? magnitude_of(data_, definition_.limit) : 0.0;
    const auto f = static_cast<std::size_t>(force);
    const double low = std::min({0.0, data_.lowest[f], -limit});
    const double high = std::max({0.0, data_.highest[f], limit});
    const double tall = high > low ? high - low : 1.0;
    const double wide = position >= 0 && data_.highest[p] > data_.lowest[p]
                            ? data_.highest[p] - data_.lowest[p]
                            : 1.0;
    script_.add("FORCE_" + number, force + 1);
    script_.add("FORCE_" + number + "_LABEL", force_label(data_, force));
    script_.add("FORCE_" + number + "_LOW", low - 0.06 * tall);
    script_.add("FORCE_" + number + "_HIGH", high + 0.06 * tall);
    script_.add("FORCE_" + number + "_LIMIT", definition_.limit >= 0 && same_unit ? 1 : 0);
    const bool still = !moves(data_, position) && !moves(data_, force);
    script_.add("STILL_" + number, still ? 1 : 0);
    script_.add("MOTION_" + number, position + 1);
    script_.add("MOTION_" + number + "_FORMAT", tic_format(data_.lowest[p], data_.highest[p]));
    script_.add("MOTION_" + number + "_LABEL", motion_label(data_, position));
    script_.add("MOTION_" + number + "_FROM", data_.lowest[p] - 0.04 * wide);
    script_.add("MOTION_" + number + "_TO", data_.highest[p] + 0.04 * wide);
    script_.add("MOTION_" + number + "_STEP",
                wide_tic_step(data_.lowest[p], data_.highest[p], parts));
  }

  PlotScript& script_;
  const results::PlotData& data_;
  const results::PlotDefinition& definition_;
};

}  // namespace

tl::expected<void, PlotFailure> draw_hysteresis(const PlotOptions& options,
                                                const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options, "hysteresis.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data = result_for_plot(options, picture, results::PlotDetail::kState, WithLoops::kYes);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  const std::size_t count = drawn_definitions(*data);
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_rows(script, *data);
  tell_loops(script, *data);
  for (std::size_t i = 0; i < count; ++i) Panels(script, *data, data->definitions[i]).tell();
  return draw(script, drawn_title(*data), 60 + 460 * count, *begun);
}

}  // namespace slipbench::driver::plot
