// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "driver/cli/declare.hpp"
#include "driver/plot/kinds.hpp"

namespace slipbench::driver::cli {

void declare_plot(CLI::App& app, Command& command) {
  const auto options = std::make_shared<plot::PlotOptions>();
  CLI::App* declared = app.add_subcommand("plot", "Draw a case or a result");
  const auto inputs = std::make_shared<std::vector<std::string>>();
  const auto size = std::make_shared<std::string>();
  declared
      ->add_option(
          "CASE|RESULT.csv", *inputs,
          "A case file, or a result of 'run'; several are drawn over each other; - is a case "
          "from standard input")
      ->required();
  declared
      ->add_option(
          "-o,--output", options->output,
          "The picture, or a folder for it; the ending (.svg, .png, .pdf) says what it is. "
          "Default: <case>.svg in the current folder")
      ->type_name("FILE");
  declared
      ->add_option("--as", options->kind,
                   fmt::format("One picture only: {}", fmt::join(plot::plot_kinds(), ", ")))
      ->type_name("KIND")
      ->check(one_of(plot::plot_kinds()));
  declared->add_flag("--law", options->law,
                     "Draw the coefficients of a case over slip rate and pressure, also of one "
                     "that cannot run; or a law of that name with its example's parameters");
  declared
      ->add_option("--x", options->x,
                   "The result column to draw over; default: t, or the motion where nothing is "
                   "said of y")
      ->type_name("COLUMN");
  declared
      ->add_option("--y", options->y,
                   "The result column to draw; default: the friction force. Again for more of the "
                   "same unit")
      ->type_name("COLUMN")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  declared
      ->add_option("--size", *size,
                   "Size in pixels, such as 800x500 (PDF: 100 to an inch); texts scale with it")
      ->type_name("WIDTHxHEIGHT");
  declared
      ->add_option("--dpi", options->look.dpi,
                   "Of .png: so many pixels for each 96 of the size, 192 for twice as fine")
      ->type_name("N")
      ->check(whole_number(24, 1200));
  declared->add_flag("--dark", options->look.dark, "For a dark background");
  declare_settings(*declared, options->settings, options->allow_outside);
  declare_force(*declared, options->force, "no picture of this input");
  declared->footer(
      "Friction force against time, with its limit and with slip shaded, and against motion.\n"
      "Several inputs, --x or --y: their curves over each other in one picture.\n"
      "With --law: mu as curves and as a map, with the states that the run visits; the default\n"
      "name is <case>.law.svg. A map over two arguments of a table is '--as mu_map'.\n"
      "Needs gnuplot. Example: slipbench plot shock.yaml rig.csv --x CU1 --y CSF1 -o both.svg");
  declared->callback([options, inputs, size, &command] {
    name_cases(*inputs);
    options->input = inputs->front();
    options->more.assign(inputs->begin() + 1, inputs->end());
    command = [options, size] { return commands::plot_command(*options, *size); };
  });
}

}  // namespace slipbench::driver::cli
