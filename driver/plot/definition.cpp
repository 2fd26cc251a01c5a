// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "driver/base/text/format_number.hpp"
#include "driver/base/text/tics.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/text_lines.hpp"

namespace slipbench::driver::plot {
namespace {

/// Half the axes of the largest limit: of two coefficients an ellipse, of one a circle.
std::array<double, 2> limit_axes(const results::PlotData& data,
                                 const results::PlotDefinition& definition) {
  const double limit = magnitude_of(data, definition.limit);
  const bool two = definition.normal_force >= 0 && definition.coefficients[0] >= 0 &&
                   definition.coefficients[1] >= 0;
  if (!two) return {limit, limit};
  const double normal = magnitude_of(data, definition.normal_force);
  return {magnitude_of(data, definition.coefficients[0]) * normal,
          magnitude_of(data, definition.coefficients[1]) * normal};
}

}  // namespace

std::string rows_text(const results::PlotData& data, const std::vector<double>& rows) {
  const std::size_t columns = data.columns.size();
  std::vector<int> digits;
  for (std::size_t k = 0; k < columns; ++k) {
    digits.push_back(drawn_digits(data.lowest[k], data.highest[k]));
  }
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t k = i % columns;
    if (std::isnan(rows[i])) {
      text += "NaN";
    } else {
      text += fmt::format("{:.{}g}", rows[i], digits[k]);
    }
    text += k + 1 < columns ? ' ' : '\n';
  }
  return text;
}

std::size_t drawn_definitions(const results::PlotData& data) {
  return std::min(kMostDefinitions, data.definitions.size());
}

std::string drawn_title(const results::PlotData& data) {
  const std::size_t count = drawn_definitions(data);
  if (count == data.definitions.size()) return data.title;
  return fmt::format("{} (the first {} of {} definitions)", data.title, count,
                     data.definitions.size());
}

const results::PlotColumn& column_of(const results::PlotData& data, int number) {
  return data.columns[static_cast<std::size_t>(number)];
}

double magnitude_of(const results::PlotData& data, int number) {
  if (number < 0) return 0.0;
  const auto k = static_cast<std::size_t>(number);
  return std::max(std::abs(data.lowest[k]), std::abs(data.highest[k]));
}

bool moves(const results::PlotData& data, int number) {
  if (number < 0) return false;
  const auto k = static_cast<std::size_t>(number);
  return data.highest[k] > data.lowest[k];
}

std::string axis_label(std::string_view what, const results::PlotColumn& column) {
  std::string text(what);
  if (!column.name.empty()) text += " " + column.name;
  if (!column.unit.empty()) text += " [" + column.unit + "]";
  return text;
}

bool is_moment(const results::PlotData& data, const results::PlotDefinition& definition) {
  return !definition.components.empty() &&
         std::all_of(definition.components.begin(), definition.components.end(),
                     [&](int force) { return column_of(data, force).name.starts_with("CSM"); });
}

std::string force_label(const results::PlotData& data, int force) {
  const results::PlotColumn& column = column_of(data, force);
  return axis_label(column.name.starts_with("CSM") ? "friction moment" : "friction force", column);
}

std::string motion_label(const results::PlotData& data, int position) {
  if (position < 0) return {};
  const results::PlotColumn& column = column_of(data, position);
  return axis_label(column.name.starts_with("CPR") ? "angle" : "position", column);
}

int main_force(const results::PlotDefinition& definition) {
  return definition.total >= 0 ? definition.total : definition.components.front();
}

std::vector<std::size_t> translations_of(const results::PlotData& data,
                                         const results::PlotDefinition& definition) {
  std::vector<std::size_t> entries;
  for (std::size_t k = 0; k < definition.components.size(); ++k) {
    const bool force = column_of(data, definition.components[k]).name.starts_with("CSF");
    if (force && definition.positions[k] >= 0) entries.push_back(k);
  }
  return entries;
}

std::size_t shown_component(const results::PlotData& data,
                            const results::PlotDefinition& definition) {
  for (std::size_t k = 0; k < definition.components.size(); ++k) {
    if (moves(data, definition.positions[k])) return k;
  }
  return 0;
}

