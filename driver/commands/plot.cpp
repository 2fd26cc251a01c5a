// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "driver/commands/gnuplot.hpp"
#include "driver/commands/plot_law.hpp"
#include "driver/commands/shared.hpp"
#include "driver/results/csv_writer.hpp"
#include "driver/results/plot_data.hpp"
#include "driver/results/provenance.hpp"
#include "driver/text/format_number.hpp"
#include "driver/text/tics.hpp"

namespace slipbench::driver {
namespace {

namespace fs = std::filesystem;

std::string label(const char* what, const PlotColumn& column) {
  std::string text = what;
  if (!column.name.empty()) text += " " + column.name;
  if (!column.unit.empty()) text += " [" + column.unit + "]";
  return text;
}

const char* force_word(std::string_view name) {
  return name.starts_with("CSM") ? "friction moment" : "friction force";
}

std::string number_list(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

const PlotColumn& column(const PlotData& data, int number) {
  return data.columns[static_cast<std::size_t>(number)];
}

/// The largest magnitude a column has.
double magnitude(const PlotData& data, int number) {
  const auto k = static_cast<std::size_t>(number);
  return std::max(std::abs(data.lowest[k]), std::abs(data.highest[k]));
}

/// What the template is told about one definition: variables named after its number `i`.
std::string definition_variables(const PlotData& data, const PlotDefinition& definition,
                                 std::size_t i) {
  std::string text;
  const auto set = [&](const char* name, const std::string& value) {
    text += fmt::format("{}[{}] = {}\n", name, i, value);
  };
  // Columns count from 1 in gnuplot; 0 is none.
  const int main = definition.total >= 0 ? definition.total : definition.components.front();
  const std::string unit = column(data, main).unit;
  std::vector<int> beside;
  std::string beside_names;
  std::vector<int> translations;
  for (std::size_t k = 0; k < definition.components.size(); ++k) {
    const int force = definition.components[k];
    if (definition.total >= 0 && column(data, force).unit == unit) {
      beside.push_back(force + 1);
      beside_names += (beside_names.empty() ? "" : " ") + column(data, force).name;
    }
    if (column(data, force).name.starts_with("CSF") && definition.positions[k] >= 0) {
      translations.push_back(static_cast<int>(k));
    }
  }
  set("NAME", gnuplot_string(definition.several ? definition.name : ""));
  set("FORCE", std::to_string(main + 1));
  set("FORCE_NAME",
      gnuplot_string((definition.total >= 0 ? "total " : "") + column(data, main).name));
  set("FORCE_LABEL",
      gnuplot_string(label(force_word(column(data, main).name),
                           {definition.total >= 0 ? "" : column(data, main).name, unit})));
  set("SIGNED", data.lowest[static_cast<std::size_t>(main)] < 0.0 || !beside.empty() ? "1" : "0");
  // A loop over no columns is an error in gnuplot; the force itself, twice, is not.
  if (beside.empty()) beside.push_back(main + 1);
  set("BESIDE", gnuplot_string(number_list(beside)));
  set("BESIDE_NAMES", gnuplot_string(beside_names));
  set("LIMIT", std::to_string(definition.limit + 1));
  set("LIMIT_BELOW", std::to_string(definition.limit_below + 1));
  const double limit = definition.limit >= 0 ? magnitude(data, definition.limit) : 0.0;
  double top = std::max(limit, magnitude(data, main));
  // The ellipse of two coefficients, or the circle of one.
  std::array<double, 2> axes{limit, limit};
  const bool two = definition.normal_force >= 0 && definition.coefficients[0] >= 0 &&
                   definition.coefficients[1] >= 0;
  for (std::size_t k = 0; k < 2 && two; ++k) {
    axes[k] =
        magnitude(data, definition.coefficients[k]) * magnitude(data, definition.normal_force);
    top = std::max(top, axes[k]);
  }
  if (!(top > 0.0)) top = 1.0;
  set("TOP", format_number(top));
  set("LIMIT_AXIS_1", format_number(axes[0]));
  set("LIMIT_AXIS_2", format_number(axes[1]));
  set("DIRECTION_X", format_number(definition.direction[0]));
  set("DIRECTION_Y", format_number(definition.direction[1]));

  const bool planar = translations.size() >= 2;
  set("PLANAR", planar ? "1" : "0");
  const double parts = planar ? 2.5 : 5.0;  // the panels of a planar motion are small
  set("FORCE_STEP", format_number(tic_step(2.0 * top, parts)));
  const auto first = static_cast<std::size_t>(planar ? translations[0] : 0);
  std::size_t shown = first;
  if (!planar) {
    // The loop of a component that moves says more than that of one that rests.
    for (std::size_t k = definition.components.size(); k-- > 0;) {
      const int position = definition.positions[k];
      if (position < 0) continue;
      const auto p = static_cast<std::size_t>(position);
      if (data.highest[p] > data.lowest[p]) shown = k;
    }
  }
  const int loop_force = definition.components.empty() ? main : definition.components[shown];
  set("LIMIT_IN_LOOP", definition.limit >= 0 && column(data, loop_force).unit == unit ? "1" : "0");
  const auto axis = [&](const char* force_name, const char* motion_name_, std::size_t k) {
    const int force = definition.components.empty() ? main : definition.components[k];
    const int position = definition.positions.empty() ? -1 : definition.positions[k];
    set(force_name, std::to_string(force + 1));
    set((std::string(force_name) + "_LABEL").c_str(),
        gnuplot_string(label(force_word(column(data, force).name), column(data, force))));
    set(motion_name_, std::to_string(position + 1));
    set((std::string(motion_name_) + "_LABEL").c_str(),
        gnuplot_string(
            position >= 0
                ? label(column(data, position).name.starts_with("CPR") ? "angle" : "position",
                        column(data, position))
                : ""));
    const auto p = static_cast<std::size_t>(std::max(position, 0));
    set((std::string(motion_name_) + "_STEP").c_str(),
        format_number(tic_step(data.highest[p] - data.lowest[p], parts)));
  };
  axis("FORCE_X", "MOTION_X", shown);
  axis("FORCE_Y", "MOTION_Y", planar ? static_cast<std::size_t>(translations[1]) : shown);

  bool slips = false;
  bool opens = false;
  for (const RegimeSpan& span : definition.spans) (span.status == 2 ? slips : opens) = true;
  set("SLIPS", slips ? "1" : "0");
  set("OPENS", opens ? "1" : "0");
  return text;
}

/// The whole script: what is drawn as variables and data, then the template.
std::string script(const PlotData& data, const std::string& title, const fs::path& picture,
                   const fs::path& output, const fs::path& pattern) {
  constexpr std::size_t kMostDefinitions = 4;
  const std::size_t count = std::min(kMostDefinitions, data.definitions.size());
  std::string text = fmt::format("TERMINAL = {}\nPICTURE = {}\nTITLE = {}\nDEFINITIONS = {}\n",
                                 "\"" + terminal_for(picture, 60 + 440 * count) + "\"",
                                 gnuplot_string(output.string()), gnuplot_string(title), count);
  text += "TIME_LABEL = " + gnuplot_string(label("time", {"t", data.columns[0].unit})) + "\n";
  text += "BEGIN = " + format_number(data.lowest[0]) + "\n";
  text += "END_TIME = " +
          format_number(data.highest[0] > data.lowest[0] ? data.highest[0] : data.lowest[0] + 1.0) +
          "\n";
  for (const char* name : {"NAME",          "FORCE",         "FORCE_NAME",    "FORCE_LABEL",
                           "SIGNED",        "BESIDE",        "BESIDE_NAMES",  "LIMIT",
                           "TOP",           "LIMIT_AXIS_1",  "LIMIT_AXIS_2",  "DIRECTION_X",
                           "DIRECTION_Y",   "LIMIT_BELOW",   "LIMIT_IN_LOOP", "PLANAR",
                           "FORCE_X",       "FORCE_X_LABEL", "MOTION_X",      "MOTION_X_LABEL",
                           "FORCE_Y",       "FORCE_Y_LABEL", "MOTION_Y",      "MOTION_Y_LABEL",
                           "MOTION_X_STEP", "MOTION_Y_STEP", "FORCE_STEP",    "SLIPS",
                           "OPENS"}) {
    text += fmt::format("array {}[{}]\n", name, count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    text += definition_variables(data, data.definitions[i], i + 1);
  }
  // The first span is of no length and no definition: an empty block cannot be plotted.
  text += "$SPANS << END\n0 0 0 0\n";
  for (std::size_t i = 0; i < count; ++i) {
    for (const RegimeSpan& span : data.definitions[i].spans) {
      text += fmt::format("{} {} {} {}\n", i + 1, span.status, format_number(span.from),
                          format_number(span.to));
    }
  }
  text += "END\n$DATA << END\n";
  const std::size_t columns = data.columns.size();
  for (std::size_t r = 0; r < data.row_count(); ++r) {
    for (std::size_t k = 0; k < columns; ++k) {
      // Six digits are finer than any screen or page.
      text += fmt::format("{:.6g}{}", data.rows[r * columns + k], k + 1 < columns ? ' ' : '\n');
    }
  }
  text += "END\nload " + gnuplot_string(pattern.string()) + "\n";
  return text;
}

/// Runs a case and writes its rows to `rows`; the title of the picture.
tl::expected<std::string, PlotFailure> run_for_plot(const PlotOptions& options,
                                                    const fs::path& picture,
                                                    std::optional<OutputFile>& rows) {
  const auto read = read_for_plot(options);
  if (!read) return tl::unexpected(read.error());
  const Case& problem = *read;
  auto created = OutputFile::create(fs::path(picture).concat(".rows"), input_files(problem));
  if (!created) return failed(kExitEnvironment, created.error());
  rows.emplace(std::move(*created));
  CsvWriter writer(problem, result_columns(problem), *rows);
  const auto ended = [&] {
    Progress progress(case_stem(problem));
    return run_case(problem, [&](const Row& row) {
      writer.write(row);
      progress.step(row);
    });
  }();
  if (!ended) {
    return tl::unexpected(
        PlotFailure{exit_code(ended.error()), failure_text(problem, ended.error())});
  }
  if (auto closed = rows->close(); !closed) return failed(kExitEnvironment, closed.error());
  return problem.title.empty() ? case_stem(problem) : problem.title;
}

tl::expected<void, PlotFailure> draw(const PlotOptions& options, const fs::path& picture) {
  if (terminal_for(picture, 0).empty()) {
    return failed(kExitBadInput, fmt::format("{}: wanted a picture that ends in .svg, .png or .pdf",
                                             picture.string()));
  }
  const auto pattern = find_template("friction.gp");
  if (!pattern) {
    return failed(kExitEnvironment, "the plot template plots/friction.gp is not installed");
  }
  const std::array<std::string, 1> inputs{options.input};
  auto output = OutputFile::create(picture, inputs);
  if (!output) return failed(kExitEnvironment, output.error());

  fs::path result = options.input;
  std::optional<OutputFile> rows;
  std::string title;
  if (result.extension() != ".csv") {
    auto ran = run_for_plot(options, picture, rows);
    if (!ran) return tl::unexpected(std::move(ran.error()));
    title = *ran;
    result = rows->temporary();
  }
  const auto data = read_plot_data(result, options.input);
  if (!data) {
    const HistoryError& error = data.error();
    const bool input = error.kind == HistoryError::Kind::kInput;
    const std::string line = error.line > 0 ? fmt::format(":{}", error.line) : "";
    return failed(input ? kExitBadInput : kExitEnvironment,
                  fmt::format("{}{}: {}", options.input, line, error.message));
  }
  if (title.empty()) title = data->title.empty() ? result.stem().string() : data->title;

  return draw_script(script(*data, title, picture, output->temporary(), *pattern), picture,
                     *output);
}

}  // namespace

tl::expected<Case, PlotFailure> read_for_plot(const PlotOptions& options) {
  const auto settings = parse_settings(options.settings);
  if (!settings) return failed(kExitBadInput, settings.error());
  ReadCase read = read_case(options.input, {*settings, options.allow_outside});
  if (!read.value || read.diagnostics.has_errors()) {
    return tl::unexpected(PlotFailure{read.environment_failure ? kExitEnvironment : kExitBadInput,
                                      render(read.diagnostics, read.sources) +
                                          summary(read.diagnostics) + ", nothing was drawn\n"});
  }
  return std::move(*read.value);
}

std::vector<std::string> plot_kinds() {
  return {"hysteresis", "history", "bands", "shares", "mu_map", "residuals"};
}

int plot_command(const PlotOptions& options) {
  const fs::path picture =
      options.output.empty()
          ? fs::path(options.input).filename().replace_extension(options.law ? ".law.svg" : ".svg")
          : fs::path(options.output);
  auto drawn = options.law ? draw_laws(options, picture) : draw(options, picture);
  if (!drawn) {
    print_error(drawn.error().message);
    return drawn.error().code;
  }
  print(picture.lexically_normal().string() + "\n");
  return kExitOk;
}

}  // namespace slipbench::driver
