// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/commands/plot_definition.hpp"
#include "driver/commands/plot_input.hpp"
#include "driver/commands/plot_kinds.hpp"
#include "driver/compare/branches.hpp"
#include "driver/text/format_number.hpp"
#include "driver/text/tics.hpp"

namespace slipbench::driver {
namespace {

constexpr std::size_t kMostLoops = 3;
/// Turning points that differ by less, as a part of the motion's range, are one place.
constexpr double kSamePlace = 1e-3;
/// A cycle smaller than this part of the motion's range is what is left of a vibration.
constexpr double kSmallestCycle = 0.02;

std::vector<double> numbers_of(const PlotData& data, int column) {
  std::vector<double> numbers;
  const std::size_t columns = data.columns.size();
  for (std::size_t r = 0; r < data.row_count(); ++r) {
    numbers.push_back(data.rows[r * columns + static_cast<std::size_t>(column)]);
  }
  return numbers;
}

/// The rows from one turning point of a motion to the next but one, which is the same place: the
/// last cycle that is complete.
std::optional<std::pair<std::size_t, std::size_t>> last_cycle(const std::vector<double>& motion) {
  const auto pieces = branches(motion);
  if (pieces.size() < 3) return std::nullopt;
  std::vector<std::size_t> turns;
  for (const Branch& branch : pieces) turns.push_back(branch.last);
  const auto [low, high] = std::minmax_element(motion.begin(), motion.end());
  for (std::size_t i = turns.size(); i-- > 2;) {
    const double width = std::abs(motion[turns[i]] - motion[turns[i - 1]]);
    if (width < kSmallestCycle * (*high - *low)) continue;
    if (std::abs(motion[turns[i]] - motion[turns[i - 2]]) <= kSamePlace * (*high - *low)) {
      return std::pair{turns[i - 2], turns[i]};
    }
  }
  return std::nullopt;
}

/// "dissipated 27.4 J, 7.76 J in the last full cycle".
std::string energy_text(const PlotData& data, int dissipation,
                        const std::optional<std::pair<std::size_t, std::size_t>>& cycle) {
  if (dissipation < 0) return {};
  const std::vector<double> energy = numbers_of(data, dissipation);
  const std::string& unit = column_of(data, dissipation).unit;
  const auto with = [&](double value) {
    return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
  };
  std::string text = "dissipated " + with(energy.back() - energy.front());
  if (cycle)
    text += ", " + with(energy[cycle->second] - energy[cycle->first]) + " in the last full cycle";
  return text;
}

/// The panels of one definition: the paths of motion and force in a plane, else a loop for each
/// component that moves.
class Panels {
 public:
  Panels(PlotScript& script, const PlotData& data, const PlotDefinition& definition)
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
    script_.add("LOOPS", static_cast<int>(shown.size()));
    std::optional<std::pair<std::size_t, std::size_t>> cycle;
    for (const std::size_t k : shown) {
      const int position = definition_.positions[k];
      if (!cycle && position >= 0) cycle = last_cycle(numbers_of(data_, position));
    }
    script_.add("CYCLE_FROM", cycle ? static_cast<int>(cycle->first) : -1);
    script_.add("CYCLE_TO", cycle ? static_cast<int>(cycle->second) : -1);
    script_.add("ENERGY", energy_text(data_, definition_.dissipation, cycle));
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
    script_.add("MOTION_" + number, position + 1);
    script_.add("MOTION_" + number + "_LABEL", motion_label(data_, position));
    script_.add("MOTION_" + number + "_FROM", data_.lowest[p] - 0.04 * wide);
    script_.add("MOTION_" + number + "_TO", data_.highest[p] + 0.04 * wide);
    script_.add("MOTION_" + number + "_STEP", tic_step(data_.highest[p] - data_.lowest[p], parts));
  }

  PlotScript& script_;
  const PlotData& data_;
  const PlotDefinition& definition_;
};

}  // namespace

tl::expected<void, PlotFailure> draw_hysteresis(const PlotOptions& options,
                                                const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options.input, "hysteresis.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data = result_for_plot(options, picture, PlotDetail::kState);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  const std::size_t count = drawn_definitions(*data);
  script.set("DEFINITIONS", static_cast<int>(count));
  tell_rows(script, *data);
  for (std::size_t i = 0; i < count; ++i) Panels(script, *data, data->definitions[i]).tell();
  return draw(script, drawn_title(*data), 60 + 460 * count, *begun);
}

}  // namespace slipbench::driver
