// SPDX-License-Identifier: Apache-2.0
#include "driver/plot/script.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "driver/base/text/format_number.hpp"
#include "driver/plot/picture_mark.hpp"
#include "driver/plot/text_lines.hpp"

namespace slipbench::driver::plot {
namespace fs = std::filesystem;
namespace {

/// Of the title that all layouts have room for, and of a second line of it [px].
constexpr double kHead = 60.0;
constexpr double kTitleLine = 22.0;
/// Letters of the title's size that surely fit into a line.
constexpr std::size_t kTitleLength = 100;

std::vector<std::string> title_lines(const std::string& title) {
  std::vector<std::string> lines = lines_of_length(title, kTitleLength, 2);
  lines.resize(2);
  return lines;
}

double head_height(const std::string& title) {
  return title_lines(title)[1].empty() ? kHead : kHead + kTitleLine;
}

Canvas canvas_for(const Picture& picture, const std::string& title, std::size_t height) {
  return canvas_of(picture.look, static_cast<double>(height) + head_height(title) - kHead);
}

std::string gnuplot_number(double number) {
  return std::isfinite(number) ? base::format_number(number) : "NaN";
}

}  // namespace

tl::expected<Picture, PlotFailure> begin_picture(const fs::path& name, const PlotOptions& options,
                                                 std::string_view pattern) {
  if (terminal_for(name, {}, options.look).empty()) {
    return failed(
        base::kExitBadInput,
        fmt::format("{}: wanted a picture that ends in .svg, .png or .pdf", name.string()));
  }
  auto found = find_template(pattern);
  if (!found || !find_template("style.gp")) {
    return failed(
        base::kExitEnvironment,
        fmt::format("the plot templates plots/{} and plots/style.gp are not installed", pattern));
  }
  std::vector<std::string> inputs = options.more;
  inputs.push_back(options.input);
  const base::FileMark mark = picture_mark(options.more.empty() ? options.input : "several inputs");
  auto output = base::OutputFile::create(name, mark, {inputs, options.force});
  if (!output) return failed(base::kExitEnvironment, output.error());
  return Picture{name, std::move(*found), options.look, std::move(*output)};
}

void PlotScript::set(std::string_view name, std::string_view text) {
  variables_ += fmt::format("{} = {}\n", name, gnuplot_string(text));
}
void PlotScript::set(std::string_view name, double number) {
  variables_ += fmt::format("{} = {}\n", name, gnuplot_number(number));
}
void PlotScript::set(std::string_view name, int number) {
  variables_ += fmt::format("{} = {}\n", name, number);
}

std::vector<std::string>& PlotScript::entries(std::string_view array) {
  return arrays_.try_emplace(std::string(array)).first->second;
}
void PlotScript::add(std::string_view array, std::string_view text) {
  entries(array).push_back(gnuplot_string(text));
}
void PlotScript::add(std::string_view array, double number) {
  entries(array).push_back(gnuplot_number(number));
}
void PlotScript::add(std::string_view array, int number) {
  entries(array).push_back(std::to_string(number));
}

void PlotScript::block(std::string_view name, std::string rows) {
  blocks_.emplace_back(name, std::move(rows));
}

std::string PlotScript::text(const Picture& picture, const std::string& title,
                             std::size_t height) const {
  const auto lines = title_lines(title);
  const Canvas canvas = canvas_for(picture, title, height);
  std::string text = fmt::format(
      "TERMINAL = \"{}\"\nPICTURE = {}\nSTYLE = {}\nTITLE = {}\nTITLE_2 = {}\nHEIGHT = {:.0f}.0\n"
      "HEAD = {:.0f}.0\nDARK = {}\n",
      terminal_for(picture.name, canvas, picture.look),
      gnuplot_string(picture.output.temporary().string()),
      gnuplot_string((picture.pattern.parent_path() / "style.gp").string()),
      gnuplot_string(lines[0]), gnuplot_string(lines[1]), canvas.height, head_height(title),
      picture.look.dark ? 1 : 0);
  text += variables_;
  for (const auto& [name, values] : arrays_) {
    text += fmt::format("array {}[{}]\n", name, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += fmt::format("{}[{}] = {}\n", name, i + 1, values[i]);
    }
  }
  for (const auto& [name, rows] : blocks_) text += fmt::format("${} << END\n{}END\n", name, rows);
  return text + "load " + gnuplot_string(picture.pattern.string()) + "\n";
}

tl::expected<void, PlotFailure> draw(const PlotScript& script, const std::string& title,
                                     std::size_t height, Picture& picture) {
  return draw_script(script.text(picture, title, height), picture.name,
                     canvas_for(picture, title, height).scale, picture.output);
}

}  // namespace slipbench::driver::plot
