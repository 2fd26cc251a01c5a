// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "driver/base/text/tics.hpp"
#include "driver/plot/amplitudes.hpp"
#include "driver/plot/chosen_columns.hpp"
#include "driver/plot/definition.hpp"
#include "driver/plot/input.hpp"
#include "driver/plot/kinds.hpp"
#include "driver/plot/numbers.hpp"
#include "driver/plot/path_rows.hpp"

namespace slipbench::driver::plot {
namespace {

/// The axis goes on to so many times the peak's frequency: harmonics beyond it are too low to see.
constexpr double kHarmonics = 12.0;

/// The unit of a frequency; nothing if that of the time is not stated.
std::string frequency_unit(const std::string& time) {
  if (time.empty()) return {};
  return time == "s" ? "Hz" : "1/" + time;
}

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

/// Returns what is drawn of the amplitudes, as gnuplot reads it.
std::string points_of(const Amplitudes& found, double end) {
  PathRows path({{0, end}, {1, found.peak}}, found.values.size());
  for (std::size_t k = 0; k < found.values.size(); ++k) {
    const double frequency = static_cast<double>(k) * found.step;
    if (frequency > end) break;
    path.add(std::array{frequency, found.values[k]});
  }
  std::string points;
  const std::vector<double> rows = path.finish();
  for (std::size_t at = 0; at + 1 < rows.size(); at += 2) {
    points += fmt::format("{:.9g} {:.6g}\n", rows[at], rows[at + 1]);
  }
  return points;
}

}  // namespace

tl::expected<void, PlotFailure> draw_spectrum(const PlotOptions& options,
                                              const std::filesystem::path& picture) {
  auto begun = begin_picture(picture, options, "spectrum.gp");
  if (!begun) return tl::unexpected(std::move(begun.error()));
  if (options.y.size() > 1)
    return failed(base::kExitBadInput, "--as spectrum draws one column; one --y");
  const auto rows = rows_for_plot(options, picture);
  if (!rows) return tl::unexpected(rows.error());
  const auto layout = layout_for_plot(*rows);
  if (!layout) return tl::unexpected(layout.error());
  const auto usual = usual_columns(*rows, *layout);
  if (!usual) return tl::unexpected(usual.error());
  const std::string name = options.y.empty() ? usual->force : options.y.front();
  if (name.empty()) {
    return failed(base::kExitBadInput,
                  options.input + ": has no friction force; name a column with --y");
  }
  const auto column = chosen_column(*rows, *layout, name);
  if (!column) return tl::unexpected(column.error());
  if (name == "t") return failed(base::kExitBadInput, "the time has no spectrum over time");
  std::vector<double> times;
  std::vector<double> signal;
  const auto read = results::each_row(rows->file, rows->shown_name, {"t", name},
                                      [&](std::span<const double> row, std::int64_t) {
                                        times.push_back(row[0]);
                                        signal.push_back(row[1]);
                                      });
  if (!read) return unreadable(rows->shown_name, read.error());
  const Amplitudes found = amplitudes_of(times, signal);
  if (!(found.peak > 0.0)) {
    return failed(
        base::kExitBadInput,
        fmt::format("{}: {} does not vibrate: its spectrum has no peak", options.input, name));
  }
  const auto time = layout->column_units.find("t");
  const std::string unit = frequency_unit(time == layout->column_units.end() ? "" : time->second);
  const double highest = static_cast<double>(found.values.size() - 1) * found.step;
  const double end = std::min(highest, kHarmonics * found.peak_frequency);
  PlotScript script;
  script.set("END", end);
  const auto drawn = static_cast<std::ptrdiff_t>(end / found.step) + 1;
  script.set("TOP", 1.12 * *std::max_element(found.values.begin(), found.values.begin() + drawn));
  script.set("X_STEP", wide_tic_step(0.0, end, 8.0));
  script.set("X_LABEL", axis_label("frequency", {"", unit}));
  script.set("Y_LABEL", "amplitude of " + column_label(*column));
  script.set("PEAK_AT", found.peak_frequency);
  script.set("PEAK", found.peak);
  script.set("PEAK_NAME", fmt::format("{} at {}", with_unit(found.peak, column->unit),
                                      with_unit(found.peak_frequency, unit)));
  script.block("POINTS", points_of(found, end));
  const std::string title = rows->problem ? picture_title(*rows->problem)
                            : layout->title.empty()
                                ? std::filesystem::path(options.input).stem().string()
                                : layout->title;
  return draw(script, title, 560, *begun);
}

}  // namespace slipbench::driver::plot
