// SPDX-License-Identifier: Apache-2.0
#include "driver/commands/plot.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "driver/command_line/declare.hpp"
#include "driver/commands/shared.hpp"
#include "driver/plot/kinds.hpp"

namespace slipbench::driver {

void declare_plot(CLI::App& app, Command& command) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* declared = app.add_subcommand("plot", "Draw a case or a result");
  declared->add_option("CASE|RESULT.csv", options->input, "A case file, or a result of 'run'")
      ->required();
  declared
      ->add_option(
          "-o,--output", options->output,
          "The picture; its ending (.svg, .png, .pdf) says what it is. Default: <case>.svg")
      ->type_name("FILE");
  declared
      ->add_option("--as", options->kind,
                   "One picture only: hysteresis, history, bands, shares, mu_map, residuals")
      ->type_name("KIND")
      ->check(one_of(plot_kinds()));
  declared->add_flag("--law", options->law,
                     "Draw the coefficients of a case over slip rate and pressure");
  declare_settings(*declared, options->settings, options->allow_outside);
  declared->footer(
      "Friction force against time, with its limit and with slip shaded, and against motion.\n"
      "With --law: mu as curves and as a map, with the states that the run visits; the default\n"
      "name is <case>.law.svg.\n"
      "Needs gnuplot. Example: slipbench plot shock.yaml -o shock.png --set mu=0.2");
  declared->callback([options, &command] {
    options->input = named_case(options->input);
    command = [options] { return plot_command(*options); };
  });
}

}  // namespace slipbench::driver
