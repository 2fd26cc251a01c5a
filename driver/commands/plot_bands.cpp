// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/commands/plot_definition.hpp"
#include "driver/commands/plot_input.hpp"
#include "driver/commands/plot_kinds.hpp"
#include "driver/text/format_number.hpp"

namespace slipbench::driver {
namespace {

/// Marks nearer to each other than this part of the time would cover one another.
constexpr double kNearest = 0.006;

struct Change {
  double time = 0.0;
  int to = 1;  ///< 0 open, 1 stick, 2 slip
};

/// Where the regime changes, from its spans; not where the run begins or ends.
std::vector<Change> changes_of(const PlotData& data, const PlotDefinition& definition) {
  const auto& spans = definition.spans;
  std::vector<Change> changes;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (spans[i].from > data.lowest[0]) changes.push_back({spans[i].from, spans[i].status});
    const bool goes_on = std::any_of(spans.begin(), spans.end(), [&](const RegimeSpan& other) {
      return other.from == spans[i].to && &other != &spans[i];
    });
    if (!goes_on && spans[i].to < data.highest[0]) changes.push_back({spans[i].to, 1});
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.time < b.time; });
  return changes;
}

/// "slip 57 %, open 20 %, 12 changes".
std::string facts(const PlotData& data, const PlotDefinition& definition, bool all_marked) {
  const double duration = data.highest[0] - data.lowest[0];
  double slip = 0.0;
  double open = 0.0;
  for (const RegimeSpan& span : definition.spans) {
    (span.status == 2 ? slip : open) += span.to - span.from;
  }
  const double percent = duration > 0.0 ? 100.0 / duration : 0.0;
  std::string text = fmt::format("slip {:.3g} % of the time", percent * slip);
  if (open > 0.0) text += fmt::format(", no contact {:.3g} %", percent * open);
  text += fmt::format(", {} change{}", definition.changes, definition.changes == 1 ? "" : "s");
  if (!all_marked) text += ", not all are marked";
  return text;
}

}  // namespace

tl::expected<void, PlotFailure> draw_bands(const PlotOptions& options,
                                           const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options.input, "bands.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  const auto data = result_for_plot(options, picture, PlotDetail::kForces);
  if (!data) return tl::unexpected(data.error());
  PlotScript script;
  std::string marks = "0 0 0\n";  // of no definition: an empty block cannot be plotted
  const double nearest = kNearest * (data->highest[0] - data->lowest[0]);
  int count = 0;
  bool opens = false;
  std::string rows = "0 0 0 0\n";
  for (const PlotDefinition& definition : data->definitions) {
    if (definition.status < 0) continue;
    ++count;
    // Of those to slip, which stand above the band, and of the others below.
    std::array<std::optional<double>, 2> last;
    std::int64_t marked = 0;
    for (const Change& change : changes_of(*data, definition)) {
      auto& before = last[change.to == 2 ? 0 : 1];
      if (before && change.time - *before < nearest) continue;
      before = change.time;
      ++marked;
      marks += fmt::format("{} {} {}\n", count, change.to, format_number(change.time));
    }
    for (const RegimeSpan& span : definition.spans) {
      opens = opens || span.status == 0;
      rows += fmt::format("{} {} {} {}\n", count, span.status, format_number(span.from),
                          format_number(span.to));
    }
    script.add("NAME", definition.several ? definition.name
                                          : column_of(*data, main_force(definition)).name);
    script.add("FACTS", facts(*data, definition, marked == definition.changes));
  }
  if (count == 0) {
    return failed(kExitBadInput,
                  options.input + ": has no column STATUS, so it does not say when it slips");
  }
  script.set("DEFINITIONS", count);
  script.set("OPENS", opens ? 1 : 0);
  script.set("TIME_LABEL", axis_label("time", {"t", data->columns[0].unit}));
  script.set("BEGIN", data->lowest[0]);
  script.set("END_TIME",
             data->highest[0] > data->lowest[0] ? data->highest[0] : data->lowest[0] + 1.0);
  script.block("SPANS", std::move(rows));
  script.block("MARKS", std::move(marks));
  return draw(script, data->title, 150 + 90 * static_cast<std::size_t>(count), *begun);
}

}  // namespace slipbench::driver
