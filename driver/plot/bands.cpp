// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/format_number.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/text_lines.hpp"

namespace slipbench::driver::plot {
namespace {

/// Marks nearer to each other than this part of the time would cover one another.
constexpr double kNearest = 0.006;
/// Bands of one picture, those of the first definitions: a belt may have as many rings.
constexpr int kMostBands = 100;

/// A part of the time, in percent.
std::string percent(double part, double duration) {
  return fmt::format("{:.3g} % of the time", duration > 0.0 ? 100.0 * part / duration : 0.0);
}

/// "slips 57.1 % of the time, 12 stick-slip events and 11 reversals, open 20 % of the time", as the
/// summary of `run` has it.
std::string facts(const results::PlotData& data, const results::RegimeHistory& regimes,
                  bool all_marked) {
  const double duration = data.highest[0] - data.lowest[0];
  std::string text = "never slips";
  if (regimes.slip_time > 0.0 || regimes.slip_begins > 0) {
    text = fmt::format("slips {}, {} stick-slip event{}", percent(regimes.slip_time, duration),
                       regimes.slip_begins, regimes.slip_begins == 1 ? "" : "s");
    if (const std::int64_t reversals = regimes.reversals.value_or(0); reversals > 0) {
      text += fmt::format(" and {} reversal{}", reversals, reversals == 1 ? "" : "s");
    }
  }
  if (results::lasts(regimes.open_time, duration))
    text += ", open " + percent(regimes.open_time, duration);
  if (!all_marked) text += "; not all are marked";
  return text;
}

}  // namespace

tl::expected<void, PlotFailure> draw_bands(const PlotOptions& options,
                                           const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options, "bands.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data = result_for_plot(options, picture, results::PlotDetail::kForces);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  std::string marks = "0 -1 0\n";  // of no regime: an empty block cannot be plotted
  const double nearest = kNearest * (data->highest[0] - data->lowest[0]);
  int count = 0;
  int all = 0;
  bool opens = false;
  bool in_turn = false;
  bool turns_back = false;
  std::string rows = "0 -1 0 0\n";
  for (const results::PlotDefinition& definition : data->definitions) {
    if (definition.status < 0 || ++all > kMostBands) continue;
    ++count;
    const results::RegimeHistory& regimes = definition.regimes;
    // Of those to slip, which stand above the band, and of the others below.
    std::array<std::optional<double>, 2> last;
    bool all_marked = regimes.all_marked;
    for (const results::RegimeMark& mark : regimes.marks) {
      const bool in_turns = std::any_of(
          regimes.spans.begin(), regimes.spans.end(), [&](const results::RegimeSpan& span) {
            return span.merged && span.from <= mark.time && mark.time <= span.to;
          });
      auto& before = last[mark.to == 2 ? 0 : 1];
      if (in_turns || (before && mark.time - *before < nearest)) {
        all_marked = false;
        continue;
      }
      before = mark.time;
      turns_back = turns_back || mark.turns;
      marks += fmt::format("{} {} {}\n", count, mark.turns ? 3 : mark.to,
                           base::format_number(mark.time));
    }
    for (const results::RegimeSpan& span : regimes.spans) {
      if (span.merged) in_turn = true;
      if (span.status == 0) opens = true;
      rows += fmt::format("{} {} {} {}\n", count, drawn_status(span),
                          base::format_number(span.from), base::format_number(span.to));
    }
    script.add("NAME", one_line(definition.several ? definition.name
                                                   : column_of(*data, main_force(definition)).name,
                                kNameLength));
    script.add("FACTS", facts(*data, regimes, all_marked));
  }
  if (count == 0) {
    return failed(base::kExitBadInput,
                  options.input + ": has no column STATUS, so it does not say when it slips");
  }
  script.set("DEFINITIONS", count);
  script.set("OPENS", opens ? 1 : 0);
  script.set("TURNS", in_turn ? 1 : 0);
  script.set("TURNS_BACK", turns_back ? 1 : 0);
  tell_time(script, data->columns[0].unit, data->lowest[0], data->highest[0]);
  script.block("SPANS", std::move(rows));
  script.block("MARKS", std::move(marks));
  std::string title = data->title;
  if (all > count) title += fmt::format(" (the first {} of {} definitions)", count, all);
  return draw(script, title, 170 + 90 * static_cast<std::size_t>(count), *begun);
}

}  // namespace slipbench::driver::plot