double top_of(const results::PlotData& data, const results::PlotDefinition& definition) {
  const auto axes = limit_axes(data, definition);
  const double top = std::max({magnitude_of(data, definition.limit),
                               magnitude_of(data, main_force(definition)), axes[0], axes[1]});
  return top > 0.0 && std::isfinite(top) ? top : 1.0;
}

void tell_time(PlotScript& script, const std::string& unit, double begin, double end) {
  script.set("TIME_LABEL", axis_label("time", {"t", unit}));
  script.set("TIME_FORMAT", tic_format(begin, end));
  script.set("TIME_STEP", wide_tic_step(begin, end, 6.0));
  script.set("BEGIN", begin);
  script.set("END_TIME", end > begin ? end : begin + 1.0);
}

int drawn_status(const results::RegimeSpan& span) {
  if (!span.merged) return span.status;
  return span.status == 2 ? 3 : 4;
}

void tell_rows(PlotScript& script, const results::PlotData& data) {
  tell_time(script, data.columns[0].unit, data.lowest[0], data.highest[0]);
  // The first span is of no length and no definition: an empty block cannot be plotted.
  std::string spans = "0 0 0 0\n";
  for (std::size_t i = 0; i < drawn_definitions(data); ++i) {
    for (const results::RegimeSpan& span : data.definitions[i].regimes.spans) {
      spans += fmt::format("{} {} {} {}\n", i + 1, drawn_status(span),
                           base::format_number(span.from), base::format_number(span.to));
    }
  }
  script.block("SPANS", std::move(spans));
  script.block("DATA", rows_text(data, data.rows));
}

void tell_force(PlotScript& script, const results::PlotData& data,
                const results::PlotDefinition& definition) {
  const int main = main_force(definition);
  const bool total = definition.total >= 0;
  const std::string& unit = column_of(data, main).unit;
  std::string beside;
  std::string beside_names;
  for (const int force : definition.components) {
    if (!total || column_of(data, force).unit != unit) continue;
    beside += fmt::format("{}{}", beside.empty() ? "" : " ", force + 1);
    beside_names += (beside_names.empty() ? "" : " ") + column_of(data, force).name;
  }
  script.add("NAME", definition.several ? one_line(definition.name, kNameLength) : "");
  script.add("FORCE", main + 1);
  script.add("FORCE_NAME", (total ? "total " : "") + column_of(data, main).name);
  script.add("FORCE_LABEL",
             total ? axis_label(is_moment(data, definition) ? "friction moment" : "friction force",
                                {"", unit})
                   : force_label(data, main));
  const bool negative = data.lowest[static_cast<std::size_t>(main)] < 0.0;
  script.add("SIGNED", negative || !beside.empty() ? 1 : 0);
  // A loop over no columns is an error in gnuplot; the force itself, twice, is not.
  script.add("BESIDE", beside.empty() ? std::to_string(main + 1) : beside);
  script.add("BESIDE_NAMES", beside_names);
  script.add("LIMIT", definition.limit + 1);
  script.add("LIMIT_BELOW", definition.limit_below + 1);
  script.add("TOP", top_of(data, definition));
  bool slips = false;
  bool opens = false;
  bool turns = false;
  for (const results::RegimeSpan& span : definition.regimes.spans) {
    (span.merged ? turns : span.status == 2 ? slips : opens) = true;
  }
  script.add("SLIPS", slips ? 1 : 0);
  script.add("OPENS", opens ? 1 : 0);
  script.add("TURNS", turns ? 1 : 0);
}

void tell_limit_ellipse(PlotScript& script, const results::PlotData& data,
                        const results::PlotDefinition& definition, double parts) {
  const auto axes = limit_axes(data, definition);
  script.add("LIMIT_AXIS_1", axes[0]);
  script.add("LIMIT_AXIS_2", axes[1]);
  script.add("DIRECTION_X", definition.direction[0]);
  script.add("DIRECTION_Y", definition.direction[1]);
  script.add("FORCE_STEP", base::tic_step(2.0 * top_of(data, definition), parts));
}

}  // namespace slipbench::driver::plot
